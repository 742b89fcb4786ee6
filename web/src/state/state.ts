// The state of the page: everything that a link carries.

import { fieldsOf, type System } from '../core/fields';

export type Theme = 'auto' | 'light' | 'dark';

export interface ProblemState {
  system: System;
  /** In the order of the fields of the system. */
  numbers: number[];
  /** Time limit in the units of the system; none to follow the motion to its end. */
  until: number | null;
}

export interface ViewState {
  /** Time of the cursor, τ; none at the start. */
  time: number | null;
  speed: number;
  loop: boolean;
  /** Largest |θ′| of the plane. */
  rate: number;
  map: boolean;
  follow: boolean;
  theme: Theme;
}

export interface State {
  problem: ProblemState;
  view: ViewState;
}

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;
export const RATES = [1, 1.5, 2, 3, 4, 6, 8, 12, 20] as const;

export const VIEW: Readonly<ViewState> = {
  time: null, speed: 0.5, loop: false, rate: 4, map: true, follow: true, theme: 'auto',
};

/** A case of the core. */
export interface NamedCase {
  name: string;
  title: string;
  source: string;
  hoop: Record<string, number>;
  start: Record<string, number>;
}

/** The problem of a case. */
export function problemOfCase(named: NamedCase): ProblemState {
  const values = { ...named.hoop, ...named.start };
  return {
    system: 'dimensionless',
    numbers: fieldsOf('dimensionless').map((field) => values[field.name] ?? 0),
    until: null,
  };
}

/** The case that a problem is, number by number; none if it differs. */
export function caseOfProblem(problem: ProblemState, cases: readonly NamedCase[]): NamedCase | null {
  if (problem.system !== 'dimensionless' || problem.until !== null) return null;
  return cases.find((named) => problemOfCase(named).numbers.every((it, i) => Object.is(it, problem.numbers[i]))) ?? null;
}

/** The rate that shows a problem well: massless hoops live below θ′ = 1. */
export function rateFor(massless: boolean, rate: number): number {
  const least = massless ? 1.5 : 4;
  return RATES.find((it) => it >= least && it >= 1.1 * Math.abs(rate)) ?? RATES[RATES.length - 1]!;
}
