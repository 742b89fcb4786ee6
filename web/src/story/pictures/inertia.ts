// Inertia that is taken away: what light hoops do, and the hoop with none.

import type { Motion } from '../../core/motion';
import { modeOf } from '../../core/motion';
import { MODE_DASHES } from '../../generated/palette';
import { setDash } from '../../views/canvas';
import { disc, force, ground, line, type Point, ring } from '../draw';
import { FIGURE_7, type Hoop, hoopWith, linkTo, motionOf, type Run } from '../hoops';
import type { Picture } from '../kit';
import { distanceOf, percent, plain } from '../numbers';
import { fill } from '../rich';
import { MODES, PICTURES } from '../text';

/** The slider's last step is no inertia; each step before is a tenth of a power of ten. */
const LAST = 50;

function inertiaAt(step: number): number {
  return step >= LAST ? 0 : 10 ** (-step / 10);
}

export function inertia(picture: Picture): void {
  const says = PICTURES.inertia.says;
  const none = motionOf(hoopWith(FIGURE_7)).motion;
  let hoop: Hoop = hoopWith();
  let run: Run = {};
  let motion: Motion | null = null;
  let distance = 0;
  const take = (value: number): void => {
    hoop = hoopWith({ ...FIGURE_7, inertia: value });
    run = { until: none.end };
    motion?.free();
    motion = motionOf(hoop, run).motion;
    distance = value === 0 ? 0 : distanceOf(motion, none);
  };
  const text = (step: number): string =>
    step >= LAST ? picture.word('none') : plain(inertiaAt(step), 2);
  const slider = picture.slider(
    'inertia',
    { min: 0, max: LAST, step: 1, first: 10, text },
    (step) => take(inertiaAt(step)),
  );
  take(inertiaAt(slider.value));
  const player = picture.player(
    () => ({ from: 0, to: none.end, stops: none.events.map(({ time }) => time), speed: 0.9 }),
    (time) => `${plain(time)} √(R/g)`,
    0.8 * none.end,
  );

  picture.live(
    (c, { width, height }, palette) => {
      const now = motion?.at(player.time);
      if (!motion || !now) return;
      const floor = height - 30;
      const radius = Math.min((floor - 20) / 2, width / 5.2);
      const left = 1.25 * radius;
      const at = (x: number, y: number): Point => [left + x * radius, floor - y * radius];
      ground(c, { left: 0, top: 0, width, height }, floor, radius, 0, palette);
      const path = (of: Motion, until: number): Point[] =>
        Array.from({ length: 121 }, (_, i) => {
          const sample = of.at((i / 120) * until);
          return sample ? at(sample.particle_x, sample.particle_y) : ([NaN, NaN] as const);
        });
      c.lineWidth = 4;
      c.strokeStyle = palette.accent.violet;
      line(c, ...path(motion, none.end));
      c.strokeStyle = palette.ink.ink;
      c.lineWidth = 2;
      setDash(c, [4, 3]);
      line(c, ...path(none, none.end));
      c.setLineDash([]);
      const [x, y] = at(now.x, now.centre_y);
      const mode = modeOf(now.mode);
      ring(
        c,
        { x, y, radius, theta: now.theta, colour: palette.mode[mode], dash: MODE_DASHES[mode] },
        palette,
      );
      const bare = none.at(player.time);
      if (bare) {
        c.strokeStyle = palette.ink.ink;
        c.lineWidth = 2;
        c.beginPath();
        c.arc(...at(bare.particle_x, bare.particle_y), Math.max(8, 0.12 * radius), 0, 2 * Math.PI);
        c.stroke();
      }
      const foot = at(now.x, 0);
      const unit = 1.1 * radius;
      force(c, foot, 0, -now.normal * unit, palette.arrow.normal_force, 'N', palette);
      force(c, foot, now.friction * unit, 0, palette.arrow.friction_force, 'F', palette);
      c.fillStyle = palette.ink.ink;
      if (now.gap === 0) disc(c, foot, 4);
    },
    () => {
      const now = motion?.at(player.time);
      if (!now) return '';
      const filling = {
        inertia: text(slider.value),
        distance: percent(distance),
        mode: MODES[modeOf(now.mode)],
        normal: percent(now.normal),
      };
      return fill(slider.value >= LAST ? says.none : says.light, filling);
    },
    () => linkTo(hoop, {}, { time: player.time }),
  );
}
