// Routh's diagram of an impact: the friction impulse J against the normal impulse P.

import type { Routh } from '../core/motion';
import { roundTicks } from '../core/ticks';
import { IMPULSE_LINE_ROWS, type ImpulseLine, type Palette } from '../generated/palette';
import { label, type Size, setDash } from './canvas';
import { FONT } from './font';

export interface RouthScene {
  routh: Routh;
  /** What one unit of the diagram is worth in the unit that is shown, and that unit. */
  scale: number;
  unit: string;
  palette: Palette;
}

const MARGIN = { left: 58, right: 16, top: 14, bottom: 42 };

/** Width of the way, which nothing else has. */
const WAY = 3.5;

/** From P, J to pixels. */
interface Frame {
  x(normal: number): number;
  y(friction: number): number;
}

export function drawRouth(c: CanvasRenderingContext2D, size: Size, scene: RouthScene): void {
  const { routh, palette } = scene;
  const [left = 0, right = 1, low = 0, high = 1] = routh.frame;
  const width = size.width - MARGIN.left - MARGIN.right;
  const height = size.height - MARGIN.top - MARGIN.bottom;
  const frame: Frame = {
    x: (normal) => MARGIN.left + ((normal - left) / (right - left)) * width,
    y: (friction) => MARGIN.top + ((high - friction) / (high - low)) * height,
  };
  axes(c, size, frame, scene);
  lineOf(c, frame, routh.compression, 'greatest_compression', palette);
  lineOf(c, frame, routh.sticking, 'sticking', palette);
  drawWay(c, frame, routh, palette);
}

function axes(
  c: CanvasRenderingContext2D,
  { width, height }: Size,
  frame: Frame,
  scene: RouthScene,
): void {
  const {
    routh: {
      frame: [left = 0, right = 1, low = 0, high = 1],
    },
    scale,
    unit,
    palette,
  } = scene;
  const [bottom, rim] = [height - MARGIN.bottom, width - MARGIN.right];
  c.font = `12.5px ${FONT}`;
  c.fillStyle = palette.ink.ink;
  c.lineWidth = 1;
  c.setLineDash([]);
  c.textAlign = 'center';
  c.textBaseline = 'top';
  for (const { value, label: text } of roundTicks(
    left * scale,
    right * scale,
    Math.max(3, Math.floor(width / 80)),
  )) {
    stroke(c, palette.ink.line, frame.x(value / scale), MARGIN.top, frame.x(value / scale), bottom);
    c.fillText(text, frame.x(value / scale), bottom + 6);
  }
  c.textAlign = 'right';
  c.textBaseline = 'middle';
  for (const { value, label: text } of roundTicks(
    low * scale,
    high * scale,
    Math.max(3, Math.floor(height / 40)),
  )) {
    stroke(c, palette.ink.line, MARGIN.left, frame.y(value / scale), rim, frame.y(value / scale));
    c.fillText(text, MARGIN.left - 7, frame.y(value / scale));
  }
  // The axes themselves, through the state before.
  stroke(c, palette.ink.soft, frame.x(0), MARGIN.top, frame.x(0), bottom);
  stroke(c, palette.ink.soft, MARGIN.left, frame.y(0), rim, frame.y(0));
  c.strokeStyle = palette.ink.soft;
  c.strokeRect(MARGIN.left, MARGIN.top, rim - MARGIN.left, bottom - MARGIN.top);
  c.font = `italic 15px ${FONT}`;
  c.fillStyle = palette.ink.ink;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  c.fillText('J', 12, 0.5 * (MARGIN.top + bottom));
  c.fillText('P', 0.5 * (MARGIN.left + rim), height - 10);
  c.font = `12.5px ${FONT}`;
  c.fillStyle = palette.ink.soft;
  c.textAlign = 'right';
  c.fillText(unit, rim, height - 10);
}

function stroke(
  c: CanvasRenderingContext2D,
  colour: string,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
): void {
  c.strokeStyle = colour;
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

function lineOf(
  c: CanvasRenderingContext2D,
  frame: Frame,
  ends: Float64Array,
  name: ImpulseLine,
  palette: Palette,
): void {
  const [p0, j0, p1, j1] = ends;
  if (p0 === undefined || j0 === undefined || p1 === undefined || j1 === undefined) return;
  c.lineWidth = IMPULSE_LINE_ROWS[name].width;
  setDash(c, IMPULSE_LINE_ROWS[name].dash);
  stroke(c, palette.impulse[name], frame.x(p0), frame.y(j0), frame.x(p1), frame.y(j1));
  c.setLineDash([]);
}

function drawWay(c: CanvasRenderingContext2D, frame: Frame, routh: Routh, palette: Palette): void {
  const { way, greatestCompression } = routh;
  c.lineJoin = 'round';
  for (const [colour, width] of [
    [palette.ink.paper, WAY + 3],
    [palette.arrow.impulse, WAY],
  ] as const) {
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.beginPath();
    for (let i = 0; i < way.length; i += 2) c.lineTo(frame.x(way[i]!), frame.y(way[i + 1]!));
    c.stroke();
  }
  dot(c, frame.x(0), frame.y(0), palette.ink.paper, palette.arrow.impulse);
  const [normal, friction] = greatestCompression;
  if (normal !== undefined && friction !== undefined) {
    dot(c, frame.x(normal), frame.y(friction), palette.ink.paper, palette.ink.ink);
  }
  const [p, j] = way.subarray(-2);
  if (p === undefined || j === undefined) return;
  dot(c, frame.x(p), frame.y(j), palette.arrow.impulse, palette.ink.paper);
  c.font = `bold 13px ${FONT}`;
  c.textBaseline = 'middle';
  c.textAlign = 'right';
  label(
    c,
    'end',
    frame.x(p) - 10,
    frame.y(j) + (j < 0 ? 14 : -14),
    palette.arrow.impulse,
    palette.ink.paper,
  );
}

function dot(c: CanvasRenderingContext2D, x: number, y: number, fill: string, rim: string): void {
  c.beginPath();
  c.arc(x, y, 5.5, 0, 2 * Math.PI);
  c.fillStyle = fill;
  c.strokeStyle = rim;
  c.lineWidth = 2;
  c.fill();
  c.stroke();
}
