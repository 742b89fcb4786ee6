// The messages between the page and the worker of the map. The first is the compiled core, which
// the page has already.

import type { Shows } from '../state/state';

interface PlaneRequest {
  /** Dimensionless numbers of the problem. */
  numbers: Float64Array;
  rate: number;
  side: number;
  /** Which of the rows, or blocks of rows, the worker computes: every `of`-th from `part`. */
  part: number;
  of: number;
}

export interface MapRequest extends PlaneRequest {
  restitution: number | undefined;
  law: string | undefined;
  shows: Shows;
  /** Tells the answers to one request from those to an older one. */
  id: number;
}

/** Asks for the events of the motions of all starts of a plane. */
export type EventsRequest = PlaneRequest;

/** Numbers of each start among its events: its class, and the times of its first slip, its lift-off and its end. */
export const EVENT_NUMBERS = 4;

/** Rows of a block, those of the coarsest level: a block is computed by one worker at every level. */
export const BLOCK = 16;

/** The worker that computes a row of a map. */
export function partOf(row: number, side: number, isFolded: boolean, of: number): number {
  const computed = isFolded && row >= side / 2 ? side - 1 - row : row;
  return Math.floor(computed / BLOCK) % of;
}

export type MapQuestion =
  | { kind: 'core'; module: WebAssembly.Module }
  | { kind: 'map'; request: MapRequest }
  | { kind: 'events'; request: EventsRequest };

export type MapAnswer =
  | { kind: 'ready' }
  | {
      kind: 'level';
      id: number;
      shows: Shows;
      classes: Uint8Array;
      part: number;
      /** Whether the lower half of the map is the upper one turned by half a turn. */
      isFolded: boolean;
      stride: number;
      milliseconds: number;
      last: boolean;
    }
  | { kind: 'events'; row: number; events: Float64Array }
  | { kind: 'failed'; message: string };
