// The hoop, to scale on the plane: particle, mass centre, contact point, forces, slip velocity and trails.

import { type Motion, modeOf, type Sample, type Samples } from '../core/motion';
import { roundTicks } from '../core/ticks';
import { MODE_DASHES, type Palette } from '../generated/palette';
import { COLUMN_ROWS, QUANTITY_ROWS } from '../generated/tables';
import { arrow, label, type Size, setDash } from './canvas';
import { FONT } from './font';

export interface HoopScene {
  motion: Motion;
  sample: Sample | null;
  /** ℓ̂ and h. */
  offset: number;
  h: number;
  follow: boolean;
  palette: Palette;
}

/** Pixels under the plane, for the scale and the slip velocity, and over the highest point. */
const BELOW = 58;
const ABOVE = 14;

/** Where the slip velocity is drawn, under the plane. */
const SLIP = 40;

/** Radii that are seen to the side at least. */
const WIDE = 3.5;

const SIGN = {
  normal: COLUMN_ROWS.normal.signs.dimensionless,
  friction: COLUMN_ROWS.friction.signs.dimensionless,
  slip: COLUMN_ROWS.slip.signs.dimensionless,
};

interface Camera {
  scale: number;
  x(x: number): number;
  y(y: number): number;
}

export function drawHoop(c: CanvasRenderingContext2D, size: Size, scene: HoopScene): void {
  const { motion, sample, palette } = scene;
  c.font = `14px ${FONT}`;
  c.textBaseline = 'middle';
  if (!sample) {
    drawStill(c, size, scene);
    return;
  }
  const camera = cameraOf(size, scene, sample.x);
  drawGround(c, size, camera, palette);
  drawTrails(c, motion.samples, sample.time, camera, palette);
  drawBody(c, camera, scene, sample);
  drawArrows(c, camera, scene, sample);
}

function cameraOf({ width, height }: Size, { motion, follow }: HoopScene, now: number): Camera {
  const { samples } = motion;
  let gap = 0;
  let [least, most] = [now, now];
  for (let i = 0; i < samples.length; i++) {
    gap = Math.max(gap, samples.gap[i]!);
    least = Math.min(least, samples.x[i]!);
    most = Math.max(most, samples.x[i]!);
  }
  const wide = follow ? WIDE : most - least + WIDE - 0.8;
  const scale = Math.min((height - BELOW - ABOVE) / (2 + gap), width / wide);
  const centre = follow ? now : 0.5 * (least + most);
  const ground = 0.5 * (height + (2 + gap) * scale + ABOVE - BELOW);
  return { scale, x: (x) => 0.5 * width + (x - centre) * scale, y: (y) => ground - y * scale };
}

function drawGround(c: CanvasRenderingContext2D, { width }: Size, camera: Camera, palette: Palette): void {
  const y = camera.y(0);
  c.setLineDash([]);
  c.strokeStyle = palette.ink.ink;
  c.lineWidth = 2;
  c.beginPath();
  c.moveTo(0, y);
  c.lineTo(width, y);
  c.stroke();
  const left = -camera.x(0) / camera.scale;
  c.font = `12px ${FONT}`;
  c.fillStyle = palette.ink.soft;
  c.strokeStyle = palette.ink.soft;
  c.textAlign = 'center';
  c.lineWidth = 1;
  for (const { value, label } of roundTicks(left, left + width / camera.scale, 9)) {
    const at = camera.x(value);
    c.beginPath();
    c.moveTo(at, y);
    c.lineTo(at, y + 6);
    c.stroke();
    c.fillText(label, at, y + 17);
  }
  c.font = `14px ${FONT}`;
}

function drawTrails(c: CanvasRenderingContext2D, s: Samples, now: number, camera: Camera, palette: Palette): void {
  const trail = (xs: Float64Array, ys: Float64Array, width: number): void => {
    c.lineWidth = width;
    for (let from = 0; from < s.length; ) {
      const mode = modeOf(s.mode[from]!);
      let to = from;
      while (to + 1 < s.length && s.mode[to + 1] === s.mode[from]) to++;
      c.strokeStyle = palette.mode[mode];
      for (const past of [false, true]) {
        setDash(c, past ? MODE_DASHES[mode] : []);
        c.globalAlpha = past ? 1 : 0.3;
        c.beginPath();
        for (let i = from; i <= to && (!past || s.time[i]! <= now); i++) c.lineTo(camera.x(xs[i]!), camera.y(ys[i]!));
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

function drawBody(c: CanvasRenderingContext2D, camera: Camera, scene: HoopScene, sample: Sample): void {
  const { palette, offset } = scene;
  const [x, y] = [camera.x(sample.x), camera.y(sample.centre_y)];
  const [px, py] = [camera.x(sample.particle_x), camera.y(sample.particle_y)];
  const [mx, my] = [camera.x(sample.mass_centre_x), camera.y(sample.mass_centre_y)];
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
    const angle = sample.theta + (k * Math.PI) / 6;
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
  c.font = `italic 15px ${FONT}`;
  c.textAlign = 'center';
  const outward = (distance: number): [number, number] => [
    x + ((px - x) / Math.max(1, Math.hypot(px - x, py - y))) * distance,
    y + ((py - y) / Math.max(1, Math.hypot(px - x, py - y))) * distance,
  ];
  const [lx, ly] = outward(Math.hypot(px - x, py - y) - 22);
  if (offset > 0.35) label(c, QUANTITY_ROWS.particle_mass_kg.sign, lx, ly, palette.ink.ink, palette.ink.paper);
  label(c, 'C', x - 13, y - 10, palette.ink.ink, palette.ink.paper);
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

function drawArrows(c: CanvasRenderingContext2D, camera: Camera, scene: HoopScene, sample: Sample): void {
  const { palette, motion } = scene;
  const [x, y] = [camera.x(sample.x), camera.y(0)];
  c.font = `italic bold 15px ${FONT}`;
  if (sample.gap === 0) {
    c.fillStyle = palette.ink.ink;
    c.beginPath();
    c.arc(x, y, 4.5, 0, 2 * Math.PI);
    c.fill();
  }
  let strongest = 1;
  for (const normal of motion.samples.normal) if (Number.isFinite(normal)) strongest = Math.max(strongest, normal);
  const unit = (1.25 * camera.scale) / strongest;
  const normal = sample.normal * unit;
  const friction = sample.friction * unit;
  arrow(c, x, y, 0, -normal, palette.arrow.normal_force);
  if (normal >= 12) {
    c.textAlign = 'left';
    label(c, SIGN.normal, x + 8, y - normal + 4, palette.arrow.normal_force, palette.ink.paper);
  }
  arrow(c, x, y, friction, 0, palette.arrow.friction_force);
  if (Math.abs(friction) >= 12) {
    c.textAlign = 'center';
    label(c, SIGN.friction, x + friction + Math.sign(friction) * 10, y - 12, palette.arrow.friction_force, palette.ink.paper);
  }
  if (sample.slip !== 0 && Number.isFinite(sample.slip)) {
    let fastest = 1;
    for (const slip of motion.samples.slip) if (Number.isFinite(slip)) fastest = Math.max(fastest, Math.abs(slip));
    const below = y + SLIP;
    const length = (sample.slip / fastest) * 1.2 * camera.scale;
    arrow(c, x, below, length, 0, palette.arrow.slip);
    c.textAlign = 'center';
    if (Math.abs(length) >= 8) {
      label(c, SIGN.slip, x + length + Math.sign(length) * 14, below, palette.arrow.slip, palette.ink.paper);
    }
  }
}

/** Nothing moves: the start as it stands. */
function drawStill(c: CanvasRenderingContext2D, size: Size, { motion, palette, offset }: HoopScene): void {
  const scale = Math.min((size.height - BELOW - ABOVE) / 2, size.width / WIDE);
  const ground = 0.5 * (size.height + 2 * scale + ABOVE - BELOW);
  const camera: Camera = { scale, x: (x) => 0.5 * size.width + x * scale, y: (y) => ground - y * scale };
  drawGround(c, size, camera, palette);
  const { theta } = motion.events[0]!;
  c.strokeStyle = palette.ink.faint;
  c.lineWidth = 5;
  c.beginPath();
  c.arc(camera.x(0), camera.y(1), scale - 2.5, 0, 2 * Math.PI);
  c.stroke();
  c.fillStyle = palette.ink.ink;
  c.beginPath();
  c.arc(camera.x(-offset * Math.sin(theta)), camera.y(1 + offset * Math.cos(theta)), 9, 0, 2 * Math.PI);
  c.fill();
}
