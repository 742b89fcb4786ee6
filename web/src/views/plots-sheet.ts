// The plots one under the other on one sheet, for pictures. On the screen a library draws them; it
// draws on a canvas only, and a picture in vectors needs lines.

import type { Samples } from '../core/motion';
import { roundTicks } from '../core/ticks';
import type { Palette } from '../generated/palette';
import { COLUMN_ROWS } from '../generated/tables';
import { label, type Size } from './canvas';
import { FONT } from './font';
import { BOUND_DASH, rangeOf, type Shown, SUBJECTS, valuesOfPinned } from './plots';

const LEFT = 70;
const RIGHT = 20;
const TOP = 14;
const BOTTOM = 44;
const GAP = 22;

export interface PlotsScene extends Shown {
  samples: Samples;
  /** Time of the cursor. */
  time: number;
  palette: Palette;
}

export function drawPlots(
  c: CanvasRenderingContext2D,
  { width, height }: Size,
  scene: PlotsScene,
): void {
  const { motion, samples, palette, time: now, units, system } = scene;
  const each = (height - TOP - BOTTOM - GAP * (SUBJECTS.length - 1)) / SUBJECTS.length;
  const x = (time: number): number =>
    LEFT + ((time - motion.begin) / (motion.end - motion.begin || 1)) * (width - LEFT - RIGHT);
  c.font = `13px ${FONT}`;
  SUBJECTS.forEach((subject, i) => {
    const top = TOP + i * (each + GAP);
    const values = subject.values(samples, units, motion);
    const others =
      scene.pinned === null ? [] : valuesOfPinned(scene.pinned, subject, samples.time, units);
    const bounds = subject.bound === undefined ? [] : values.map(() => subject.bound!(scene));
    const known = [...values, ...others, ...bounds].filter((it) => it !== null);
    const [least, most] = rangeOf(
      known.reduce((a, b) => Math.min(a, b), Infinity),
      known.reduce((a, b) => Math.max(a, b), -Infinity),
    );
    const y = (value: number): number => top + ((most - value) / (most - least)) * each;
    c.globalAlpha = 0.16;
    for (const phase of motion.phases) {
      const to = x(Math.min(phase.end, motion.end));
      c.fillStyle = palette.mode[phase.mode];
      c.fillRect(x(phase.start), top, to - x(phase.start), each);
    }
    c.globalAlpha = 1;
    ticks(c, palette, least, most, y, width);
    c.strokeStyle = palette.ink.soft;
    c.lineWidth = 1;
    c.strokeRect(LEFT, top, width - LEFT - RIGHT, each);
    c.lineWidth = 2;
    c.lineJoin = 'round';
    for (const [curve, colour, dash] of [
      [bounds, palette.arrow.friction_force, BOUND_DASH],
      [others, palette.accent.teal, [6, 4]],
      [values, palette.ink.ink, []],
    ] as const) {
      c.strokeStyle = colour;
      c.setLineDash([...dash]);
      c.beginPath();
      let open = false;
      curve.forEach((value, k) => {
        if (value === null) open = false;
        else {
          if (open) c.lineTo(x(samples.time[k]!), y(value));
          else c.moveTo(x(samples.time[k]!), y(value));
          open = true;
        }
      });
      c.stroke();
    }
    c.strokeStyle = palette.accent.violet;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(x(now), top);
    c.lineTo(x(now), top + each);
    c.stroke();
    c.textAlign = 'left';
    c.textBaseline = 'top';
    c.font = `italic 16px ${FONT}`;
    label(c, subject.signs[system], LEFT + 8, top + 6, palette.ink.ink, palette.ink.paper);
    c.textAlign = 'right';
    c.font = `13px ${FONT}`;
    label(c, subject.units[system], width - RIGHT - 8, top + 7, palette.ink.ink, palette.ink.paper);
    c.font = `13px ${FONT}`;
  });
  const [begin, end] = [motion.begin * units.time, motion.end * units.time];
  c.fillStyle = palette.ink.ink;
  c.textAlign = 'center';
  c.textBaseline = 'top';
  for (const { value, label } of end > begin ? roundTicks(begin, end, 8) : []) {
    c.fillText(label, x(value / units.time), height - BOTTOM + 6);
  }
  const {
    signs,
    units: { si },
  } = COLUMN_ROWS.time;
  c.fillText(system === 'si' ? `${signs.si} [${si}]` : signs.dimensionless, width / 2, height - 20);
}

function ticks(
  c: CanvasRenderingContext2D,
  palette: Palette,
  least: number,
  most: number,
  y: (value: number) => number,
  width: number,
): void {
  c.textAlign = 'right';
  c.textBaseline = 'middle';
  for (const { value, label } of roundTicks(least, most, 5)) {
    c.strokeStyle = palette.ink.line;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(LEFT, y(value));
    c.lineTo(width - RIGHT, y(value));
    c.stroke();
    c.fillStyle = palette.ink.ink;
    c.fillText(label, LEFT - 8, y(value));
  }
}
