// The outcome map as a picture, refined by a worker while nothing else happens.

import { coreModule } from '../core/module';
import type { Palette } from '../generated/palette';
import { CLASSES, type Class } from '../generated/tables';
import type { Shows } from '../state/state';
import type { MapAnswer, MapQuestion, MapRequest } from './messages';
import { spawn } from './spawn';

/** Starts each way of the finest level. */
const SIDE = 512;

/** Motions with some numbers of landings, and the place of their colour in the palette. */
export interface HopClass {
  least: number;
  most: number;
  colour: number;
}

/** How long a hoop must stand before its map is computed, so that a slider that is dragged does not compute many. */
const PAUSE = 40;

export class OutcomePicture {
  readonly picture = document.createElement('canvas');
  readonly side = SIDE;
  /** The classes of outcomes in the picture, the most frequent first. */
  present: Class[] = [];
  /** The classes of landings in the picture, the fewest first. */
  hops: HopClass[] = [];
  /** Made when a map is first asked for. */
  private worker: Worker | null = null;
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

  private start(): Worker {
    const worker = spawn();
    worker.onmessage = ({ data }: MessageEvent<MapAnswer>) => {
      if (data.kind === 'failed') this.failed(data.message);
      else if (data.kind === 'level' && data.id === this.id) {
        this.classes = data.classes;
        this.shows = data.shows;
        this.hops = hopClassesOf(data.hopClasses, this.palette.hops.length);
        this.paint();
        // For the benchmark, which reads them from outside.
        performance.mark(`map-${data.stride}`, { detail: data.milliseconds });
        document.documentElement.dataset.map = data.last ? 'done' : String(data.stride);
      }
    };
    worker.onerror = (event) => this.failed(event.message);
    coreModule().then(
      (module) => worker.postMessage({ kind: 'core', module } satisfies MapQuestion),
      (error: unknown) => this.failed(String(error)),
    );
    return worker;
  }

  /** Asks for a map. The old one stays until the first level of the new one is there. */
  ask(wanted: Omit<MapRequest, 'side' | 'id'>): void {
    window.clearTimeout(this.timer);
    document.documentElement.dataset.map = 'asked';
    this.id += 1;
    const request: MapRequest = { ...wanted, side: SIDE, id: this.id };
    this.timer = window.setTimeout(() => {
      this.worker ??= this.start();
      this.worker.postMessage({ kind: 'map', request } satisfies MapQuestion);
    }, PAUSE);
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
    const colours = this.shows === 'outcome' ? coloursOf(CLASSES.map((it) => this.palette.class[it])) : this.hopColours();
    const counts = new Uint32Array(256);
    for (let i = 0; i < pixels.length; i++) {
      const it = this.classes[i]!;
      pixels[i] = colours[it]!;
      counts[it]! += 1;
    }
    context.putImageData(image, 0, 0);
    const order = CLASSES.map((_, i) => i)
      .filter((i) => counts[i]! > 0)
      .sort((a, b) => counts[b]! - counts[a]!);
    this.present = this.shows === 'outcome' ? order.map((i) => CLASSES[i]!) : [];
    this.drawn();
  }

  /** The pixel of each number of landings. */
  private hopColours(): Uint32Array {
    const { hops, ink } = this.palette;
    return coloursOf(
      Array.from({ length: 256 }, (_, landings) => {
        const found = this.hops.find(({ least, most }) => least <= landings && landings <= most);
        return found === undefined ? ink.paper : hops[found.colour]!;
      }),
    );
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

/** Colours as an image holds its pixels. */
function coloursOf(colours: readonly string[]): Uint32Array {
  return Uint32Array.from(colours, (colour) => {
    const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    return new Uint32Array(Uint8Array.of(red!, green!, blue!, 255).buffer)[0]!;
  });
}
