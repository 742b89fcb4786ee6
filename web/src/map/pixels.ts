// Colours as an image holds its pixels.

/** The pixel of a colour, `#rrggbb`. */
export function pixelOf(colour: string): number {
  return mixed(colour, colour, 0);
}

/** The pixel of a colour with a part of another one. */
export function mixed(colour: string, other: string, part: number): number {
  const [red, green, blue] = [1, 3, 5].map((at) => {
    const [a, b] = [colour, other].map((it) => parseInt(it.slice(at, at + 2), 16));
    return Math.round((1 - part) * a! + part * b!);
  });
  return new Uint32Array(Uint8Array.of(red!, green!, blue!, 255).buffer)[0]!;
}
