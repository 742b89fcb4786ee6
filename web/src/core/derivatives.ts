// What the derivatives of a motion say: what moves an event, and where a landing of another motion
// is predicted. Nothing as long as the later part of the core is not there.

import { type Quantity, STATE_COLUMNS, type StateColumn } from '../generated/tables';
import { type ProblemState, problemIn } from '../state/state';
import type { Prediction } from '../wasm/later/littlewood_web.js';
import { later } from './later';
import type { Event } from './motion';

/** What a small change of a quantity moves an event by, in the units of the problem; a reason where there is no derivative. */
export interface Move {
  quantity: Quantity;
  change: number;
  moved: number | null;
  reason: string | null;
}

/** What moves a number of an event: the largest move first, and a sentence on it. */
export interface Moves {
  rows: Move[];
  sentence: string;
}

/** A landing that is predicted to first order, and the flight before it. */
export interface Ghost {
  time: number;
  theta: number;
  x: number;
  /** x and height of the mass centre, in turn. */
  path: Float64Array;
}

export type { Prediction };

/** What moves a number of an event; none without a transition. */
export function movesOf(
  problem: ProblemState,
  { transition }: Event,
  column: StateColumn,
): Moves | null {
  const core = later();
  if (core === null || transition === null) return null;
  const own = problemIn(core.Problem, problem);
  const found = core.Moves.of(own, transition);
  own.free();
  if (found === undefined) return null;
  const place = STATE_COLUMNS.indexOf(column);
  const moves = { rows: JSON.parse(found.rows(place)) as Move[], sentence: found.sentence(place) };
  found.free();
  return moves;
}

/** What the derivatives predict of a landing of other motions. */
export function predictionOf(problem: ProblemState, { transition }: Event): Prediction | null {
  const core = later();
  if (core === null || transition === null) return null;
  const own = problemIn(core.Problem, problem);
  const prediction = core.Prediction.ofLanding(own, transition);
  own.free();
  return prediction ?? null;
}

/** What a prediction says of a problem: a ghost, or why there is none. */
export function ghostOf(prediction: Prediction, problem: ProblemState): Ghost | string | null {
  const core = later();
  if (core === null) return null;
  const own = problemIn(core.Problem, problem);
  const found = prediction.of(own);
  own.free();
  const [time = NaN, theta = NaN, , , x = NaN] = found.landing();
  const ghost = found.reason() ?? { time, theta, x, path: found.path() };
  found.free();
  return ghost;
}
