// The outcome map as a picture, refined by workers while nothing else happens.

import { hopClasses } from '../core/wasm';
import type { Palette } from '../generated/palette';
import { CLASSES, type Class } from '../generated/tables';
import type { Shows } from '../state/state';
import { startCrew, WORKERS } from './crew';
import { type MapAnswer, type MapQuestion, type MapRequest, partOf } from './messages';
import { pixelOf } from './pixels';

/** Starts each way of the finest level. */
const SIDE = 512;

/** Motions with some numbers of landings, and the place of their colour in the palette. */
export interface HopClass {
  least: number;
  most: number;
  colour: number;
}

/**
 * Milliseconds for which a newer hoop waits for the map of an older one to be as fine as it is while a slider moves. One worker is
 * slower than a hand, and is interrupted sooner.
 */
const PATIENCE = WORKERS > 1 ? 100 : 40;

/** The level that is fine enough. */
const FINE = 2;

type LevelAnswer = Extract<MapAnswer, { kind: 'level' }>;

export class OutcomePicture {
  readonly picture = document.createElement('canvas');
  readonly side = SIDE;
  /** The classes of outcomes in the picture, in the order of their table. */
  present: Class[] = [];
  /** The classes of landings in the picture, the fewest first. */
  hops: HopClass[] = [];
  /** Made when a map is first asked for. */
  private workers: Worker[] = [];
  /** The levels of the map that is computed, until all workers have sent them. */
  private levels = new Map<number, LevelAnswer[]>();
  /** When the work on it began; none where it is fine enough. */
  private begun: number | null = null;
  /** What is asked for next. */
  private wanted: Omit<MapRequest, 'side' | 'id' | 'part' | 'of'> | null = null;
  private classes: Uint8Array | null = null;
  private shows: Shows = 'outcome';
  private palette: Palette;
  private id = 0;
  private timer = 0;

  constructor(
    palette: Palette,
    private readonly drawn: () => void,
    private readonly failed: (message: string) => void,
  ) {
    this.picture.width = SIDE;
    this.picture.height = SIDE;
    this.palette = palette;
  }

  /** Takes a level of a worker, and shows it with those of the others. */
  private take(answer: LevelAnswer): void {
    const { stride, shows, isFolded, last } = answer;
    const parts = [...(this.levels.get(stride) ?? []), answer];
    this.levels.set(stride, parts);
    if (parts.length < this.workers.length) return;
    this.levels.delete(stride);
    const classes = parts[0]!.classes;
    for (let row = 0; row < SIDE && parts.length > 1; row++) {
      const wanted = partOf(row, SIDE, isFolded, parts.length);
      const from = parts.find(({ part }) => part === wanted)!.classes;
      if (from !== classes) classes.set(from.subarray(row * SIDE, (row + 1) * SIDE), row * SIDE);
    }
    this.classes = classes;
    this.shows = shows;
    this.hops = shows === 'hops' ? hopClassesOf(hopClasses(classes), this.palette.hops.length) : [];
    this.paint();
    // For the benchmark, which reads them from outside.
    performance.mark(`map-${stride}`, {
      detail: Math.max(...parts.map(({ milliseconds }) => milliseconds)),
    });
    if (this.wanted === null) document.documentElement.dataset.map = last ? 'done' : String(stride);
    if (stride > FINE) return;
    this.begun = null;
    this.send();
  }

  /** Asks for a map. The old one stays until the first level of the new one is there. */
  ask(wanted: Omit<MapRequest, 'side' | 'id' | 'part' | 'of'>): void {
    document.documentElement.dataset.map = 'asked';
    this.wanted = wanted;
    window.clearTimeout(this.timer);
    const wait = this.begun === null ? 0 : this.begun + PATIENCE - performance.now();
    if (wait > 0) this.timer = window.setTimeout(() => this.send(), wait);
    else this.send();
  }

  private send(): void {
    const { wanted } = this;
    if (wanted === null) return;
    window.clearTimeout(this.timer);
    this.wanted = null;
    this.begun = performance.now();
    this.levels.clear();
    this.id += 1;
    if (this.workers.length === 0)
      this.workers = startCrew((answer) => {
        if (answer.kind === 'level' && answer.id === this.id) this.take(answer);
      }, this.failed);
    const of = this.workers.length;
    this.workers.forEach((worker, part) => {
      const request: MapRequest = { ...wanted, side: SIDE, id: this.id, part, of };
      worker.postMessage({ kind: 'map', request } satisfies MapQuestion);
    });
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.paint();
  }

  private paint(): void {
    const context = this.picture.getContext('2d');
    if (!this.classes || !context) return;
    const image = context.createImageData(SIDE, SIDE);
    const pixels = new Uint32Array(image.data.buffer);
    const colours =
      this.shows === 'outcome'
        ? Uint32Array.from(CLASSES, (it) => pixelOf(this.palette.class[it]))
        : this.hopColours();
    const counts = new Uint32Array(256);
    for (let i = 0; i < pixels.length; i++) {
      const it = this.classes[i]!;
      pixels[i] = colours[it]!;
      counts[it]! += 1;
    }
    context.putImageData(image, 0, 0);
    this.present = this.shows === 'outcome' ? CLASSES.filter((_, i) => counts[i]! > 0) : [];
    this.drawn();
  }

  /** The pixel of each number of landings. */
  private hopColours(): Uint32Array {
    const { hops, ink } = this.palette;
    return Uint32Array.from({ length: 256 }, (_, landings) => {
      const found = this.hops.find(({ least, most }) => least <= landings && landings <= most);
      return pixelOf(found === undefined ? ink.paper : hops[found.colour]!);
    });
  }
}

/** The classes of landings of a map, their colours as far apart as there are. The palest is for no landing. */
function hopClassesOf(bounds: Uint8Array, colours: number): HopClass[] {
  const count = bounds.length / 2;
  const first = bounds[0] === 0 ? 0 : 1;
  return Array.from({ length: count }, (_, i) => ({
    least: bounds[2 * i]!,
    most: bounds[2 * i + 1]!,
    colour: count === 1 ? first : Math.round(first + ((colours - 1 - first) * i) / (count - 1)),
  }));
}
