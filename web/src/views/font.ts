// The font of what is drawn.

export const FONT = 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

let letters = 1;

/** Makes the letters of pictures so much larger, as on a projector. */
export function setLetters(times: number): void {
  letters = times;
}

/** The font at a size. */
export function font(pixels: number, style = ''): string {
  return `${style} ${letters * pixels}px ${FONT}`.trim();
}
