// All starts of a plane, let go at the same instant: what becomes of each, and when. Workers follow
// the motions.

import type { Palette } from '../generated/palette';
import { CLASSES, type Class } from '../generated/tables';
import { startCrew } from './crew';
import { EVENT_NUMBERS, type EventsRequest, type MapQuestion } from './messages';
import { mixed, pixelOf } from './pixels';

/** What a start does whose end has not come. */
export const DOINGS = ['rolls', 'has_slipped', 'flies'] as const;
export type Doing = (typeof DOINGS)[number];

/** How many starts do something at a time, and how many have come to an end of a class. */
export interface Counts {
  doing: Readonly<Record<Doing, number>>;
  classes: Readonly<Record<Class, number>>;
}

/** The part of the paper in the colour of what still moves on the plane. */
const PALE = 0.55;

/** The pixels of what a start does. */
export function colourOf(doing: Doing, palette: Palette): number {
  const { rolling, sliding, flight } = palette.mode;
  if (doing === 'flies') return pixelOf(flight);
  return mixed(doing === 'rolls' ? rolling : sliding, palette.ink.paper, PALE);
}

export class Release {
  readonly picture = document.createElement('canvas');
  /** Rows that have been followed. */
  rows = 0;
  private readonly classes: Uint8Array;
  private readonly slips: Float64Array;
  private readonly liftOffs: Float64Array;
  private readonly ends: Float64Array;
  private readonly image: ImageData;
  private readonly pixels: Uint32Array;

  /** `side` starts each way, the angle from −π to π, and rates below `rate`. */
  constructor(
    readonly side: number,
    readonly rate: number,
    private readonly changed: () => void,
  ) {
    const count = side * side;
    this.classes = new Uint8Array(count).fill(CLASSES.indexOf('not_computed'));
    [this.slips, this.liftOffs, this.ends] = [NaN, NaN, NaN].map((it) =>
      new Float64Array(count).fill(it),
    ) as [Float64Array, Float64Array, Float64Array];
    [this.picture.width, this.picture.height] = [side, side];
    this.image = new ImageData(side, side);
    this.pixels = new Uint32Array(this.image.data.buffer);
  }

  get isComplete(): boolean {
    return this.rows === this.side;
  }

  /** Lets workers follow the motions. They are let go when all are known. */
  follow(numbers: Float64Array, failed: (message: string) => void): void {
    const { side, rate } = this;
    const workers = startCrew((answer) => {
      if (answer.kind !== 'events') return;
      this.take(answer.row, answer.events);
      if (this.isComplete) for (const worker of workers) worker.terminate();
      this.changed();
    }, failed);
    const of = workers.length;
    workers.forEach((worker, part) => {
      const request: EventsRequest = { numbers, rate, side, part, of };
      worker.postMessage({ kind: 'events', request } satisfies MapQuestion);
    });
  }

  private take(row: number, events: Float64Array): void {
    for (let column = 0; column < this.side; column++) {
      const [code = NaN, slip = NaN, liftOff = NaN, end = NaN] = events.subarray(
        EVENT_NUMBERS * column,
        EVENT_NUMBERS * (column + 1),
      );
      const cell = row * this.side + column;
      this.classes[cell] = code;
      this.slips[cell] = slip;
      this.liftOffs[cell] = liftOff;
      this.ends[cell] = end;
    }
    this.rows += 1;
  }

  /** The start in the middle of a cell. */
  startOf(column: number, row: number): { theta: number; theta_rate: number } {
    const part = (i: number): number => (2 * i + 1 - this.side) / this.side;
    return { theta: Math.PI * part(column), theta_rate: -this.rate * part(row) };
  }

  classOf(column: number, row: number): Class {
    return CLASSES[this.classes[row * this.side + column]!]!;
  }

  /** Classes that some have in the end. */
  get present(): Class[] {
    const codes = new Set(this.classes);
    return CLASSES.filter((_, code) => codes.has(code));
  }

  /** The time by which so much of the motions have come to their end. */
  timeOf(part: number): number {
    const ends = this.ends.slice().sort();
    return ends[Math.min(Math.floor(part * ends.length), ends.length - 1)] ?? 0;
  }

  /** Paints what each start does at a time. */
  paint(time: number, palette: Palette): Counts {
    const { classes, slips, liftOffs, ends, pixels } = this;
    const ofClass = CLASSES.map((it) => pixelOf(palette.class[it]));
    const ofDoing = DOINGS.map((it) => colourOf(it, palette));
    const doing = new Uint32Array(DOINGS.length);
    const ended = new Uint32Array(CLASSES.length);
    for (let cell = 0; cell < pixels.length; cell++) {
      // Comparisons with NaN, an event that does not come, are false.
      if (ends[cell]! <= time) {
        const code = classes[cell]!;
        ended[code]! += 1;
        pixels[cell] = ofClass[code]!;
      } else {
        const code = liftOffs[cell]! <= time ? 2 : slips[cell]! <= time ? 1 : 0;
        doing[code]! += 1;
        pixels[cell] = ofDoing[code]!;
      }
    }
    this.picture.getContext('2d')?.putImageData(this.image, 0, 0);
    return { doing: counted(DOINGS, doing), classes: counted(CLASSES, ended) };
  }
}

function counted<N extends string>(names: readonly N[], counts: Uint32Array): Record<N, number> {
  return Object.fromEntries(names.map((name, i) => [name, counts[i]])) as Record<N, number>;
}
