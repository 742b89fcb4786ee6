// The phase plane (θ, θ′): outcome map, 𝓡, curves, levels, the motion and its start.

import { type Motion, modeOf, type Sample, type Samples } from '../core/motion';
import { angularTicks, roundTicks } from '../core/ticks';
import { Plane, type Problem } from '../core/wasm';
import { CURVE_ROWS, CURVES, type Curve, MODE_DASHES, type Palette } from '../generated/palette';
import { COLUMN_ROWS, type System } from '../generated/tables';
import { label, type Size, setDash } from './canvas';
import { FONT } from './font';

/** Angles that are shown: one turn and a half, so that neither the top nor the bottom is cut. */
export const FROM = -Math.PI;
export const TO = 2 * Math.PI;

const MARGIN = { left: 46, right: 14, top: 12, bottom: 40 };

/** From θ, θ′ to pixels and back. */
export class Frame {
  constructor(
    readonly size: Size,
    readonly rate: number,
    /** What a rate of 1 is worth on the axis, and in which system of units. */
    readonly unit = 1,
    readonly system: System = 'dimensionless',
  ) {}

  get width(): number {
    return this.size.width - MARGIN.left - MARGIN.right;
  }

  get height(): number {
    return this.size.height - MARGIN.top - MARGIN.bottom;
  }

  x(theta: number): number {
    return MARGIN.left + ((theta - FROM) / (TO - FROM)) * this.width;
  }

  y(rate: number): number {
    return MARGIN.top + (0.5 - (0.5 * rate) / this.rate) * this.height;
  }

  theta(x: number): number {
    return FROM + ((x - MARGIN.left) / this.width) * (TO - FROM);
  }

  rateAt(y: number): number {
    return (0.5 - (y - MARGIN.top) / this.height) * 2 * this.rate;
  }

  /** What one pixel is worth. */
  get pixel(): { theta: number; rate: number } {
    return { theta: (TO - FROM) / this.width, rate: (2 * this.rate) / this.height };
  }

  clip(c: CanvasRenderingContext2D): void {
    c.beginPath();
    c.rect(MARGIN.left, MARGIN.top, this.width, this.height);
    c.clip();
  }
}

/** The curves of one hoop, computed once: points θ, θ′ one after the other, with NaN, NaN between pieces. */
export interface Curves {
  lines: Readonly<Record<Curve, Float64Array>>;
  /** With where they stand. */
  letters: readonly [string, number, number][];
  region: Float64Array;
  /** Whether 𝓡 has room for its name. */
  isRegionNamed: boolean;
  equilibria: Float64Array;
  rate: number;
}

/** Where 𝓡 is named, θ and the part of the largest rate. */
const REGION_NAME = [0.28, 0.13] as const;

export function curvesOf(problem: Problem, rate: number): Curves {
  const plane = new Plane(problem, FROM, TO, rate);
  const letters: [string, number, number][] = [];
  for (const curve of UPWARDS) {
    const place = plane.placeOfLetter(curve);
    if (place) letters.push([CURVE_ROWS[curve].letter ?? '', place[0]!, place[1]!]);
  }
  const region = plane.region();
  const curves: Curves = {
    lines: Object.fromEntries(
      CURVES.map((curve) => [curve, plane.curve(curve)]),
    ) as Curves['lines'],
    letters,
    region,
    isRegionNamed: region.length > 0 && plane.canRoll(REGION_NAME[0], REGION_NAME[1] * rate),
    equilibria: plane.equilibria(),
    rate,
  };
  plane.free();
  return curves;
}

export interface PlaneScene {
  curves: Curves;
  /** One turn of the map, if it is to be shown. */
  map: CanvasImageSource | null;
  mapSize: number;
  palette: Palette;
  /** Whether letters stand at the curves. */
  symbols: boolean;
}

/** Everything that does not move. */
export function drawPlane(c: CanvasRenderingContext2D, frame: Frame, scene: PlaneScene): void {
  const { curves, palette, map, mapSize } = scene;
  c.save();
  frame.clip(c);
  if (map) {
    c.imageSmoothingEnabled = true;
    const [left, top] = [frame.x(FROM), frame.y(frame.rate)];
    const turn = frame.x(Math.PI) - left;
    c.drawImage(map, 0, 0, mapSize, mapSize, left, top, turn, frame.height);
    c.drawImage(map, 0, 0, mapSize / 2, mapSize, left + turn, top, turn / 2, frame.height);
  }
  hatchRegion(c, frame, curves.region, palette);
  for (const curve of UPWARDS) {
    setPen(c, curve, palette);
    trace(c, frame, curves.lines[curve]);
    c.stroke();
  }
  c.setLineDash([]);
  for (let i = 0; i < curves.equilibria.length; i += 2) {
    for (const turn of [-2 * Math.PI, 0, 2 * Math.PI]) {
      equilibrium(
        c,
        frame.x(curves.equilibria[i]! + turn),
        frame.y(0),
        curves.equilibria[i + 1]!,
        palette,
      );
    }
  }
  if (scene.symbols) curveLabels(c, frame, curves, palette);
  c.restore();
  axes(c, frame, palette);
}

/** The curves from the lowest to the topmost. */
const UPWARDS: readonly Curve[] = [
  'level',
  'separatrix',
  'chatter',
  'lift_off',
  'normal_force_zero',
  'slip_limit',
  'band_of_rest',
];

function setPen(c: CanvasRenderingContext2D, curve: Curve, palette: Palette): void {
  c.strokeStyle = palette.curve[curve];
  c.lineWidth = CURVE_ROWS[curve].width;
  c.lineJoin = 'round';
  setDash(c, CURVE_ROWS[curve].dash);
}

/** Pieces of a curve, or outlines, as one path. */
function trace(c: CanvasRenderingContext2D, frame: Frame, points: Float64Array): void {
  c.beginPath();
  let open = false;
  for (let i = 0; i < points.length; i += 2) {
    const [theta, rate] = [points[i]!, points[i + 1]!];
    if (Number.isNaN(theta)) open = false;
    else if (open) c.lineTo(frame.x(theta), frame.y(rate));
    else {
      c.moveTo(frame.x(theta), frame.y(rate));
      open = true;
    }
  }
}

function segment(
  c: CanvasRenderingContext2D,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
): void {
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

/** Pixels between the strokes of 𝓡. */
const HATCH = 9;

/** 𝓡 is hatched: a shade would change the colours of the map. */
function hatchRegion(
  c: CanvasRenderingContext2D,
  frame: Frame,
  region: Float64Array,
  palette: Palette,
): void {
  if (region.length === 0) return;
  c.save();
  trace(c, frame, region);
  c.clip();
  c.strokeStyle = palette.ink.soft;
  c.globalAlpha = 0.35;
  c.lineWidth = 1;
  c.setLineDash([]);
  const { width, height } = frame.size;
  c.beginPath();
  for (let x = -height; x < width; x += HATCH) {
    c.moveTo(x, height);
    c.lineTo(x + height, 0);
  }
  c.stroke();
  c.restore();
}

function equilibrium(
  c: CanvasRenderingContext2D,
  x: number,
  y: number,
  stability: number,
  palette: Palette,
): void {
  c.beginPath();
  c.arc(x, y, 4.5, 0, 2 * Math.PI);
  c.fillStyle = stability > 0 ? palette.ink.ink : palette.ink.paper;
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 1.75;
  c.setLineDash([]);
  c.fill();
  c.stroke();
}

function curveLabels(
  c: CanvasRenderingContext2D,
  frame: Frame,
  curves: Curves,
  palette: Palette,
): void {
  c.font = `italic 15px ${FONT}`;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  for (const [letter, theta, rate] of curves.letters) {
    label(c, letter, frame.x(theta), frame.y(rate), palette.ink.ink, palette.ink.paper);
  }
  if (curves.isRegionNamed) {
    c.font = `italic 17px ${FONT}`;
    label(
      c,
      '𝓡',
      frame.x(REGION_NAME[0]),
      frame.y(REGION_NAME[1] * frame.rate),
      palette.ink.ink,
      palette.ink.paper,
    );
  }
}

function axes(c: CanvasRenderingContext2D, frame: Frame, palette: Palette): void {
  const [left, right, top, bottom] = [
    frame.x(FROM),
    frame.x(TO),
    frame.y(frame.rate),
    frame.y(-frame.rate),
  ];
  c.strokeStyle = palette.ink.soft;
  c.fillStyle = palette.ink.ink;
  c.lineWidth = 1;
  c.setLineDash([]);
  c.strokeRect(left, top, right - left, bottom - top);
  c.font = `12.5px ${FONT}`;
  c.textAlign = 'center';
  c.textBaseline = 'top';
  for (const { value, label } of angularTicks(FROM, TO, 7)) {
    const x = frame.x(value);
    segment(c, x, bottom, x, bottom + 5);
    c.fillText(label, x, bottom + 8);
  }
  c.textAlign = 'right';
  c.textBaseline = 'middle';
  const most = frame.rate * frame.unit;
  for (const { value, label } of roundTicks(
    -most,
    most,
    Math.max(4, Math.floor(frame.height / 45)),
  )) {
    const y = frame.y(value / frame.unit);
    segment(c, left - 5, y, left, y);
    c.fillText(label, left - 8, y);
  }
  c.font = `italic 15px ${FONT}`;
  c.textAlign = 'center';
  const { theta, theta_rate: rate } = COLUMN_ROWS;
  c.fillText(theta.signs[frame.system], 0.5 * (left + right) + 0.1 * frame.width, bottom + 30);
  // Over the axis, where it has room for its unit.
  c.textAlign = 'left';
  label(
    c,
    `${rate.signs[frame.system]} [${rate.units[frame.system]}]`,
    left + 6,
    top + 12,
    palette.ink.ink,
    palette.ink.paper,
  );
}

/** Where an angle is drawn: as it is, or by whole turns into the plane. */
export function wrapped(theta: number): number {
  if (theta >= FROM - 1e-9 && theta <= TO + 1e-9) return theta;
  const turn = 2 * Math.PI;
  return theta - turn * Math.floor(theta / turn);
}

/** The motion, and where it is at the cursor. */
export function drawMotion(
  c: CanvasRenderingContext2D,
  frame: Frame,
  motion: Motion,
  now: Sample | null,
  palette: Palette,
): void {
  c.save();
  frame.clip(c);
  const s = motion.samples;
  c.lineJoin = 'round';
  for (let from = 0; from < s.length - 1; ) {
    const mode = modeOf(s.mode[from]!);
    const shift = wrapped(s.theta[from]!) - s.theta[from]!;
    c.beginPath();
    c.moveTo(frame.x(s.theta[from]! + shift), frame.y(s.theta_rate[from]!));
    let to = from + 1;
    // Over the edge the motion comes in again on the other side, as another line.
    for (; to < s.length && s.mode[to] === s.mode[from] && !isJump(s, to); to++) {
      const rate = Math.max(-5 * frame.rate, Math.min(5 * frame.rate, s.theta_rate[to]!));
      c.lineTo(frame.x(s.theta[to]! + shift), frame.y(rate));
      if (Math.abs(wrapped(s.theta[to]!) - s.theta[to]! - shift) > 1) break;
    }
    const again = Math.abs(shift) > 1;
    c.setLineDash([]);
    c.strokeStyle = palette.ink.paper;
    c.lineWidth = 5.5;
    if (!again) c.stroke();
    c.globalAlpha = again ? 0.6 : 1;
    c.strokeStyle = palette.mode[mode];
    c.lineWidth = again ? 2 : 3;
    setDash(c, MODE_DASHES[mode]);
    c.stroke();
    c.globalAlpha = 1;
    from = to;
  }
  c.setLineDash([]);
  drawImpacts(c, frame, motion, palette);
  for (const event of motion.events.slice(1)) {
    if (event.impact === null) {
      dot(
        c,
        frame.x(wrapped(event.theta)),
        frame.y(event.theta_rate),
        4,
        palette.ink.paper,
        palette.ink.ink,
      );
    }
  }
  if (now) {
    const mode = modeOf(now.mode);
    dot(
      c,
      frame.x(wrapped(now.theta)),
      frame.y(now.theta_rate),
      7,
      palette.mode[mode],
      palette.ink.paper,
    );
  }
  c.restore();
}

/** Whether the rate jumps between a sample and the one before. */
function isJump(s: Samples, at: number): boolean {
  return s.time[at] === s.time[at - 1] && s.theta_rate[at] !== s.theta_rate[at - 1];
}

/** The jump of the rate in each impact, from an open dot to a full one. */
function drawImpacts(
  c: CanvasRenderingContext2D,
  frame: Frame,
  motion: Motion,
  palette: Palette,
): void {
  const last = motion.impacts.length;
  // Where bounces settle they would hide each other.
  motion.impacts.forEach(({ theta, impact: { before, after } }, i) => {
    const x = frame.x(wrapped(theta));
    c.strokeStyle = palette.arrow.impulse;
    c.lineWidth = 1.5;
    segment(c, x, frame.y(before.theta_rate), x, frame.y(after.theta_rate));
    const radius = i < MANY || i === last - 1 ? 3.5 : 2;
    dot(c, x, frame.y(before.theta_rate), radius, palette.ink.paper, palette.arrow.impulse);
    dot(c, x, frame.y(after.theta_rate), radius, palette.arrow.impulse, palette.ink.paper);
  });
}

/** Impacts that are drawn at full size. */
const MANY = 12;

/** The start as a ring. */
export function drawStart(
  c: CanvasRenderingContext2D,
  frame: Frame,
  theta: number,
  rate: number,
  palette: Palette,
): void {
  if (Math.abs(rate) > frame.rate) return;
  for (const [colour, width] of [
    [palette.ink.paper, 6],
    [palette.ink.ink, 3],
  ] as const) {
    c.beginPath();
    c.arc(frame.x(wrapped(theta)), frame.y(rate), 10, 0, 2 * Math.PI);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.stroke();
  }
}

function dot(
  c: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  fill: string,
  rim: string,
): void {
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fillStyle = fill;
  c.strokeStyle = rim;
  c.lineWidth = 2;
  c.fill();
  c.stroke();
}
