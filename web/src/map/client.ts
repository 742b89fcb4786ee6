// The outcome map as a picture, refined by a worker while nothing else happens.

import type { Palette } from '../generated/palette';
import { CLASSES, type Class } from '../generated/tables';
import type { MapAnswer, MapRequest } from './messages';

/** Starts each way of the finest level. */
const SIDE = 512;

/** How long a hoop must stand before its map is computed, so that a slider that is dragged does not compute many. */
const PAUSE = 40;

export class OutcomePicture {
  readonly picture = document.createElement('canvas');
  readonly side = SIDE;
  /** The classes in the picture, the most frequent first. */
  present: Class[] = [];
  private readonly worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  private classes: Uint8Array | null = null;
  private colours: Uint32Array;
  private id = 0;
  private timer = 0;

  constructor(palette: Palette, private readonly drawn: () => void, failed: (message: string) => void) {
    this.picture.width = SIDE;
    this.picture.height = SIDE;
    this.colours = coloursOf(palette);
    this.worker.onmessage = ({ data }: MessageEvent<MapAnswer>) => {
      if (data.kind === 'failed') failed(data.message);
      else if (data.kind === 'level' && data.id === this.id) {
        this.classes = data.classes;
        this.paint();
        // For the benchmark, which reads them from outside.
        performance.mark(`map-${data.stride}`, { detail: data.milliseconds });
        document.documentElement.dataset['map'] = data.last ? 'done' : String(data.stride);
      }
    };
    this.worker.onerror = (event) => failed(event.message);
  }

  /** Asks for the map of a hoop. The old one stays until the first level of the new one is there. */
  ask(numbers: Float64Array, rate: number): void {
    window.clearTimeout(this.timer);
    document.documentElement.dataset['map'] = 'asked';
    this.id += 1;
    const request: MapRequest = { numbers, rate, side: SIDE, id: this.id };
    this.timer = window.setTimeout(() => this.worker.postMessage(request), PAUSE);
  }

  setPalette(palette: Palette): void {
    this.colours = coloursOf(palette);
    this.paint();
  }

  private paint(): void {
    const context = this.picture.getContext('2d');
    if (!this.classes || !context) return;
    const image = context.createImageData(SIDE, SIDE);
    const pixels = new Uint32Array(image.data.buffer);
    const counts = CLASSES.map(() => 0);
    for (let i = 0; i < pixels.length; i++) {
      const it = this.classes[i]!;
      pixels[i] = this.colours[it]!;
      counts[it]! += 1;
    }
    context.putImageData(image, 0, 0);
    const order = CLASSES.map((_, i) => i).filter((i) => counts[i]! > 0);
    this.present = order.sort((a, b) => counts[b]! - counts[a]!).map((i) => CLASSES[i]!);
    this.drawn();
  }
}

/** The pixel of each class, as an image holds it. */
function coloursOf(palette: Palette): Uint32Array {
  return Uint32Array.from(CLASSES, (name) => {
    const [red, green, blue] = [1, 3, 5].map((at) => parseInt(palette.class[name].slice(at, at + 2), 16));
    return new Uint32Array(Uint8Array.of(red!, green!, blue!, 255).buffer)[0]!;
  });
}
