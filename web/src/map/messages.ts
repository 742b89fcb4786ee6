// The messages between the page and the worker of the map. The first is the compiled core, which the page has already.

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

export type MapQuestion = { kind: 'core'; module: WebAssembly.Module } | { kind: 'map'; request: MapRequest };

export type MapAnswer =
  | { kind: 'ready' }
  | {
      kind: 'level';
      id: number;
      shows: Shows;
      classes: Uint8Array;
      hopClasses: Uint8Array;
      side: number;
      stride: number;
      milliseconds: number;
      last: boolean;
    }
  | { kind: 'failed'; message: string };
