// Materials of the rim and the plane: coefficients of friction and of restitution, with where they
// are from.

/** Where a number is from. */
interface Source {
  /** As a list of literature has it. */
  cite: string;
  /** What was measured, if that is not a rim on a plane of these materials. */
  of?: string;
}

export interface Material {
  name: string;
  label: string;
  mu_s: number;
  mu_k: number;
  restitution: number;
  /** Whether the numbers are from different samples, or from surfaces that are not described. */
  isIndicative: boolean;
  friction: Source;
  impact: Source;
}

const OPENSTAX: Source = {
  cite: 'S. J. Ling, J. Sanny and W. Moebs, University Physics, volume 1, OpenStax 2016, table 6.1',
};

const SERWAY: Source = {
  cite: 'R. A. Serway and J. W. Jewett, Physics for Scientists and Engineers, table 5.1',
};

const NEWTON: Source = {
  cite: 'I. Newton, Principia, 1687, scholium to the laws of motion',
  of: 'balls of glass, 15 to 16',
};

const factbook = (of: string): Source => ({
  cite: 'Coefficients of Restitution, The Physics Factbook (ed. G. Elert), 2006',
  of: `${of} on a hard surface`,
});

const foerster = (of: string): Source => ({
  cite: 'S. F. Foerster, M. Y. Louge, H. Chang and K. Allia, Phys. Fluids 6, 1108 (1994)',
  of: `spheres of ${of}, polished`,
});

/** The table of materials. */
export const MATERIALS: readonly Material[] = [
  {
    name: 'steel',
    label: 'steel on steel, dry',
    mu_s: 0.6,
    mu_k: 0.3,
    restitution: 0.6,
    isIndicative: true,
    friction: OPENSTAX,
    impact: factbook('a steel ball'),
  },
  {
    name: 'wood',
    label: 'wood on wood',
    mu_s: 0.5,
    mu_k: 0.3,
    restitution: 0.6,
    isIndicative: true,
    friction: OPENSTAX,
    impact: factbook('a wooden ball'),
  },
  {
    name: 'rubber',
    label: 'rubber on dry concrete',
    mu_s: 1,
    mu_k: 0.7,
    restitution: 0.83,
    isIndicative: true,
    friction: OPENSTAX,
    impact: factbook('a ball of rubber bands'),
  },
  {
    name: 'glass',
    label: 'glass on glass',
    mu_s: 0.94,
    mu_k: 0.4,
    restitution: 0.9375,
    isIndicative: true,
    friction: SERWAY,
    impact: NEWTON,
  },
  {
    name: 'beads',
    label: 'polished glass, in impacts',
    mu_s: 0.092,
    mu_k: 0.092,
    restitution: 0.97,
    isIndicative: false,
    friction: foerster('soda-lime glass'),
    impact: foerster('soda-lime glass'),
  },
  {
    name: 'acetate',
    label: 'cellulose acetate, in impacts',
    mu_s: 0.25,
    mu_k: 0.25,
    restitution: 0.87,
    isIndicative: false,
    friction: foerster('cellulose acetate'),
    impact: foerster('cellulose acetate'),
  },
];

/** Where the numbers of a material are from, and what they are worth. */
export function sourceOf({ friction, impact, isIndicative }: Material): string {
  const text = ({ cite, of }: Source): string => (of === undefined ? cite : `${of}: ${cite}`);
  const sources =
    friction.cite === impact.cite
      ? `μ and e: ${text(impact)}.`
      : `μ: ${text(friction)}. e: ${text(impact)}.`;
  return isIndicative
    ? `Indicative only: other surfaces and speeds give other values. ${sources}`
    : sources;
}
