// The hoop, to scale on the plane: particle, mass centre, contact point, forces, slip velocity and
// trails. The view is level, and a plane with a slope is tilted.

import type { Ghost } from '../core/derivatives';
import { type Motion, modeOf, type Sample, type Samples } from '../core/motion';
import { roundTicks } from '../core/ticks';
import { MODE_DASHES, type Palette } from '../generated/palette';
import { COLUMN_ROWS, type Mode, QUANTITY_ROWS } from '../generated/tables';
import { arrow, label, type Size, setDash } from './canvas';
import { FONT, font } from './font';

export interface HoopScene {
  motion: Motion;
  sample: Sample | null;
  /** ℓ̂ and h. */
  offset: number;
  h: number;
  slope: number;
  follow: boolean;
  /** The next landing as it was predicted before a drag, and as it is. */
  landing: { predicted: Ghost | null; exact: Sample | null } | null;
  palette: Palette;
  /** What a radius is worth on the axis, and its unit; R without it. */
  axis?: { radius: number; unit: string };
  /** The weight of hoop and particle, m₂g, by which the arrows of forces are scaled, and how it is written at the bar of that scale, if there is one, and at its arrow. */
  weight?: { force: number; text: string | null; name: string };
  /** The coefficients of friction of the inset of the contact; without them there is none. */
  contact?: { mu_s: number; mu_k: number; words: Readonly<Record<Mode, string>> } | null;
  /** Whether letters stand at what is drawn. */
  symbols?: boolean;
  /** Whether what comes is not shown. */
  isSecret?: boolean;
  /** Whether forces and the slip velocity are left out. */
  hidesArrows?: boolean;
  /** Another motion at the same instant, to compare with. */
  pinned?: { sample: Sample } | null;
}

/** Pixels under the plane, for the scale and the slip velocity, and over the highest point. */
const BELOW = 58;
const ABOVE = 14;

/** Where the slip velocity is drawn, under the plane. */
const SLIP = 40;

/** Where no number stands at the right end of the plane, for its handle. */
const END = 44;

/** Radii that the arrow of the weight is long, whatever the motion, and that an arrow is long at most: a longer one is cut. */
const WEIGHT = 0.4;
const LONGEST = 2.3;

/** Radii of the arrow of a slip velocity of √(gR). */
const SPEED = 0.6;

/** The inset of the contact, in pixels: the arrow of the weight in it, and the longest; smaller in a view that is narrower than this. */
const NARROW = 420;
const CONTACT = { width: 118, height: 112, weight: 30, longest: 74 };

/** Radii that are seen to the side at least. */
const WIDE = 3.5;

const SIGN = {
  normal: COLUMN_ROWS.normal.signs.dimensionless,
  friction: COLUMN_ROWS.friction.signs.dimensionless,
  slip: COLUMN_ROWS.slip.signs.dimensionless,
};

/** Where the landing is seen by itself, in pixels, and those of a radius. */
const INSET = { top: 46, width: 190, height: 96, scale: 30 };

type Place = readonly [number, number];

export interface Camera {
  /** Pixels of a radius. */
  scale: number;
  sin: number;
  cos: number;
  /** The pixel of a point of the plane's coordinates. */
  at(x: number, y: number): Place;
  /** A pixel so many further along the plane and into it. */
  moved(from: Place, along: number, into: number): Place;
}

export function drawHoop(
  c: CanvasRenderingContext2D,
  size: Size,
  scene: HoopScene,
  camera = cameraOf(size, scene),
): void {
  const { motion, sample, palette } = scene;
  c.font = font(14);
  c.textBaseline = 'middle';
  drawGround(c, size, camera, scene);
  if (!sample) {
    drawStill(c, camera, scene);
    return;
  }
  drawPinned(c, camera, scene);
  drawTrails(c, motion.samples, sample.time, camera, scene);
  drawLanding(c, camera, scene);
  drawBody(c, camera, scene, sample);
  if (!scene.hidesArrows) drawArrows(c, camera, scene, sample);
  if (sample.time <= motion.begin) drawSpin(c, camera, scene, sample);
  if (scene.weight?.text) drawBar(c, size, camera, scene.weight.text, palette);
  if (scene.contact && !scene.hidesArrows) drawContact(c, size, scene, sample, scene.contact);
  if (scene.follow) drawInset(c, size, camera, scene);
}

export function cameraOf(
  { width, height }: Size,
  { motion, sample, slope, follow }: HoopScene,
): Camera {
  const { samples } = motion;
  const [sin, cos] = [Math.sin(slope), Math.cos(slope)];
  const level = (x: number, y: number): Place => [x * cos - y * sin, x * sin + y * cos];
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  const see = (x: number, gap: number): void => {
    const [[centre, middle], [foot, bottom]] = [level(x, 1 + gap), level(x, 0)];
    left = Math.min(left, centre, foot);
    right = Math.max(right, centre, foot);
    low = Math.min(low, middle - 1, bottom);
    high = Math.max(high, middle + 1);
  };
  const now = sample?.x ?? 0;
  see(now, sample?.gap ?? 0);
  for (let i = 0; i < samples.length; i++) see(follow ? now : samples.x[i]!, samples.gap[i]!);
  const wide = right - left + (follow ? WIDE : WIDE - 0.8);
  const scale = Math.min((height - BELOW - ABOVE) / (high - low), width / wide);
  const ground = 0.5 * (height + (high - low) * scale + ABOVE - BELOW);
  return {
    scale,
    sin,
    cos,
    at: (along, up) => {
      const [x, y] = level(along, up);
      return [0.5 * width + (x - 0.5 * (left + right)) * scale, ground - (y - low) * scale];
    },
    moved: ([x, y], along, into) => [x + along * cos + into * sin, y - along * sin + into * cos],
  };
}

/** Between which x the plane is seen, so far from the edges. */
export function seen({ at, scale, sin, cos }: Camera, { width, height }: Size, edge = 0): Place {
  const [x, y] = at(0, 0);
  const across = [(edge - x) / (scale * cos), (width - edge - x) / (scale * cos)] as const;
  if (sin === 0) return across;
  const [a, b] = [(y - edge) / (scale * sin), (y - height + edge) / (scale * sin)];
  return [Math.max(across[0], Math.min(a, b)), Math.min(across[1], Math.max(a, b))];
}

function drawGround(
  c: CanvasRenderingContext2D,
  size: Size,
  camera: Camera,
  { palette, axis }: HoopScene,
): void {
  const [from, to] = seen(camera, size);
  const { radius, unit } = axis ?? { radius: 1, unit: COLUMN_ROWS.x.units.dimensionless };
  c.setLineDash([]);
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 2;
  c.beginPath();
  c.moveTo(...camera.at(from, 0));
  c.lineTo(...camera.at(to, 0));
  c.stroke();
  c.font = font(12);
  c.fillStyle = palette.ink.soft;
  c.strokeStyle = palette.ink.soft;
  c.textAlign = 'center';
  c.lineWidth = 1;
  const last = seen(camera, size, END)[1];
  for (const { value, label } of roundTicks(
    radius * from,
    radius * last,
    Math.min(9, Math.max(3, size.width / 55)),
  )) {
    const at = camera.at(value / radius, 0);
    c.beginPath();
    c.moveTo(...at);
    c.lineTo(...camera.moved(at, 0, 6));
    c.stroke();
    c.fillText(label, ...camera.moved(at, 0, 17));
  }
  c.fillText(unit, ...camera.moved(camera.at(last, 0), 16, 22));
  c.font = font(14);
}

function drawTrails(
  c: CanvasRenderingContext2D,
  s: Samples,
  now: number,
  camera: Camera,
  { palette, isSecret }: HoopScene,
): void {
  const trail = (xs: Float64Array, ys: Float64Array, width: number): void => {
    c.lineWidth = width;
    for (let from = 0; from < s.length; ) {
      const mode = modeOf(s.mode[from]!);
      let to = from;
      while (to + 1 < s.length && s.mode[to + 1] === s.mode[from]) to++;
      c.strokeStyle = palette.mode[mode];
      for (const past of isSecret ? [true] : [false, true]) {
        setDash(c, past ? MODE_DASHES[mode] : []);
        c.globalAlpha = past ? 1 : 0.3;
        c.beginPath();
        for (let i = from; i <= to && (!past || s.time[i]! <= now); i++)
          c.lineTo(...camera.at(xs[i]!, ys[i]!));
        c.stroke();
      }
      from = to + 1;
    }
    c.globalAlpha = 1;
    c.setLineDash([]);
  };
  trail(s.x, s.centre_y, 1.5);
  trail(s.mass_centre_x, s.mass_centre_y, 2.5);
}

/** The landing of a motion that is dragged: as predicted, dashed, and as it is. */
function drawLanding(
  c: CanvasRenderingContext2D,
  camera: Camera,
  { landing, offset, palette }: HoopScene,
): void {
  if (landing === null) return;
  const { predicted, exact } = landing;
  const draw = (x: number, theta: number, colour: string): void => {
    c.strokeStyle = colour;
    c.fillStyle = colour;
    c.beginPath();
    c.arc(...camera.at(x, 1), camera.scale - 2.5, 0, 2 * Math.PI);
    c.stroke();
    c.setLineDash([]);
    c.beginPath();
    c.arc(
      ...camera.at(x - offset * Math.sin(theta), 1 + offset * Math.cos(theta)),
      5,
      0,
      2 * Math.PI,
    );
    c.fill();
  };
  c.lineWidth = 2;
  if (exact) draw(exact.x, exact.theta, palette.ink.soft);
  if (predicted) {
    c.setLineDash([6, 5]);
    c.strokeStyle = palette.ink.ink;
    c.beginPath();
    for (let i = 0; i < predicted.path.length; i += 2)
      c.lineTo(...camera.at(predicted.path[i]!, predicted.path[i + 1]!));
    c.stroke();
    draw(predicted.x, predicted.theta, palette.ink.ink);
  }
  c.setLineDash([]);
}

/** The landing by itself where the view follows the hoop, which is elsewhere. */
function drawInset(
  c: CanvasRenderingContext2D,
  size: Size,
  camera: Camera,
  scene: HoopScene,
): void {
  const { landing, palette } = scene;
  const x = landing?.exact?.x ?? landing?.predicted?.x;
  if (x === undefined) return;
  const [width, height] = [Math.min(INSET.width, size.width), INSET.height];
  const [left, top] = [size.width - width - 1, INSET.top];
  const { sin, cos } = camera;
  const [middle, ground] = [left + 0.5 * width, top + 0.78 * height];
  c.save();
  c.beginPath();
  c.rect(left, top, width, height);
  c.fillStyle = palette.ink.paper;
  c.strokeStyle = palette.ink.soft;
  c.lineWidth = 1;
  c.fill();
  c.stroke();
  c.clip();
  const at = (along: number, up: number): Place => [
    middle + INSET.scale * ((along - x) * cos - up * sin),
    ground - INSET.scale * ((along - x) * sin + up * cos),
  ];
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 2;
  c.beginPath();
  c.moveTo(...at(x - width, 0));
  c.lineTo(...at(x + width, 0));
  c.stroke();
  drawLanding(c, { ...camera, scale: INSET.scale, at }, scene);
  c.restore();
}

function drawBody(
  c: CanvasRenderingContext2D,
  camera: Camera,
  scene: HoopScene,
  sample: Sample,
): void {
  const { palette, offset } = scene;
  const [x, y] = camera.at(sample.x, sample.centre_y);
  const [px, py] = camera.at(sample.particle_x, sample.particle_y);
  const [mx, my] = camera.at(sample.mass_centre_x, sample.mass_centre_y);
  const mode = modeOf(sample.mode);

  c.strokeStyle = palette.mode[mode];
  c.lineWidth = 5;
  c.beginPath();
  c.arc(x, y, camera.scale - 2.5, 0, 2 * Math.PI);
  c.stroke();

  // Marks that turn with the hoop.
  c.strokeStyle = palette.ink.line;
  c.lineWidth = 1.5;
  for (let k = 0; k < 12; k++) {
    const angle = sample.theta + scene.slope + (k * Math.PI) / 6;
    const [ux, uy] = [-Math.sin(angle), -Math.cos(angle)];
    c.beginPath();
    c.moveTo(x + ux * (camera.scale - 6), y + uy * (camera.scale - 6));
    c.lineTo(x + ux * (camera.scale - 12), y + uy * (camera.scale - 12));
    c.stroke();
  }
  c.beginPath();
  c.moveTo(x, y);
  c.lineTo(px, py);
  c.stroke();

  c.fillStyle = palette.ink.ink;
  c.beginPath();
  c.arc(x, y, 3, 0, 2 * Math.PI);
  c.fill();
  if (offset > 0 && scene.h < offset) {
    massCentre(c, mx, my, palette);
  }
  c.fillStyle = palette.ink.ink;
  c.strokeStyle = palette.ink.paper;
  c.lineWidth = 2;
  c.beginPath();
  c.arc(px, py, Math.max(7, 0.085 * camera.scale), 0, 2 * Math.PI);
  c.fill();
  c.stroke();
  c.font = font(15, 'italic');
  c.textAlign = 'center';
  const outward = (distance: number): [number, number] => [
    x + ((px - x) / Math.max(1, Math.hypot(px - x, py - y))) * distance,
    y + ((py - y) / Math.max(1, Math.hypot(px - x, py - y))) * distance,
  ];
  const [lx, ly] = outward(Math.hypot(px - x, py - y) - Math.max(7, 0.085 * camera.scale) - 15);
  if (scene.symbols === false) return;
  const isClear = scene.h >= offset || Math.hypot(lx - mx, ly - my) > 24;
  if (offset > 0.35 && isClear)
    label(c, QUANTITY_ROWS.particle_mass_kg.sign, lx, ly, palette.ink.ink, palette.ink.paper);
  const [cx, cy] = offset > 0 ? outward(-16) : [x - 13, y - 10];
  label(c, 'C', cx, cy, palette.ink.ink, palette.ink.paper);
}

/** The usual sign of a mass centre: a disc in four quarters. */
function massCentre(c: CanvasRenderingContext2D, x: number, y: number, palette: Palette): void {
  const radius = 7;
  c.fillStyle = palette.ink.paper;
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 1.5;
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fill();
  c.fillStyle = palette.ink.ink;
  for (const from of [0, Math.PI]) {
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, radius, from, from + Math.PI / 2);
    c.closePath();
    c.fill();
  }
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.stroke();
}

function drawArrows(
  c: CanvasRenderingContext2D,
  camera: Camera,
  scene: HoopScene,
  sample: Sample,
): void {
  const { palette } = scene;
  const foot = camera.at(sample.x, 0);
  /** An arrow along the plane and out of it. */
  const draw = (from: Place, along: number, out: number, colour: string): void => {
    const [x, y] = camera.moved(from, along, -out);
    arrow(c, ...from, x - from[0], y - from[1], colour);
  };
  c.font = font(15, 'italic bold');
  if (sample.gap === 0) {
    c.fillStyle = palette.ink.ink;
    c.beginPath();
    c.arc(...foot, 4.5, 0, 2 * Math.PI);
    c.fill();
  }
  const isNamed = scene.symbols !== false;
  const unit = (WEIGHT * camera.scale) / (scene.weight?.force ?? 1);
  /** An arrow that is cut where it would leave the view: two strokes across it say so. */
  const force = (from: Place, along: number, out: number, colour: string): Place => {
    const length = Math.hypot(along, out);
    const part = Math.min(1, (LONGEST * camera.scale) / length);
    draw(from, along * part, out * part, colour);
    if (part < 1)
      cut(
        c,
        camera.moved(from, 0.8 * along * part, -0.8 * out * part),
        camera,
        along,
        palette.ink.paper,
      );
    return [along * part, out * part];
  };
  const [mx, my] = camera.at(sample.mass_centre_x, sample.mass_centre_y);
  if (scene.weight) {
    // The view is level: the weight points down whatever the slope.
    arrow(c, mx, my, 0, WEIGHT * camera.scale, palette.ink.soft);
    c.font = font(13);
    // On the side where the particle is not.
    const side = camera.at(sample.particle_x, 0)[0] > mx ? -1 : 1;
    c.textAlign = side > 0 ? 'left' : 'right';
    if (camera.scale > 45)
      label(
        c,
        scene.weight.name,
        mx + 7 * side,
        my + 0.8 * WEIGHT * camera.scale,
        palette.ink.soft,
        palette.ink.paper,
      );
    c.font = font(15, 'italic bold');
  }
  const normal = Number.isFinite(sample.normal) ? sample.normal * unit : 0;
  const friction = Number.isFinite(sample.friction) ? sample.friction * unit : 0;
  const [, up] = force(foot, 0, normal, palette.arrow.normal_force);
  if (isNamed && up >= 12) {
    // On the side where friction is not.
    const side = friction > 0 ? -1 : 1;
    c.textAlign = side > 0 ? 'left' : 'right';
    const [x, y] = camera.moved(foot, 8 * side, -up);
    label(c, SIGN.normal, x, y + 4, palette.arrow.normal_force, palette.ink.paper);
  }
  const [along] = force(foot, friction, 0, palette.arrow.friction_force);
  if (isNamed && Math.abs(along) >= 12) {
    c.textAlign = 'center';
    const at = camera.moved(foot, along + Math.sign(along) * 10, -12);
    label(c, SIGN.friction, ...at, palette.arrow.friction_force, palette.ink.paper);
  }
  if (sample.slip !== 0 && Number.isFinite(sample.slip)) {
    const below = camera.moved(foot, 0, SLIP);
    const [length] = force(below, sample.slip * SPEED * camera.scale, 0, palette.arrow.slip);
    c.textAlign = 'center';
    if (isNamed && Math.abs(length) >= 8) {
      label(
        c,
        SIGN.slip,
        ...camera.moved(below, length + Math.sign(length) * 14, 0),
        palette.arrow.slip,
        palette.ink.paper,
      );
    }
  }
}

/** Radians of the arc that shows a rate of 1, and the longest. */
const SPIN = 0.35;
const LONGEST_SPIN = 2.4;

/** Which way the hoop is turned at the start, and how fast: an arc within the rim, from the top. */
function drawSpin(
  c: CanvasRenderingContext2D,
  camera: Camera,
  { palette }: HoopScene,
  sample: Sample,
): void {
  const turn = Math.max(-LONGEST_SPIN, Math.min(LONGEST_SPIN, SPIN * sample.theta_rate));
  const radius = camera.scale - 22;
  if (Math.abs(turn) * radius < 12) return;
  const [x, y] = camera.at(sample.x, sample.centre_y);
  c.strokeStyle = palette.ink.soft;
  c.lineWidth = 3;
  c.setLineDash([]);
  c.beginPath();
  // Counterclockwise is positive, and on the screen the other way.
  const [from, to] = turn > 0 ? [-turn, 0] : [0, -turn];
  c.arc(x, y, radius, from - Math.PI / 2, to - Math.PI / 2);
  c.stroke();
  const end = -turn - Math.PI / 2;
  const way = -Math.sign(turn) * 14;
  arrow(
    c,
    x + radius * Math.cos(end) + 0.4 * way * Math.sin(end),
    y + radius * Math.sin(end) - 0.4 * way * Math.cos(end),
    -way * Math.sin(end),
    way * Math.cos(end),
    palette.ink.soft,
  );
}

/** Two strokes across an arrow that is longer than it is drawn. */
function cut(
  c: CanvasRenderingContext2D,
  [x, y]: Place,
  { moved }: Camera,
  along: number,
  paper: string,
): void {
  c.strokeStyle = paper;
  c.lineWidth = 2;
  for (const by of [-3, 3]) {
    const at: Place = along === 0 ? moved([x, y], 0, by) : moved([x, y], by, 0);
    c.beginPath();
    c.moveTo(...(along === 0 ? moved(at, -5, 2) : moved(at, -2, -5)));
    c.lineTo(...(along === 0 ? moved(at, 5, -2) : moved(at, 2, 5)));
    c.stroke();
  }
}

/** What the arrows of forces are worth. */
function drawBar(
  c: CanvasRenderingContext2D,
  { height }: Size,
  { scale }: Camera,
  text: string,
  palette: Palette,
): void {
  const [x, y, length] = [6, height - 12, WEIGHT * scale];
  c.strokeStyle = palette.ink.soft;
  c.lineWidth = 2;
  c.setLineDash([]);
  c.beginPath();
  c.moveTo(x, y - 4);
  c.lineTo(x, y + 4);
  c.moveTo(x, y);
  c.lineTo(x + length, y);
  c.moveTo(x + length, y - 4);
  c.lineTo(x + length, y + 4);
  c.stroke();
  c.font = font(12);
  c.textAlign = 'left';
  label(c, text, x + length + 8, y, palette.ink.soft, palette.ink.paper);
}

/** The contact by itself: the force of the ground, and the wedge in which friction can hold it. */
function drawContact(
  c: CanvasRenderingContext2D,
  size: Size,
  scene: HoopScene,
  sample: Sample,
  { mu_s, mu_k, words }: NonNullable<HoopScene['contact']>,
): void {
  const { palette } = scene;
  // On a phone it would hide the hoop.
  const part = size.width < NARROW ? 0.7 : 1;
  const [width, height] = [CONTACT.width * part, CONTACT.height * part];
  const top = scene.landing === null ? 1 : INSET.top;
  const [x, ground] = [1 + width / 2, top + height - 10];
  const mode = modeOf(sample.mode);
  c.save();
  c.beginPath();
  c.rect(1, top, width, height);
  c.fillStyle = palette.ink.paper;
  c.strokeStyle = palette.ink.line;
  c.lineWidth = 1;
  c.setLineDash([]);
  c.fill();
  c.stroke();
  c.clip();
  // The sides of the wedge leave the inset.
  const far = 2 * height;
  c.fillStyle = palette.region;
  c.beginPath();
  c.moveTo(x, ground);
  c.lineTo(x - mu_s * far, ground - far);
  c.lineTo(x + mu_s * far, ground - far);
  c.closePath();
  c.fill();
  c.strokeStyle = palette.curve.slip_limit;
  c.lineWidth = 1.5;
  for (const [mu, dash] of [
    [mu_s, []],
    [mu_k, [4, 3]],
  ] as const) {
    c.setLineDash([...dash]);
    c.beginPath();
    c.moveTo(x - mu * far, ground - far);
    c.lineTo(x, ground);
    c.lineTo(x + mu * far, ground - far);
    c.stroke();
  }
  c.setLineDash([]);
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 2;
  c.beginPath();
  c.moveTo(0, ground);
  c.lineTo(width + 2, ground);
  c.stroke();
  const isTouching =
    sample.gap === 0 && Number.isFinite(sample.normal) && Number.isFinite(sample.friction);
  if (isTouching) {
    const unit = (part * CONTACT.weight) / (scene.weight?.force ?? 1);
    const [along, up] = [sample.friction * unit, sample.normal * unit];
    const shown = Math.min(1, (part * CONTACT.longest) / Math.hypot(along, up));
    arrow(c, x, ground, shown * along, -shown * up, palette.ink.ink);
    if (shown < 1)
      cut(c, [x + 0.8 * shown * along, ground - 0.8 * shown * up], UPRIGHT, 0, palette.ink.paper);
  }
  c.font = `12px ${FONT}`;
  c.textAlign = 'center';
  const force = Math.hypot(sample.normal, sample.friction);
  label(
    c,
    sample.gap > 0 ? 'no contact' : force > 0 ? words[mode] : 'no force',
    x,
    top + 11,
    palette.ink.ink,
    palette.ink.paper,
  );
  c.restore();
}

/** The inset's own view: level, whatever the plane is. */
const UPRIGHT: Camera = {
  scale: 1,
  sin: 0,
  cos: 1,
  at: (x, y) => [x, -y],
  moved: ([x, y], along, into) => [x + along, y + into],
};

/** The motion that is pinned, at the same instant. */
function drawPinned(
  c: CanvasRenderingContext2D,
  camera: Camera,
  { pinned, palette }: HoopScene,
): void {
  if (!pinned) return;
  const { sample } = pinned;
  c.strokeStyle = palette.accent.teal;
  c.fillStyle = palette.accent.teal;
  c.lineWidth = 3;
  c.setLineDash([8, 5]);
  c.beginPath();
  c.arc(...camera.at(sample.x, sample.centre_y), camera.scale - 1.5, 0, 2 * Math.PI);
  c.stroke();
  c.setLineDash([]);
  c.beginPath();
  c.arc(
    ...camera.at(sample.particle_x, sample.particle_y),
    Math.max(6, 0.07 * camera.scale),
    0,
    2 * Math.PI,
  );
  c.fill();
}

/** Nothing moves: the start as it stands. */
function drawStill(
  c: CanvasRenderingContext2D,
  camera: Camera,
  { motion, palette, offset }: HoopScene,
): void {
  const { theta } = motion.events[0]!;
  c.strokeStyle = palette.ink.faint;
  c.lineWidth = 5;
  c.beginPath();
  c.arc(...camera.at(0, 1), camera.scale - 2.5, 0, 2 * Math.PI);
  c.stroke();
  c.fillStyle = palette.ink.ink;
  c.beginPath();
  c.arc(...camera.at(-offset * Math.sin(theta), 1 + offset * Math.cos(theta)), 9, 0, 2 * Math.PI);
  c.fill();
}
