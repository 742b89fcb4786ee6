// The colours of the style sheet, for what is drawn on a canvas.

import type { Mode } from '../core/motion';

export interface Palette {
  paper: string;
  ink: string;
  faint: string;
  line: string;
  force: string;
  friction: string;
  slip: string;
  level: string;
  region: string;
  separatrix: string;
  mode: Record<Mode, string>;
  /** Colours of the classes of a map, by name. */
  classOf(name: string): string;
}

/** Reads the colours of the theme that is shown. */
export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return {
    paper: read('paper'),
    ink: read('ink'),
    faint: read('faint'),
    line: read('line'),
    force: read('force'),
    friction: read('friction'),
    slip: read('slip'),
    level: read('level'),
    region: read('region'),
    separatrix: read('separatrix'),
    mode: { rolling: read('rolling'), sliding: read('sliding'), gliding: read('gliding'), flight: read('flight') },
    classOf: (name) => read(`map-${name}`),
  };
}

/** Dashes by which the modes differ in grey. */
export const DASHES: Record<Mode, number[]> = { rolling: [], sliding: [7, 3], gliding: [2, 3], flight: [9, 3, 2, 3] };

export const FONT = 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
