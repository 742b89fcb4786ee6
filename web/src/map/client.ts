// The outcome map as a picture, refined by a worker while nothing else happens.

import { classNames } from '../core/wasm';
import type { Palette } from '../views/palette';
import type { MapAnswer, MapRequest } from './messages';

/** Starts each way of the finest level. */
const SIDE = 512;

/** How long a hoop must stand before its map is computed, so that a slider that is dragged does not compute many. */
const PAUSE = 40;

export class OutcomePicture {
  readonly picture = document.createElement('canvas');
  readonly side = SIDE;
  /** Names of the classes in the picture, the most frequent first. */
  present: string[] = [];
  private readonly worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  private readonly names = classNames();
  private classes: Uint8Array | null = null;
  private colours: Uint32Array;
  private id = 0;
  private timer = 0;

  constructor(palette: Palette, private readonly drawn: () => void, failed: (message: string) => void) {
    this.picture.width = SIDE;
    this.picture.height = SIDE;
    this.colours = this.coloursOf(palette);
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
    this.colours = this.coloursOf(palette);
    this.paint();
  }

  private coloursOf(palette: Palette): Uint32Array {
    const probe = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    return Uint32Array.from(this.names, (name) => {
      if (!probe) return 0;
      probe.fillStyle = palette.classOf(name);
      probe.fillRect(0, 0, 1, 1);
      return new Uint32Array(probe.getImageData(0, 0, 1, 1).data.buffer)[0] ?? 0;
    });
  }

  private paint(): void {
    const context = this.picture.getContext('2d');
    if (!this.classes || !context) return;
    const image = context.createImageData(SIDE, SIDE);
    const pixels = new Uint32Array(image.data.buffer);
    const counts = new Array<number>(this.names.length).fill(0);
    for (let i = 0; i < pixels.length; i++) {
      const it = this.classes[i]!;
      pixels[i] = this.colours[it]!;
      counts[it]! += 1;
    }
    context.putImageData(image, 0, 0);
    const order = this.names.map((_, i) => i).filter((i) => counts[i]! > 0);
    this.present = order.sort((a, b) => counts[b]! - counts[a]!).map((i) => this.names[i]!);
    this.drawn();
  }
}
