// What the pictures of the story draw: hoops, the ground, and small plots.

import type { Palette } from '../generated/palette';
import { arrow, label, setDash } from '../views/canvas';
import { FONT } from '../views/font';

export type Point = readonly [number, number];

/** A rectangle of the canvas. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Side by side where there is room, else one above the other. */
export function split(
  { width, height }: { width: number; height: number },
  part: number,
): readonly [Box, Box] {
  if (width > 1.3 * height) {
    const at = Math.round(width * part);
    return [
      { left: 0, top: 0, width: at, height },
      { left: at, top: 0, width: width - at, height },
    ];
  }
  const at = Math.round(height * 0.56);
  return [
    { left: 0, top: 0, width, height: at },
    { left: 0, top: at, width, height: height - at },
  ];
}

export interface Ring {
  x: number;
  y: number;
  /** Pixels. */
  radius: number;
  /** Angle of the weight from the top, counterclockwise. */
  theta: number;
  /** Distance of the weight from the centre over the radius. */
  offset?: number;
  colour: string;
  width?: number;
  dash?: readonly number[];
  /** Whether it has spokes and its weight in full. */
  isFaint?: boolean;
}

/** Where the weight of a hoop is. */
export function weightOf({ x, y, radius, theta, offset = 1 }: Ring): Point {
  return [x - offset * radius * Math.sin(theta), y - offset * radius * Math.cos(theta)];
}

export function ring(c: CanvasRenderingContext2D, it: Ring, palette: Palette): void {
  const { x, y, radius, colour, width = 4, dash = [], isFaint = false } = it;
  const [wx, wy] = weightOf(it);
  c.strokeStyle = colour;
  c.lineWidth = width;
  setDash(c, dash);
  c.beginPath();
  c.arc(x, y, Math.max(0, radius - width / 2), 0, 2 * Math.PI);
  c.stroke();
  c.setLineDash([]);
  if (!isFaint) {
    c.strokeStyle = palette.ink.line;
    c.lineWidth = 1.5;
    line(c, [x, y], [wx, wy]);
    c.fillStyle = palette.ink.ink;
    disc(c, [x, y], 2.5);
  }
  c.fillStyle = isFaint ? colour : palette.ink.ink;
  disc(c, [wx, wy], isFaint ? 3 : Math.max(5, 0.075 * radius));
}

export function disc(c: CanvasRenderingContext2D, [x, y]: Point, radius: number): void {
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fill();
}

export function line(c: CanvasRenderingContext2D, ...points: Point[]): void {
  c.beginPath();
  for (const [x, y] of points) c.lineTo(x, y);
  c.stroke();
}

/** The ground with marks a radius apart, which pass as the hoop rolls. */
export function ground(
  c: CanvasRenderingContext2D,
  box: Box,
  y: number,
  unit: number,
  shift: number,
  palette: Palette,
): void {
  c.strokeStyle = palette.ink.ink;
  c.setLineDash([]);
  c.lineWidth = 2;
  line(c, [box.left, y], [box.left + box.width, y]);
  c.strokeStyle = palette.ink.soft;
  c.lineWidth = 1;
  const step = unit / 2;
  const first = box.left + ((((-shift * unit) % step) + step) % step);
  for (let x = first; x < box.left + box.width; x += step) line(c, [x, y], [x - 5, y + 8]);
}

/** A force, with its letter at its end. */
export function force(
  c: CanvasRenderingContext2D,
  [x, y]: Point,
  dx: number,
  dy: number,
  colour: string,
  letter: string,
  palette: Palette,
): void {
  arrow(c, x, y, dx, dy, colour);
  const length = Math.hypot(dx, dy);
  if (length < 12) return;
  c.font = `italic bold 15px ${FONT}`;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  label(
    c,
    letter,
    x + dx + (dx / length) * 12,
    y + dy + (dy / length) * 12,
    colour,
    palette.ink.paper,
  );
}

export interface Curve {
  points: readonly Point[];
  colour: string;
  width?: number;
  dash?: readonly number[];
}

export interface Plot {
  box: Box;
  x: Point;
  y: Point;
  /** What the axes are, at their ends. */
  xName: string;
  yName: string;
  curves: readonly Curve[];
  /** Lines across at these values of y, and upright ones of x. */
  levels?: readonly number[];
  uprights?: readonly { x: number; name: string }[];
  /** The point of now. */
  now?: Point | null;
}

/** A plot without numbers: what they are is said. Gives the place of a point. */
export function plot(
  c: CanvasRenderingContext2D,
  it: Plot,
  palette: Palette,
): (point: Point) => Point {
  const pad = { left: 16, right: 16, top: 26, bottom: 26 };
  const [left, top] = [it.box.left + pad.left, it.box.top + pad.top];
  const [width, height] = [
    it.box.width - pad.left - pad.right,
    it.box.height - pad.top - pad.bottom,
  ];
  const place = ([x, y]: Point): Point => [
    left + ((x - it.x[0]) / (it.x[1] - it.x[0])) * width,
    top + (1 - (y - it.y[0]) / (it.y[1] - it.y[0])) * height,
  ];
  c.font = `13px ${FONT}`;
  c.textBaseline = 'alphabetic';
  c.setLineDash([]);
  c.strokeStyle = palette.ink.line;
  c.lineWidth = 1;
  c.strokeRect(left, top, width, height);
  for (const y of it.levels ?? []) {
    c.strokeStyle = palette.ink.soft;
    line(c, place([it.x[0], y]), place([it.x[1], y]));
  }
  for (const { x, name } of it.uprights ?? []) {
    c.strokeStyle = palette.ink.faint;
    setDash(c, [4, 4]);
    line(c, place([x, it.y[0]]), place([x, it.y[1]]));
    c.setLineDash([]);
    c.textAlign = place([x, 0])[0] > left + 0.7 * width ? 'right' : 'left';
    const [tx] = place([x, 0]);
    label(
      c,
      name,
      tx + (c.textAlign === 'right' ? -5 : 5),
      top + 16,
      palette.ink.soft,
      palette.ink.paper,
    );
  }
  c.save();
  c.beginPath();
  c.rect(left, top, width, height);
  c.clip();
  for (const { points, colour, width: thick = 2.5, dash = [] } of it.curves) {
    c.strokeStyle = colour;
    c.lineWidth = thick;
    c.lineJoin = 'round';
    setDash(c, dash);
    c.beginPath();
    let open = false;
    for (const point of points) {
      if (!Number.isFinite(point[1])) open = false;
      else if (open) c.lineTo(...place(point));
      else {
        c.moveTo(...place(point));
        open = true;
      }
    }
    c.stroke();
  }
  c.setLineDash([]);
  c.restore();
  if (it.now && Number.isFinite(it.now[1])) {
    const y = Math.min(Math.max(it.now[1], it.y[0]), it.y[1]);
    c.fillStyle = palette.ink.ink;
    c.strokeStyle = palette.ink.paper;
    c.lineWidth = 2;
    disc(c, place([it.now[0], y]), 6);
    c.stroke();
  }
  c.fillStyle = palette.ink.soft;
  c.textAlign = 'left';
  c.fillText(it.yName, left, top - 9);
  c.textAlign = 'right';
  c.fillText(it.xName, left + width, top + height + 17);
  return place;
}

/** Words on the canvas. */
export function words(
  c: CanvasRenderingContext2D,
  text: string,
  [x, y]: Point,
  palette: Palette,
  align: CanvasTextAlign = 'center',
  size = 14,
): void {
  c.font = `${size}px ${FONT}`;
  c.textAlign = align;
  c.textBaseline = 'middle';
  label(c, text, x, y, palette.ink.ink, palette.ink.paper);
}
