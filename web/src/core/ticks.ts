// Ticks of axes, those of all pictures of the core.

import { Ticks } from './wasm';

export interface Tick {
  value: number;
  label: string;
}

/** Ticks at round numbers from `a` to `b` > `a`, at most about `most` of them. */
export function roundTicks(a: number, b: number, most: number): Tick[] {
  return listOf(Ticks.round(a, b, most));
}

/** Ticks at multiples of a fraction of π. */
export function angularTicks(a: number, b: number, most: number): Tick[] {
  return listOf(Ticks.angular(a, b, most));
}

function listOf(ticks: Ticks): Tick[] {
  const labels = ticks.labels();
  const list = Array.from(ticks.values(), (value, i) => ({ value, label: labels[i]! }));
  ticks.free();
  return list;
}
