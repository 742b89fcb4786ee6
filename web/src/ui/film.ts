// Films of a motion, GIF and MP4. Loaded when one is asked for.

import { applyPalette, GIFEncoder, quantize } from 'gifenc';
import { ArrayBufferTarget, Muxer } from 'mp4-muxer';

/** What is filmed. */
export interface Reel {
  /** Even, as films need them. */
  width: number;
  height: number;
  /** Seconds of the film. */
  seconds: number;
  /** Draws the instant at this part of it, 0 to 1. */
  draw(c: CanvasRenderingContext2D, part: number): void;
  /** Is told which part of the frames is done. */
  progress(part: number): void;
}

/** Seconds of a film at most: a motion that lasts longer passes faster. */
export const LONGEST = 20;

/** Frames a second; those of a GIF last a whole number of hundredths. */
const GIF_RATE = 20;
const MP4_RATE = 30;

/** Instants, in parts of the film, that choose the colours of a GIF, and how many those are. */
const COLOUR_PARTS = [0, 0.35, 0.7, 1];
const COLOURS = 128;

/** Encodings of MP4, the one that plays anywhere first, with the name that the container has for them. */
const CODECS = [
  ['avc1.42e01f', 'avc'],
  ['av01.0.05M.08', 'av1'],
  ['vp09.00.31.08', 'vp9'],
] as const;

const BITS_A_SECOND = 3_000_000;

/** Frames between two that are whole. */
const KEY = 60;

/** Whether this browser can write MP4. */
export async function mp4Codec(width: number, height: number): Promise<Codec | null> {
  if (!('VideoEncoder' in window)) return null;
  for (const [codec, name] of CODECS) {
    const config = { codec, width, height, bitrate: BITS_A_SECOND, framerate: MP4_RATE };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({
      supported: false,
    }));
    if (supported === true) return { config, name };
  }
  return null;
}

export interface Codec {
  config: VideoEncoderConfig;
  name: (typeof CODECS)[number][1];
}

/** A canvas for the frames. */
function sheetOf({ width, height }: Reel): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  return context;
}

/** Draws the frames one by one. The page lives on in between. */
async function eachFrame(
  reel: Reel,
  rate: number,
  take: (c: CanvasRenderingContext2D, frame: number) => Promise<void> | void,
): Promise<void> {
  const c = sheetOf(reel);
  const last = Math.max(1, Math.round(reel.seconds * rate));
  for (let frame = 0; frame <= last; frame++) {
    reel.draw(c, frame / last);
    await take(c, frame);
    reel.progress(frame / last);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

export async function gifOf(reel: Reel): Promise<Blob> {
  const { width, height } = reel;
  const pixelsOf = (c: CanvasRenderingContext2D): Uint8ClampedArray =>
    c.getImageData(0, 0, width, height).data;
  const some = COLOUR_PARTS.map((part) => {
    const c = sheetOf(reel);
    reel.draw(c, part);
    return pixelsOf(c);
  });
  const all = new Uint8ClampedArray(some.length * width * height * 4);
  for (const [i, pixels] of some.entries()) all.set(pixels, i * pixels.length);
  const palette = quantize(all, COLOURS);
  const encoder = GIFEncoder();
  await eachFrame(reel, GIF_RATE, (c, frame) => {
    const index = applyPalette(pixelsOf(c), palette);
    const delay = 1000 / GIF_RATE;
    // The first one has the colours of all.
    encoder.writeFrame(
      index,
      width,
      height,
      frame === 0 ? { palette, delay, repeat: 0 } : { delay },
    );
  });
  encoder.finish();
  return new Blob([encoder.bytes()], { type: 'image/gif' });
}

export async function mp4Of(reel: Reel, { config, name }: Codec): Promise<Blob> {
  const { width, height } = reel;
  const target = new ArrayBufferTarget();
  const muxer = new Muxer({
    target,
    video: { codec: name, width, height, frameRate: MP4_RATE },
    fastStart: 'in-memory',
  });
  let failure: DOMException | null = null;
  const encoder = new VideoEncoder({
    output: (chunk, meta) => muxer.addVideoChunk(chunk, meta),
    error: (error) => {
      failure = error;
    },
  });
  encoder.configure(config);
  await eachFrame(reel, MP4_RATE, async (c, frame) => {
    if (failure !== null) throw failure;
    const image = new VideoFrame(c.canvas, {
      timestamp: (frame * 1_000_000) / MP4_RATE,
      duration: 1_000_000 / MP4_RATE,
    });
    encoder.encode(image, { keyFrame: frame % KEY === 0 });
    image.close();
    // What waits to be encoded takes memory.
    while (encoder.encodeQueueSize > 4) await new Promise((resolve) => setTimeout(resolve, 5));
  });
  await encoder.flush();
  encoder.close();
  muxer.finalize();
  return new Blob([target.buffer], { type: 'video/mp4' });
}
