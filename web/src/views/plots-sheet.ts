// The plots one under the other on one sheet, for pictures. On the screen a library draws them; it draws on a canvas
// only, and a picture in vectors needs lines.

import type { Motion, Samples } from '../core/motion';
import { label, niceStep } from './canvas';
import { FONT, type Palette } from './palette';
import { QUANTITIES, rangeOf, type Scales } from './plots';

const LEFT = 70;
const RIGHT = 20;
const TOP = 14;
const BOTTOM = 44;
const GAP = 22;

export function drawPlots(c: CanvasRenderingContext2D, width: number, height: number, motion: Motion, samples: Samples,
  palette: Palette, now: number, scales: Scales, si: boolean): void {
  const each = (height - TOP - BOTTOM - GAP * (QUANTITIES.length - 1)) / QUANTITIES.length;
  const x = (time: number): number =>
    LEFT + ((time - motion.begin) / (motion.end - motion.begin || 1)) * (width - LEFT - RIGHT);
  c.font = `13px ${FONT}`;
  QUANTITIES.forEach((quantity, i) => {
    const top = TOP + i * (each + GAP);
    const values = quantity.values(samples, scales);
    const known = values.filter((it) => it !== null);
    const [least, most] = rangeOf(known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity));
    const y = (value: number): number => top + ((most - value) / (most - least)) * each;
    c.globalAlpha = 0.16;
    for (const phase of motion.phases) {
      const to = x(Math.min(phase.end, motion.end));
      c.fillStyle = palette.mode[phase.mode];
      c.fillRect(x(phase.start), top, to - x(phase.start), each);
    }
    c.globalAlpha = 1;
    ticks(c, palette, least, most, y, width);
    c.strokeStyle = palette.faint;
    c.lineWidth = 1;
    c.strokeRect(LEFT, top, width - LEFT - RIGHT, each);
    c.strokeStyle = palette.ink;
    c.lineWidth = 2;
    c.lineJoin = 'round';
    c.beginPath();
    let open = false;
    values.forEach((value, k) => {
      if (value === null) open = false;
      else {
        if (open) c.lineTo(x(samples.time[k]!), y(value));
        else c.moveTo(x(samples.time[k]!), y(value));
        open = true;
      }
    });
    c.stroke();
    c.strokeStyle = palette.slip;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(x(now), top);
    c.lineTo(x(now), top + each);
    c.stroke();
    c.textAlign = 'left';
    c.textBaseline = 'top';
    c.font = `italic 16px ${FONT}`;
    label(c, quantity.title, LEFT + 8, top + 6, palette.ink, palette.paper);
    c.textAlign = 'right';
    c.font = `13px ${FONT}`;
    label(c, quantity.units[si ? 1 : 0], width - RIGHT - 8, top + 7, palette.ink, palette.paper);
    c.font = `13px ${FONT}`;
  });
  const [begin, end] = [motion.begin * scales.time, motion.end * scales.time];
  const step = niceStep(end - begin || 1, 8);
  c.fillStyle = palette.ink;
  c.textAlign = 'center';
  c.textBaseline = 'top';
  for (let k = Math.ceil(begin / step); k * step <= end + 1e-9; k++) {
    c.fillText(String(Number((k * step).toPrecision(6))), x((k * step) / scales.time), height - BOTTOM + 6);
  }
  c.fillText(si ? 't [s]' : 'τ', width / 2, height - 20);
}

function ticks(c: CanvasRenderingContext2D, palette: Palette, least: number, most: number, y: (value: number) => number,
  width: number): void {
  const step = niceStep(most - least, 4);
  c.textAlign = 'right';
  c.textBaseline = 'middle';
  for (let k = Math.ceil(least / step); k * step <= most; k++) {
    c.strokeStyle = palette.line;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(LEFT, y(k * step));
    c.lineTo(width - RIGHT, y(k * step));
    c.stroke();
    c.fillStyle = palette.ink;
    c.fillText(String(Number((k * step).toPrecision(4))).replace('-', '−'), LEFT - 8, y(k * step));
  }
}
