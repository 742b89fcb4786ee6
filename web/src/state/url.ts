// The state as the fragment of an address, and back. The core reads and writes it, for the page as
// for Python.

import { readLink, writeLink } from '../core/wasm';
import { type Law, type Quantity, type System, VIEW_KEYS, type ViewKey } from '../generated/tables';
import {
  lawOf,
  numbersOfProblem,
  type ProblemState,
  problemWith,
  type State,
  textsOf,
  VIEW,
  viewOf,
} from './state';

export interface FieldError {
  /** The field, or the key of the address. */
  field: string;
  /** What was given. */
  given: string;
  message: string;
}

export interface Parsed {
  state: State;
  fieldErrors: FieldError[];
}

/** What the core says of a link. A number that is missing is null. */
interface Said {
  system: System;
  values: Partial<Record<Quantity, number | null>>;
  restitution: number | null;
  law: Law | null;
  until: number | null;
  at: number | null;
  view: Record<ViewKey, string>;
  errors: FieldError[];
}

/** The fragment for a state, without `#`. */
export function format({ problem, view }: State): string {
  const texts = textsOf(view);
  return writeLink(
    problem.system === 'si',
    numbersOfProblem(problem),
    problem.restitution,
    lawOf(problem),
    problem.until,
    view.time,
    VIEW_KEYS.map((key) => texts[key]),
  );
}

/**
 * Reads a fragment. What it does not say stays as in `base`, or is that of the first case; what cannot be read is reported
 * and stays, too.
 */
export function parse(fragment: string, base: State | null = null): Parsed {
  const shown = base === null ? '' : format(base);
  const { system, values, errors, at, view, ...options } = JSON.parse(
    readLink(fragment, shown),
  ) as Said;
  const problem = problemWith(system, (quantity) => values[quantity] ?? NaN, options);
  return { state: { problem, view: { ...viewOf(view), time: at } }, fieldErrors: errors };
}

/** The name of the case that a problem is, to the last bit; none if it is none. */
export function caseOf(problem: ProblemState): string | null {
  return /^case=(.*)$/.exec(format({ problem, view: VIEW }))?.[1] ?? null;
}
