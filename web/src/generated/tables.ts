// The tables of the core. Written by `LITTLEWOOD_WRITE=1 cargo test -p littlewood-web generated::`; do not edit.

/** What a person can set. */
export const QUANTITIES = [
  'mass_ratio',
  'offset',
  'inertia',
  'mu_s',
  'mu_k',
  'theta',
  'theta_rate',
  'slip',
  'x',
  'time',
  'until',
  'disc_mass_kg',
  'particle_mass_kg',
  'radius_m',
  'offset_m',
  'inertia_kg_m2',
  'gravity_m_per_s2',
  'theta_rate_rad_per_s',
  'slip_m_per_s',
  'x_m',
  'time_s',
  'until_s',
  'restitution',
  'gap_rate',
  'gap_rate_m_per_s',
  'slope',
  'rolling_resistance',
  'rolling_resistance_m',
] as const;
export type Quantity = (typeof QUANTITIES)[number];

/** What a quantity belongs to. */
export const GROUPS = [
  'hoop',
  'start',
  'place',
  'units',
  'run',
] as const;
export type Group = (typeof GROUPS)[number];

export type System = 'dimensionless' | 'si';

export interface QuantityRow {
  group: Group;
  /** The system that a number of this name is in; an angle and a ratio are the same number in both. */
  system: System;
  /** The same quantity in the other system. */
  twin: Quantity | null;
  sign: string;
  unit: string;
  longName: string;
  /** What it is if it is not given. */
  otherwise: number | null;
  /** Range in which a person usually sets it. */
  usual: readonly [number, number];
}

/** The table of quantities. */
export const QUANTITY_ROWS = {
  mass_ratio: { group: 'hoop', system: 'dimensionless', twin: 'disc_mass_kg', sign: 'm₁/m₂', unit: '', longName: 'mass of the disc over mass of the particle', otherwise: null, usual: [0, 5] },
  offset: { group: 'hoop', system: 'dimensionless', twin: 'offset_m', sign: 'ℓ/R', unit: '', longName: 'distance of the particle from the centre over the radius', otherwise: null, usual: [0, 1] },
  inertia: { group: 'hoop', system: 'dimensionless', twin: 'inertia_kg_m2', sign: 'Izz/(m₂R²)', unit: '', longName: 'moment of inertia of the disc about its centre over m2 R^2', otherwise: null, usual: [0, 5] },
  mu_s: { group: 'hoop', system: 'dimensionless', twin: null, sign: 'μₛ', unit: '', longName: 'coefficient of static friction', otherwise: null, usual: [0, 1.5] },
  mu_k: { group: 'hoop', system: 'dimensionless', twin: null, sign: 'μₖ', unit: '', longName: 'coefficient of kinetic friction', otherwise: null, usual: [0, 1.5] },
  theta: { group: 'start', system: 'dimensionless', twin: null, sign: 'θ', unit: 'rad', longName: 'angle of the particle from the upward vertical', otherwise: null, usual: [-3.1, 6.2] },
  theta_rate: { group: 'start', system: 'dimensionless', twin: 'theta_rate_rad_per_s', sign: 'θ′', unit: '√(g/R)', longName: 'rate of the angle', otherwise: null, usual: [-4, 4] },
  slip: { group: 'start', system: 'dimensionless', twin: 'slip_m_per_s', sign: 'η′', unit: '√(gR)', longName: 'slip velocity of the contact point', otherwise: 0, usual: [-2, 2] },
  x: { group: 'place', system: 'dimensionless', twin: 'x_m', sign: 'x', unit: 'R', longName: 'position of the geometric centre along the plane', otherwise: 0, usual: [-10, 10] },
  time: { group: 'place', system: 'dimensionless', twin: 'time_s', sign: 'τ', unit: '√(R/g)', longName: 'time', otherwise: 0, usual: [-10, 10] },
  until: { group: 'run', system: 'dimensionless', twin: 'until_s', sign: 'τ', unit: '√(R/g)', longName: 'time limit', otherwise: null, usual: [0, 50] },
  disc_mass_kg: { group: 'hoop', system: 'si', twin: 'mass_ratio', sign: 'm₁', unit: 'kg', longName: 'mass of the disc or hoop', otherwise: null, usual: [0, 2] },
  particle_mass_kg: { group: 'units', system: 'si', twin: null, sign: 'm₂', unit: 'kg', longName: 'mass of the particle', otherwise: null, usual: [0.01, 2] },
  radius_m: { group: 'units', system: 'si', twin: null, sign: 'R', unit: 'm', longName: 'outer radius', otherwise: null, usual: [0.05, 1] },
  offset_m: { group: 'hoop', system: 'si', twin: 'offset', sign: 'ℓ', unit: 'm', longName: 'distance of the particle from the centre', otherwise: null, usual: [0, 1] },
  inertia_kg_m2: { group: 'hoop', system: 'si', twin: 'inertia', sign: 'Izz', unit: 'kg m²', longName: 'moment of inertia of the disc about its centre', otherwise: null, usual: [0, 0.5] },
  gravity_m_per_s2: { group: 'units', system: 'si', twin: null, sign: 'g', unit: 'm/s²', longName: 'gravitational acceleration', otherwise: 9.80665, usual: [0.5, 25] },
  theta_rate_rad_per_s: { group: 'start', system: 'si', twin: 'theta_rate', sign: 'dθ/dt', unit: 'rad/s', longName: 'rate of the angle', otherwise: null, usual: [-20, 20] },
  slip_m_per_s: { group: 'start', system: 'si', twin: 'slip', sign: 'dη/dt', unit: 'm/s', longName: 'slip velocity of the contact point', otherwise: 0, usual: [-5, 5] },
  x_m: { group: 'place', system: 'si', twin: 'x', sign: 'x', unit: 'm', longName: 'position of the geometric centre along the plane', otherwise: 0, usual: [-10, 10] },
  time_s: { group: 'place', system: 'si', twin: 'time', sign: 't', unit: 's', longName: 'time', otherwise: 0, usual: [-10, 10] },
  until_s: { group: 'run', system: 'si', twin: 'until', sign: 't', unit: 's', longName: 'time limit', otherwise: null, usual: [0, 10] },
  restitution: { group: 'hoop', system: 'dimensionless', twin: null, sign: 'e', unit: '', longName: 'coefficient of restitution', otherwise: null, usual: [0, 1] },
  gap_rate: { group: 'start', system: 'dimensionless', twin: 'gap_rate_m_per_s', sign: 'gap′', unit: '√(gR)', longName: 'rate at which the gap under the rim opens', otherwise: 0, usual: [0, 3] },
  gap_rate_m_per_s: { group: 'start', system: 'si', twin: 'gap_rate', sign: 'd gap/dt', unit: 'm/s', longName: 'rate at which the gap under the rim opens', otherwise: 0, usual: [0, 5] },
  slope: { group: 'hoop', system: 'dimensionless', twin: null, sign: 'α', unit: 'rad', longName: 'angle by which the plane rises to the right', otherwise: 0, usual: [-1, 1] },
  rolling_resistance: { group: 'hoop', system: 'dimensionless', twin: 'rolling_resistance_m', sign: 'χ', unit: '', longName: 'coefficient of rolling resistance over the radius', otherwise: 0, usual: [0, 0.2] },
  rolling_resistance_m: { group: 'hoop', system: 'si', twin: 'rolling_resistance', sign: 'χ', unit: 'm', longName: 'coefficient of rolling resistance', otherwise: 0, usual: [0, 0.1] },
} as const satisfies Record<Quantity, QuantityRow>;

/** The numbers of a problem without dimension, in the order in which the core takes them. */
export const DIMENSIONLESS = [
  'mass_ratio',
  'offset',
  'inertia',
  'mu_s',
  'mu_k',
  'rolling_resistance',
  'slope',
  'theta',
  'theta_rate',
  'slip',
  'gap_rate',
  'x',
  'time',
] as const;
export type DimensionlessNumber = (typeof DIMENSIONLESS)[number];

/** The numbers of a problem in SI units, in the order in which the core takes them. */
export const SI = [
  'disc_mass_kg',
  'particle_mass_kg',
  'radius_m',
  'offset_m',
  'inertia_kg_m2',
  'gravity_m_per_s2',
  'mu_s',
  'mu_k',
  'rolling_resistance_m',
  'slope',
  'theta',
  'theta_rate_rad_per_s',
  'slip_m_per_s',
  'gap_rate_m_per_s',
  'x_m',
  'time_s',
] as const;
export type SiNumber = (typeof SI)[number];

/** The columns of a sample, in the order in which the core gives them. */
export const SAMPLE_COLUMNS = [
  'time',
  'mode',
  'direction',
  'theta',
  'theta_rate',
  'slip',
  'x',
  'theta_acceleration',
  'slip_acceleration',
  'normal',
  'friction',
  'couple',
  'gap',
  'gap_rate',
  'energy',
  'centre_y',
  'mass_centre_x',
  'mass_centre_y',
  'particle_x',
  'particle_y',
] as const;
export type SampleColumn = (typeof SAMPLE_COLUMNS)[number];

export interface ColumnRow {
  longName: string;
  signs: Readonly<Record<System, string>>;
  /** Empty for an angle without dimension, and for a code. */
  units: Readonly<Record<System, string>>;
}

/** The table of columns. */
export const COLUMN_ROWS = {
  time: { longName: 'time', signs: { dimensionless: 'τ', si: 't' }, units: { dimensionless: '√(R/g)', si: 's' } },
  mode: { longName: 'mode of motion', signs: { dimensionless: '', si: '' }, units: { dimensionless: '', si: '' } },
  direction: { longName: 'sign of the slip velocity; 0 for rolling, rest and flight', signs: { dimensionless: 'σ', si: 'σ' }, units: { dimensionless: '', si: '' } },
  theta: { longName: 'angle of the particle from the upward vertical', signs: { dimensionless: 'θ', si: 'θ' }, units: { dimensionless: '', si: 'rad' } },
  theta_rate: { longName: 'rate of the angle', signs: { dimensionless: 'θ′', si: 'dθ/dt' }, units: { dimensionless: '√(g/R)', si: 'rad/s' } },
  slip: { longName: 'slip velocity of the contact point', signs: { dimensionless: 'η′', si: 'dη/dt' }, units: { dimensionless: '√(gR)', si: 'm/s' } },
  x: { longName: 'position of the geometric centre along the plane', signs: { dimensionless: 'x', si: 'x' }, units: { dimensionless: 'R', si: 'm' } },
  theta_acceleration: { longName: 'angular acceleration', signs: { dimensionless: 'θ″', si: 'θ″' }, units: { dimensionless: 'g/R', si: 'rad/s²' } },
  slip_acceleration: { longName: 'acceleration of the slip', signs: { dimensionless: 'η″', si: 'η″' }, units: { dimensionless: 'g', si: 'm/s²' } },
  normal: { longName: 'normal force', signs: { dimensionless: 'N', si: 'N' }, units: { dimensionless: 'm₂g', si: 'N' } },
  friction: { longName: 'friction force', signs: { dimensionless: 'F', si: 'F' }, units: { dimensionless: 'm₂g', si: 'N' } },
  couple: { longName: 'couple of rolling resistance', signs: { dimensionless: 'M', si: 'M' }, units: { dimensionless: 'm₂gR', si: 'N m' } },
  gap: { longName: 'distance of the rim from the plane', signs: { dimensionless: 'gap', si: 'gap' }, units: { dimensionless: 'R', si: 'm' } },
  gap_rate: { longName: 'rate of the gap', signs: { dimensionless: 'gap′', si: 'd gap/dt' }, units: { dimensionless: '√(gR)', si: 'm/s' } },
  energy: { longName: 'kinetic and potential energy', signs: { dimensionless: 'E', si: 'E' }, units: { dimensionless: 'm₂gR', si: 'J' } },
  centre_y: { longName: 'distance of the geometric centre from the plane', signs: { dimensionless: 'y', si: 'y' }, units: { dimensionless: 'R', si: 'm' } },
  mass_centre_x: { longName: 'position of the mass centre along the plane', signs: { dimensionless: 'x̄', si: 'x̄' }, units: { dimensionless: 'R', si: 'm' } },
  mass_centre_y: { longName: 'distance of the mass centre from the plane', signs: { dimensionless: 'ȳ', si: 'ȳ' }, units: { dimensionless: 'R', si: 'm' } },
  particle_x: { longName: 'position of the particle along the plane', signs: { dimensionless: 'x₂', si: 'x₂' }, units: { dimensionless: 'R', si: 'm' } },
  particle_y: { longName: 'distance of the particle from the plane', signs: { dimensionless: 'y₂', si: 'y₂' }, units: { dimensionless: 'R', si: 'm' } },
} as const satisfies Record<SampleColumn, ColumnRow>;

/** Those of a state, in the order in which the core gives them. */
export const STATE_COLUMNS = [
  'time',
  'theta',
  'theta_rate',
  'slip',
  'x',
] as const;
export type StateColumn = (typeof STATE_COLUMNS)[number];

/** Modes of motion. Arrays hold a mode as its place in this list. */
export const MODES = [
  'rolling',
  'sliding',
  'gliding',
  'flight',
  'rest',
  'skidding',
] as const;
export type Mode = (typeof MODES)[number];

/** What ends a phase. */
export const CAUSES = [
  'slip',
  'normal_force_zero',
  'stick',
  'reversal',
  'graze',
  'lift_off',
  'landing',
  'particle_at_plane',
  'particle_at_bottom',
  'particle_at_top',
  'singularity',
  'settle',
  'jam',
  'turning_point',
] as const;
export type Cause = (typeof CAUSES)[number];

/** In words. */
export const CAUSE_LABELS = {
  slip: 'slip',
  normal_force_zero: 'N = 0',
  stick: 'stick',
  reversal: 'reversal',
  graze: 'graze',
  lift_off: 'lift-off',
  landing: 'landing',
  particle_at_plane: 'particle at the plane',
  particle_at_bottom: 'particle at the bottom',
  particle_at_top: 'particle at the top',
  singularity: 'P = 0',
  settle: 'settles',
  jam: 'jam',
  turning_point: 'turning point',
} as const satisfies Record<Cause, string>;

/** How a motion ends. */
export const OUTCOMES = [
  'landing',
  'rolls_forever',
  'slides_forever',
  'particle_at_plane',
  'particle_at_bottom',
  'particle_at_top',
  'time_limit',
  'transition_limit',
  'inconsistent',
  'ambiguous',
  'singular',
  'unresolved',
  'step_limit',
  'slips_forever',
  'repeats_forever',
  'stays_in_contact',
  'rests',
  'not_computed',
  'invalid',
] as const;
export type OutcomeKind = (typeof OUTCOMES)[number];

export interface OutcomeRow {
  label: string;
  /** Whether the last phase lasts for ever. */
  forever: boolean;
  /** The event that is this outcome, if there is one. */
  lastEvent: Cause | null;
}

/** The table of outcomes. */
export const OUTCOME_ROWS = {
  landing: { label: 'lands', forever: false, lastEvent: 'landing' },
  rolls_forever: { label: 'rolls for ever', forever: true, lastEvent: null },
  slides_forever: { label: 'slides for ever', forever: true, lastEvent: null },
  particle_at_plane: { label: 'particle at the plane', forever: false, lastEvent: 'particle_at_plane' },
  particle_at_bottom: { label: 'particle at the bottom', forever: false, lastEvent: 'particle_at_bottom' },
  particle_at_top: { label: 'particle at the top', forever: false, lastEvent: 'particle_at_top' },
  time_limit: { label: 'time limit', forever: false, lastEvent: null },
  transition_limit: { label: 'transition limit', forever: false, lastEvent: null },
  inconsistent: { label: 'no motion is consistent', forever: false, lastEvent: null },
  ambiguous: { label: 'several motions are consistent', forever: false, lastEvent: null },
  singular: { label: 'sliding is not solvable', forever: false, lastEvent: 'singularity' },
  unresolved: { label: 'unresolved', forever: false, lastEvent: null },
  step_limit: { label: 'step limit', forever: false, lastEvent: null },
  slips_forever: { label: 'slips for ever', forever: false, lastEvent: null },
  repeats_forever: { label: 'repeats for ever', forever: false, lastEvent: null },
  stays_in_contact: { label: 'stays in contact', forever: false, lastEvent: null },
  rests: { label: 'rests', forever: true, lastEvent: null },
  not_computed: { label: 'not computed', forever: false, lastEvent: null },
  invalid: { label: 'invalid parameters', forever: false, lastEvent: null },
} as const satisfies Record<OutcomeKind, OutcomeRow>;

/** Classes of outcomes. Maps hold a class as its place in this list. */
export const CLASSES = [
  'leaves_at_once',
  'lifts_off_later',
  'rolls_forever',
  'repeats_forever',
  'slips_forever',
  'in_contact',
  'particle_at_plane',
  'particle_at_bottom',
  'particle_at_top',
  'painleve',
  'unresolved',
  'invalid',
  'not_computed',
  'rests',
] as const;
export type Class = (typeof CLASSES)[number];

/** In words. */
export const CLASS_LABELS = {
  leaves_at_once: 'leaves at once',
  lifts_off_later: 'lifts off later',
  rolls_forever: 'rolls for ever',
  repeats_forever: 'repeats for ever',
  slips_forever: 'slips for ever',
  in_contact: 'in contact',
  particle_at_plane: 'particle at the plane',
  particle_at_bottom: 'particle at the bottom',
  particle_at_top: 'particle at the top',
  painleve: 'Painlevé paradox',
  unresolved: 'unresolved',
  invalid: 'invalid parameters',
  not_computed: 'not computed',
  rests: 'rests',
} as const satisfies Record<Class, string>;

/** Those of motions that stay in contact. */
export const CLASSES_IN_CONTACT: readonly Class[] = ['rolls_forever', 'repeats_forever', 'slips_forever', 'in_contact', 'rests'];

/** Laws of restitution. The first is that of a coefficient alone. */
export const LAWS = [
  'energetic',
  'poisson',
  'newton',
] as const;
export type Law = (typeof LAWS)[number];

/** In words. */
export const LAW_LABELS = {
  energetic: 'energetic (Stronge)',
  poisson: 'impulses (Poisson)',
  newton: 'velocities (Newton)',
} as const satisfies Record<Law, string>;

/** What the contact point does in an impact. */
export const IMPACT_CASES = [
  'none',
  'slides',
  'sticks_in_compression',
  'reverses_in_compression',
  'sticks_in_restitution',
  'reverses_in_restitution',
  'jams',
] as const;
export type ImpactCase = (typeof IMPACT_CASES)[number];

/** In words. */
export const IMPACT_CASE_LABELS = {
  none: 'no impulse',
  slides: 'slides',
  sticks_in_compression: 'sticks in compression',
  reverses_in_compression: 'reverses in compression',
  sticks_in_restitution: 'sticks in restitution',
  reverses_in_restitution: 'reverses in restitution',
  jams: 'jams',
} as const satisfies Record<ImpactCase, string>;

/** The unit of an impulse. */
export const IMPULSE_UNITS = {
  dimensionless: 'm₂√(gR)',
  si: 'N s',
} as const satisfies Record<System, string>;

/** What a link says of the page. */
export const VIEW_KEYS = [
  'rate',
  'speed',
  'slow',
  'loop',
  'map',
  'shows',
  'follow',
  'symbols',
  'level',
  'embed',
  'theme',
] as const;
export type ViewKey = (typeof VIEW_KEYS)[number];

/** What it may say. */
export const VIEW_CHOICES = {
  rate: ['1', '1.5', '2', '3', '4', '6', '8', '12', '20'],
  speed: ['0.1', '0.25', '0.5', '1', '2', '4'],
  slow: ['0', '1'],
  loop: ['0', '1'],
  map: ['0', '1'],
  shows: ['outcome', 'hops'],
  follow: ['0', '1'],
  symbols: ['0', '1'],
  level: ['auto', 'simple', 'full'],
  embed: ['0', '1'],
  theme: ['auto', 'light', 'dark'],
} as const satisfies Record<ViewKey, readonly string[]>;

/** What it says at first. */
export const VIEW_FIRST = {
  rate: '4',
  speed: '0.5',
  slow: '0',
  loop: '0',
  map: '1',
  shows: 'outcome',
  follow: '1',
  symbols: '1',
  level: 'auto',
  embed: '0',
  theme: 'auto',
} as const satisfies Record<ViewKey, string>;

/** What a core of the same version says of the order of names. */
export const BOUNDARY = 'mass_ratio offset inertia mu_s mu_k rolling_resistance slope theta theta_rate slip gap_rate x time; disc_mass_kg particle_mass_kg radius_m offset_m inertia_kg_m2 gravity_m_per_s2 mu_s mu_k rolling_resistance_m slope theta theta_rate_rad_per_s slip_m_per_s gap_rate_m_per_s x_m time_s; time mode direction theta theta_rate slip x theta_acceleration slip_acceleration normal friction couple gap gap_rate energy centre_y mass_centre_x mass_centre_y particle_x particle_y; rolling sliding gliding flight rest skidding; leaves_at_once lifts_off_later rolls_forever repeats_forever slips_forever in_contact particle_at_plane particle_at_bottom particle_at_top painleve unresolved invalid not_computed rests';
