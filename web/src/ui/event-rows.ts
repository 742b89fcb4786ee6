// Which events the table shows: of many bounces the first and the last.

import type { Event } from '../core/motion';

/** Bounces that are shown one by one before the others are folded. */
const FIRST = 3;

/** Fewer than these are not worth folding. */
const LEAST = 4;

/** Events one after the other that are shown, or folded into one row. */
export interface Run {
  events: readonly Event[];
  isFolded: boolean;
}

/** The events in runs; without any folding if all are wanted. */
export function runsOf(events: readonly Event[], all: boolean): Run[] {
  const runs: Run[] = [];
  for (let from = 0; from < events.length; ) {
    let to = from;
    while (to < events.length && isBounce(events[to]!)) to++;
    const hidden = to - from - FIRST - 1;
    if (all || hidden < LEAST) {
      to = Math.max(to, from + 1);
      runs.push({ events: events.slice(from, to), isFolded: false });
    } else {
      runs.push({ events: events.slice(from, from + FIRST), isFolded: false },
        { events: events.slice(from + FIRST, to - 1), isFolded: true },
        { events: events.slice(to - 1, to), isFolded: false });
    }
    from = to;
  }
  return runs;
}

/** A landing after which the hoop flies again. */
function isBounce({ name, to }: Event): boolean {
  return name === 'landing' && to === 'flight';
}
