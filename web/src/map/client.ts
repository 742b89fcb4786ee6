// The outcome map as a picture, refined by a worker while nothing else happens.

import type { Palette } from '../generated/palette';
import { CLASSES, HOPS, type Class, type Hops } from '../generated/tables';
import type { Shows } from '../state/state';
import type { MapAnswer, MapRequest } from './messages';

/** Starts each way of the finest level. */
const SIDE = 512;

/** How long a hoop must stand before its map is computed, so that a slider that is dragged does not compute many. */
const PAUSE = 40;

export class OutcomePicture {
  readonly picture = document.createElement('canvas');
  readonly side = SIDE;
  /** The classes of outcomes in the picture, the most frequent first. */
  present: Class[] = [];
  /** The classes of landings in the picture, the fewest first. */
  landings: Hops[] = [];
  private readonly worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  private classes: Uint8Array | null = null;
  private shows: Shows = 'outcome';
  private palette: Palette;
  private id = 0;
  private timer = 0;

  constructor(palette: Palette, private readonly drawn: () => void, failed: (message: string) => void) {
    this.picture.width = SIDE;
    this.picture.height = SIDE;
    this.palette = palette;
    this.worker.onmessage = ({ data }: MessageEvent<MapAnswer>) => {
      if (data.kind === 'failed') failed(data.message);
      else if (data.kind === 'level' && data.id === this.id) {
        this.classes = data.classes;
        this.shows = data.shows;
        this.paint();
        // For the benchmark, which reads them from outside.
        performance.mark(`map-${data.stride}`, { detail: data.milliseconds });
        document.documentElement.dataset['map'] = data.last ? 'done' : String(data.stride);
      }
    };
    this.worker.onerror = (event) => failed(event.message);
  }

  /** Asks for a map. The old one stays until the first level of the new one is there. */
  ask(wanted: Omit<MapRequest, 'side' | 'id'>): void {
    window.clearTimeout(this.timer);
    document.documentElement.dataset['map'] = 'asked';
    this.id += 1;
    const request: MapRequest = { ...wanted, side: SIDE, id: this.id };
    this.timer = window.setTimeout(() => this.worker.postMessage(request), PAUSE);
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
    const colours = coloursOf(this.palette, this.shows);
    const counts = new Uint32Array(256);
    for (let i = 0; i < pixels.length; i++) {
      const it = this.classes[i]!;
      pixels[i] = colours[it]!;
      counts[it]! += 1;
    }
    context.putImageData(image, 0, 0);
    const found = <T>(list: readonly T[]): number[] => list.map((_, i) => i).filter((i) => counts[i]! > 0);
    const isOutcome = this.shows === 'outcome';
    this.present = isOutcome ? found(CLASSES).sort((a, b) => counts[b]! - counts[a]!).map((i) => CLASSES[i]!) : [];
    this.landings = isOutcome ? [] : found(HOPS).map((i) => HOPS[i]!);
    this.drawn();
  }
}

/** The pixel of each class, as an image holds it. The last of the landings is that of a start that is not computed. */
function coloursOf(palette: Palette, shows: Shows): Uint32Array {
  const colours = shows === 'outcome' ? CLASSES.map((name) => palette.class[name]) : [...palette.hops, palette.ink.paper];
  return Uint32Array.from(colours, (colour) => {
    const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    return new Uint32Array(Uint8Array.of(red!, green!, blue!, 255).buffer)[0]!;
  });
}
