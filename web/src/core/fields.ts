// The quantities that a person sets, in both systems of units, with what each means.

export type System = 'dimensionless' | 'si';

export interface Field {
  /** Name in addresses, files and flags. */
  name: string;
  label: string;
  unit: string;
  /** What it means, for the tip. */
  meaning: string;
  /** Range of the slider; a number that is typed may lie beyond. */
  min: number;
  max: number;
  step: number;
  group: 'hoop' | 'start' | 'place' | 'units';
  /** Whether there is a slider. */
  slider: boolean;
}

const angle: Omit<Field, 'name'> = {
  label: 'θ', unit: 'rad', group: 'start', min: -3.14, max: 6.28, step: 0.01, slider: true,
  meaning: 'Angle of the particle from the upward vertical, counterclockwise.',
};
const muS: Field = {
  name: 'mu_s', label: 'μs', unit: '', group: 'hoop', min: 0, max: 1.5, step: 0.01, slider: true,
  meaning: 'Coefficient of static friction: the hoop rolls while |F| ≤ μs N (2.13).',
};
const muK: Field = {
  name: 'mu_k', label: 'μk', unit: '', group: 'hoop', min: 0, max: 1.5, step: 0.01, slider: true,
  meaning: 'Coefficient of kinetic friction: while it slips |F| = μk N (2.15). Never above μs.',
};

const DIMENSIONLESS: Field[] = [
  { name: 'mass_ratio', label: 'm₁/m₂', unit: '', group: 'hoop', min: 0, max: 5, step: 0.01, slider: true,
    meaning: 'Mass of the hoop over that of the particle.' },
  { name: 'offset', label: 'ℓ/R', unit: '', group: 'hoop', min: 0, max: 1, step: 0.01, slider: true,
    meaning: 'Distance of the particle from the centre over the radius: 1 on the rim.' },
  { name: 'inertia', label: 'I/(m₂R²)', unit: '', group: 'hoop', min: 0, max: 5, step: 0.01, slider: true,
    meaning: 'Moment of inertia of the hoop about its centre: m₁/m₂ for a thin hoop, half of that for a uniform disc.' },
  muS,
  muK,
  { name: 'theta', ...angle },
  { name: 'theta_rate', label: 'θ′', unit: '√(g/R)', group: 'start', min: -4, max: 4, step: 0.01, slider: true,
    meaning: 'Rate of turning. A hoop that rolls to the right has θ′ < 0.' },
  { name: 'slip', label: 'η′', unit: '√(gR)', group: 'start', min: -2, max: 2, step: 0.01, slider: true,
    meaning: 'Slip velocity of the contact point (2.7); 0 to let friction decide.' },
  { name: 'x', label: 'x', unit: 'R', group: 'place', min: -10, max: 10, step: 0.1, slider: false,
    meaning: 'Where the centre is at the start. No motion depends on it.' },
  { name: 'time', label: 'τ', unit: '√(R/g)', group: 'place', min: -10, max: 10, step: 0.1, slider: false,
    meaning: 'Time of the start. No motion depends on it.' },
];

const SI: Field[] = [
  { name: 'disc_mass_kg', label: 'm₁', unit: 'kg', group: 'hoop', min: 0, max: 2, step: 0.01, slider: true,
    meaning: 'Mass of the hoop.' },
  { name: 'particle_mass_kg', label: 'm₂', unit: 'kg', group: 'hoop', min: 0.01, max: 2, step: 0.01, slider: true,
    meaning: 'Mass of the particle.' },
  { name: 'radius_m', label: 'R', unit: 'm', group: 'hoop', min: 0.05, max: 1, step: 0.01, slider: true,
    meaning: 'Outer radius of the hoop.' },
  { name: 'offset_m', label: 'ℓ', unit: 'm', group: 'hoop', min: 0, max: 1, step: 0.01, slider: true,
    meaning: 'Distance of the particle from the centre, at most R.' },
  { name: 'inertia_kg_m2', label: 'I', unit: 'kg m²', group: 'hoop', min: 0, max: 0.5, step: 0.001, slider: true,
    meaning: 'Moment of inertia of the hoop about its centre: m₁R² for a thin hoop, half of that for a uniform disc.' },
  { name: 'gravity_m_per_s2', label: 'g', unit: 'm/s²', group: 'hoop', min: 0.5, max: 25, step: 0.01, slider: false,
    meaning: 'Gravitational acceleration.' },
  muS,
  muK,
  { name: 'theta', ...angle },
  { name: 'theta_rate_rad_per_s', label: 'dθ/dt', unit: 'rad/s', group: 'start', min: -20, max: 20, step: 0.01,
    slider: true, meaning: 'Rate of turning. A hoop that rolls to the right turns with dθ/dt < 0.' },
  { name: 'slip_m_per_s', label: 'dη/dt', unit: 'm/s', group: 'start', min: -5, max: 5, step: 0.01, slider: true,
    meaning: 'Slip velocity of the contact point; 0 to let friction decide.' },
  { name: 'x_m', label: 'x', unit: 'm', group: 'place', min: -10, max: 10, step: 0.1, slider: false,
    meaning: 'Where the centre is at the start. No motion depends on it.' },
  { name: 'time_s', label: 't', unit: 's', group: 'place', min: -10, max: 10, step: 0.1, slider: false,
    meaning: 'Time of the start. No motion depends on it.' },
];

/** The fields of a system, in the order in which the core takes their numbers. */
export function fieldsOf(system: System): readonly Field[] {
  return system === 'si' ? SI : DIMENSIONLESS;
}

/** Place of a quantity among the numbers of a system. */
export function indexOf(system: System, name: string): number {
  return fieldsOf(system).findIndex((field) => field.name === name);
}

/** Name of the field of a time limit. */
export function untilName(system: System): 'until' | 'until_s' {
  return system === 'si' ? 'until_s' : 'until';
}

/** The field that a message of the core is about, which may speak of the dimensionless quantity. */
export function fieldOfQuantity(system: System, quantity: string): string {
  if (system === 'dimensionless') return quantity;
  const twins: Record<string, string> = {
    mass_ratio: 'disc_mass_kg', offset: 'offset_m', inertia: 'inertia_kg_m2', theta_rate: 'theta_rate_rad_per_s',
    slip: 'slip_m_per_s', x: 'x_m', time: 'time_s', until: 'until_s',
  };
  return twins[quantity] ?? quantity;
}
