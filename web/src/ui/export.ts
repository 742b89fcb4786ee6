// Data and pictures to keep.

import type { Palette } from '../generated/palette';
import type { Lab } from '../state/lab';
import { FONT } from '../views/font';
import { drawPlots } from '../views/plots-sheet';
import { VectorContext } from '../views/vector';

export type View = 'hoop' | 'plane' | 'plots' | 'impact';

/** How to draw a view on a context of a size. */
export type Painter = (c: CanvasRenderingContext2D, width: number, height: number) => void;

/** The same of an instant. */
export type PainterAt = (
  c: CanvasRenderingContext2D,
  width: number,
  height: number,
  time: number,
) => void;

const SIZES: Record<View, [number, number]> = {
  hoop: [900, 600],
  plane: [900, 600],
  plots: [900, 1000],
  impact: [900, 600],
};

/** Points of the plots in a picture. */
const POINTS = 2000;

/** The size of films. */
const FILM = [720, 480] as const;

/** A film of the hoop. Where this browser cannot make it the reason is thrown. */
export async function filmOf(
  format: 'gif' | 'mp4',
  lab: Lab,
  paint: PainterAt,
  palette: Palette,
  progress: (part: number) => void,
): Promise<Blob> {
  const { gifOf, LONGEST, mp4Codec, mp4Of } = await import('./film');
  const [width, height] = FILM;
  const { motion, units, state } = lab;
  const span = motion.end - motion.begin;
  const seconds = Math.min((span * units.time) / state.view.speed, LONGEST);
  const reel = {
    width,
    height,
    seconds,
    progress,
    draw: (c: CanvasRenderingContext2D, part: number): void => {
      c.fillStyle = palette.ink.paper;
      c.fillRect(0, 0, width, height);
      paint(c, width, height, motion.begin + part * span);
    },
  };
  if (format === 'gif') return gifOf(reel);
  const codec = await mp4Codec(width, height);
  if (codec === null) throw new Error('this browser does not encode video; take the GIF');
  return mp4Of(reel, codec);
}

export function save(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export function painterOfPlots(lab: Lab, palette: Palette): Painter {
  const samples = lab.motion.sample(POINTS);
  const {
    motion,
    time,
    units,
    pinned,
    state: {
      problem: { system },
    },
  } = lab;
  return (c, width, height) =>
    drawPlots(
      c,
      { width, height },
      {
        motion,
        samples,
        palette,
        time,
        units,
        system,
        pinned: pinned?.motion ?? null,
        available: lab.plain.mu_s,
      },
    );
}

/** A view as SVG: drawn by the code that draws it on the screen. */
export function svgOf(view: View, paint: Painter, palette: Palette): string {
  const [width, height] = SIZES[view];
  const context = new VectorContext(width, height);
  context.fillStyle = palette.ink.paper;
  context.fillRect(0, 0, width, height);
  context.font = `14px ${FONT}`;
  paint(context as unknown as CanvasRenderingContext2D, width, height);
  return context.toString();
}

/** A view as PNG, twice as fine as it is large. */
export function pngOf(view: View, paint: Painter, palette: Palette): Promise<Blob> {
  const [width, height] = SIZES[view];
  const canvas = document.createElement('canvas');
  canvas.width = 2 * width;
  canvas.height = 2 * height;
  const context = canvas.getContext('2d');
  if (!context) return Promise.reject(new Error('this browser has no canvas'));
  context.scale(2, 2);
  context.fillStyle = palette.ink.paper;
  context.fillRect(0, 0, width, height);
  paint(context, width, height);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be made'))),
      'image/png',
    );
  });
}
