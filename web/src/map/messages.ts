// The messages between the page and the worker of the map.

import type { Shows } from '../state/state';

export interface MapRequest {
  /** Dimensionless numbers of the problem. */
  numbers: Float64Array;
  restitution: number | undefined;
  law: string | undefined;
  shows: Shows;
  rate: number;
  side: number;
  /** Tells the answers to one request from those to an older one. */
  id: number;
}

export type MapAnswer =
  | { kind: 'ready' }
  | { kind: 'level'; id: number; shows: Shows; classes: Uint8Array; hopClasses: Uint8Array; side: number;
    stride: number; milliseconds: number; last: boolean }
  | { kind: 'failed'; message: string };
