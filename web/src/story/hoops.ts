// The hoops of the story, their motions, and their links into the laboratory.

import type { Values } from '../core/fields';
import { inOrder, numbersOf, valuesOf } from '../core/fields';
import { Motion, type Sample } from '../core/motion';
import { Plane, Problem } from '../core/wasm';
import type { DimensionlessNumber, Law } from '../generated/tables';
import { VIEW, type ViewState } from '../state/state';
import { format } from '../state/url';

export type Hoop = Values<'dimensionless'>;

/** What a motion may have besides its numbers. */
export interface Run {
  restitution?: number;
  until?: number;
}

const STILL: Hoop = {
  ...valuesOf('dimensionless', new Float64Array(numbersOf('dimensionless').length)),
  offset: 1,
  mu_s: 0.5,
  mu_k: 0.4,
};

/** A hoop without mass that carries a weight on its rim: Littlewood's. With other numbers, another one. */
export function hoopWith(values: Partial<Record<DimensionlessNumber, number>> = {}): Hoop {
  return { ...STILL, ...values };
}

/** A thin hoop whose mass is a part of that of the weight on its rim. */
export function thinHoop(
  ratio: number,
  values: Partial<Record<DimensionlessNumber, number>> = {},
): Hoop {
  return hoopWith({ mass_ratio: ratio, inertia: ratio, ...values });
}

/** The hoop that hops in the story: a quarter of the mass of its weight. */
export function storyHoop(
  push: number,
  values: Partial<Record<DimensionlessNumber, number>> = {},
): Hoop {
  return thinHoop(0.25, { theta_rate: -push, ...values });
}

/** The start of Figure 7 of the paper, mirrored so that the hoop rolls to the right. */
export const FIGURE_7: Partial<Hoop> = { theta_rate: -0.5, mu_s: 0.5, mu_k: 0.4 };

/** The disc with a rod of films on ramps, released from rest: a disc of twice the mass of the rod. */
export function rampDisc(slope: number, theta: number): Hoop {
  return hoopWith({ mass_ratio: 2, offset: 0.8, inertia: 1, mu_s: 1, mu_k: 1, slope, theta });
}

/** The loaded disc that climbs, released from rest. */
export function climbingDisc(slope: number, theta: number): Hoop {
  return hoopWith({ mass_ratio: 1, offset: 0.8, inertia: 0.5, mu_s: 0.8, mu_k: 0.6, slope, theta });
}

/** A light hoop that slips where much friction jams it. */
export function jammingHoop(mu: number): Hoop {
  return thinHoop(0.125, { mu_s: mu, mu_k: mu, theta: 0.5, theta_rate: -0.5, slip: 1 });
}

/** Samples of a motion on a slope. */
const SLOPE_SAMPLES = 120;

export function problemOf(hoop: Hoop, { restitution, until }: Run = {}): Problem {
  return Problem.dimensionless(inOrder('dimensionless', hoop), restitution, undefined, until);
}

/** The motion of a problem, and its h. */
export function motionOf(hoop: Hoop, run: Run = {}): { motion: Motion; h: number } {
  const problem = problemOf(hoop, run);
  // Rolling on a slope is followed from its beginning for each sample.
  const found = {
    motion: Motion.of(problem, null, hoop.slope === 0 ? undefined : SLOPE_SAMPLES),
    h: problem.h,
  };
  problem.free();
  return found;
}

/** Address of a motion in the laboratory. */
export function linkTo(
  hoop: Hoop,
  { restitution, until }: Run = {},
  view: Partial<ViewState> = {},
): string {
  const law: Law | null = null;
  const problem = {
    system: 'dimensionless',
    values: hoop,
    restitution: restitution ?? null,
    law,
    until: until ?? null,
  } as const;
  return `./index.html#${format({ problem, view: { ...VIEW, ...view } })}`;
}

/** Rolling on one level of the energy, be it possible or not. */
export class Rolling {
  private readonly plane: Plane;
  private readonly energy: number;

  constructor(hoop: Hoop) {
    const problem = problemOf(hoop);
    this.plane = new Plane(problem, -Math.PI, Math.PI, 1);
    problem.free();
    this.energy = this.plane.energy(hoop.theta, hoop.theta_rate);
  }

  /** The rate at which the hoop passes an angle, clockwise. */
  rate(theta: number): number {
    const still = this.plane.energy(theta, 0);
    return -Math.sqrt(Math.max(0, this.energy - still) / (this.plane.energy(theta, 1) - still));
  }

  /** Normal force and friction that rolling needs at an angle. */
  forces(theta: number): { normal: number; friction: number } {
    const [normal = NaN, friction = NaN] = this.plane.forces(theta, this.rate(theta));
    return { normal, friction };
  }
}

/** The largest value of a column among the samples of a motion. */
export function most(motion: Motion, column: keyof Sample): number {
  let largest = -Infinity;
  for (const value of motion.samples[column]) if (value > largest) largest = value;
  return largest;
}

/** How far the rim slips along the plane from one time to another, over R: η = x + θ stays as it is while it rolls. */
export function slipped(motion: Motion, from: number, to: number): number {
  const { samples } = motion;
  const slip = (i: number): number => samples.x[i]! + samples.theta[i]!;
  let sum = 0;
  for (let i = 1; i < samples.length; i++) {
    if (samples.time[i - 1]! >= from && samples.time[i]! <= to)
      sum += Math.abs(slip(i) - slip(i - 1));
  }
  return sum;
}
