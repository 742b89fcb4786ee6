// The state of the page: everything that a link carries.

import { inOrder, LIMIT, numbersOf, type Values } from '../core/fields';
import type { Quantity, System } from '../generated/tables';

export type Theme = 'auto' | 'light' | 'dark';

interface ProblemIn<S extends System> {
  readonly system: S;
  readonly values: Values<S>;
  /** Time limit in the units of the system; none to follow the motion to its end. */
  readonly until: number | null;
}

export type ProblemState = ProblemIn<'dimensionless'> | ProblemIn<'si'>;

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

/** A problem with a value for each number of its system. */
export function problemWith(system: System, value: (quantity: Quantity) => number, until: number | null): ProblemState {
  const values = Object.fromEntries(numbersOf(system).map((name) => [name, value(name)]));
  return { system, values, until } as unknown as ProblemState;
}

/** The value of a quantity of a problem; none for a limit that is not set, and for a quantity of the other system. */
export function valueOf({ system, values, until }: ProblemState, quantity: Quantity): number | null {
  if (quantity === LIMIT[system]) return until;
  const numbers: Readonly<Partial<Record<Quantity, number>>> = values;
  return numbers[quantity] ?? null;
}

/** The numbers of a problem in the order of the core. */
export function numbersOfProblem(problem: ProblemState): Float64Array {
  return problem.system === 'si' ? inOrder('si', problem.values) : inOrder('dimensionless', problem.values);
}

/** A case of the core. */
export interface NamedCase {
  name: string;
  title: string;
  source: string;
  hoop: Record<string, number>;
  start: Record<string, number>;
}

/** The problem of a case. */
export function problemOfCase({ name, hoop, start }: NamedCase): ProblemState {
  const values = { ...hoop, ...start };
  const value = (quantity: Quantity): number => {
    const number = values[quantity];
    if (number === undefined) throw new Error(`the case ${name} has no ${quantity}`);
    return number;
  };
  return problemWith('dimensionless', value, null);
}

/** The case that a problem is, number by number; none if it differs. */
export function caseOfProblem(problem: ProblemState, cases: readonly NamedCase[]): NamedCase | null {
  if (problem.system !== 'dimensionless' || problem.until !== null) return null;
  const same = (other: ProblemState): boolean =>
    numbersOf('dimensionless').every((name) => Object.is(valueOf(other, name), valueOf(problem, name)));
  return cases.find((named) => same(problemOfCase(named))) ?? null;
}

/** The rate that shows a problem well: massless hoops live below θ′ = 1. */
export function rateFor(massless: boolean, rate: number): number {
  const least = massless ? 1.5 : 4;
  return RATES.find((it) => it >= least && it >= 1.1 * Math.abs(rate)) ?? RATES[RATES.length - 1]!;
}
