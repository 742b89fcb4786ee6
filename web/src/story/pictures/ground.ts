// What the ground has to do for Littlewood's hoop to roll: its forces, and the cone of those that
// it can give.

import type { Palette } from '../../generated/palette';
import { setDash } from '../../views/canvas';
import {
  type Box,
  disc,
  force,
  ground,
  line,
  type Point,
  plot,
  ring,
  split,
  weightOf,
  words,
} from '../draw';
import { hoopWith, linkTo, motionOf, Rolling } from '../hoops';
import type { Picture } from '../kit';
import { degrees, percent, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';

/** A normal force that is smaller is none. */
const NOTHING = 0.005;

const radians = (value: number): number => (value * Math.PI) / 180;

interface Place {
  centre: Point;
  radius: number;
  floor: number;
}

/** A hoop on the ground in a box, with room below for a pull. */
function placeIn(box: Box, below: number): Place {
  const radius = Math.min(0.27 * box.width, (box.height - below) / 3);
  const floor = box.top + box.height - below;
  return { centre: [box.left + box.width / 2, floor - radius], radius, floor };
}

/** Sets an angle by a drag of the weight. */
function dragged(place: Place, x: number, y: number): number {
  return (Math.atan2(x - place.centre[0], place.centre[1] - y) * 180) / Math.PI;
}

export function forces(picture: Picture): void {
  const says = PICTURES.forces.says;
  const hoop = hoopWith();
  const rolling = new Rolling(hoop);
  const angle = picture.slider('angle', {
    min: 0,
    max: 160,
    step: 1,
    first: 40,
    text: (value) => `${plain(value)}°`,
  });
  let place: Place = { centre: [0, 0], radius: 1, floor: 0 };
  const turned = (): number => radians(angle.value);

  const draw = (
    c: CanvasRenderingContext2D,
    size: { width: number; height: number },
    palette: Palette,
  ): void => {
    const [left, right] = split(size, 0.56);
    place = placeIn(left, 64);
    const { centre, radius, floor } = place;
    const phi = turned();
    ground(c, left, floor, radius, phi, palette);
    // The weight's cycloid, from where it began to where it would be in the end.
    c.strokeStyle = palette.ink.faint;
    c.lineWidth = 2;
    setDash(c, [3, 2]);
    line(
      c,
      ...Array.from({ length: 81 }, (_, i): Point => {
        const a = (i / 80) * Math.PI;
        return [centre[0] + (a - phi + Math.sin(a)) * radius, floor - (1 + Math.cos(a)) * radius];
      }).filter(([x]) => x < left.left + left.width - 4),
    );
    c.setLineDash([]);
    const { normal, friction } = rolling.forces(-phi);
    const colour = palette.mode.rolling;
    ring(
      c,
      {
        x: centre[0],
        y: centre[1],
        radius,
        theta: -phi,
        colour,
        dash: normal < -NOTHING ? [3, 2] : [],
      },
      palette,
    );
    const foot: Point = [centre[0], floor];
    const unit = 1.15 * radius;
    if (normal < -NOTHING) {
      c.globalAlpha = 0.85;
      force(c, foot, 0, -normal * Math.min(unit, 40), palette.arrow.impulse, '', palette);
      words(c, picture.word('pull'), [foot[0] + 14, floor + 26], palette, 'left');
      c.globalAlpha = 1;
    } else {
      force(c, foot, 0, -normal * unit, palette.arrow.normal_force, 'N', palette);
      force(c, foot, friction * unit, 0, palette.arrow.friction_force, 'F', palette);
    }
    c.fillStyle = palette.ink.ink;
    disc(c, foot, 4);
    const most = radians(160);
    const points = Array.from(
      { length: 161 },
      (_, i): Point => [radians(i), rolling.forces(-radians(i)).normal],
    );
    const zero = points.findIndex(([, n]) => n <= 0);
    plot(
      c,
      {
        box: right,
        x: [0, most],
        y: [-1.05, 1.1],
        xName: picture.word('of'),
        yName: picture.word('needed'),
        levels: [0],
        uprights:
          zero < 0 ? [] : [{ x: points[zero]![0], name: picture.word('normal_force_zero') }],
        curves: [
          { points: points.filter(([, n]) => n >= 0), colour: palette.arrow.normal_force },
          {
            points: points.filter(([, n]) => n <= 0.01),
            colour: palette.arrow.impulse,
            dash: [3, 2],
          },
        ],
        now: [phi, normal],
      },
      palette,
    );
  };
  picture.handle(
    () =>
      weightOf({
        x: place.centre[0],
        y: place.centre[1],
        radius: place.radius,
        theta: -turned(),
        colour: '',
      }),
    (x, y) => angle.set(dragged(place, x, y)),
  );
  picture.live(
    draw,
    () => {
      const { normal, friction } = rolling.forces(-turned());
      const filling = {
        angle: `${plain(angle.value)}°`,
        normal: percent(Math.abs(normal)),
        friction: percent(Math.abs(friction)),
      };
      return fill(
        normal > NOTHING ? says.pushes : normal > -NOTHING ? says.nothing : says.pulls,
        filling,
      );
    },
    () => linkTo({ ...hoop, theta: -turned(), theta_rate: rolling.rate(-turned()) }),
  );
}

/** Where the hoop stops rolling with so much friction, from rest at the top, and by what. */
function limitOf(mu: number): number {
  const { motion } = motionOf(hoopWith({ theta: -1e-3, mu_s: mu, mu_k: mu }));
  const angle = Math.abs(motion.events[1]?.theta ?? NaN);
  motion.free();
  return angle;
}

export function cone(picture: Picture): void {
  const says = PICTURES.cone.says;
  const rolling = new Rolling(hoopWith());
  const angle = picture.slider('angle', {
    min: 0,
    max: 120,
    step: 1,
    first: 30,
    text: (value) => `${plain(value)}°`,
  });
  const mu = picture.slider(
    'mu',
    { min: 0.1, max: 1.5, step: 0.05, first: 0.5, text: (value) => plain(value) },
    (value) => {
      limit = limitOf(value);
    },
  );
  let limit = limitOf(mu.value);
  let place: Place = { centre: [0, 0], radius: 1, floor: 0 };
  const turned = (): number => radians(angle.value);
  const state = (): { ratio: number; kind: keyof typeof says } => {
    const { normal, friction } = rolling.forces(-turned());
    const ratio = Math.abs(friction) / normal;
    if (normal <= NOTHING) return { ratio: Math.abs(friction / normal), kind: 'pulls' };
    return { ratio, kind: ratio <= mu.value ? 'grips' : 'slips' };
  };
  picture.handle(
    () =>
      weightOf({
        x: place.centre[0],
        y: place.centre[1],
        radius: place.radius,
        theta: -turned(),
        colour: '',
      }),
    (x, y) => angle.set(dragged(place, x, y)),
  );
  picture.live(
    (c, size, palette) => {
      place = placeIn({ left: 0, top: 0, ...size }, 34);
      place = { ...place, radius: Math.min(place.radius * 1.3, (place.floor - 12) / 2) };
      place = { ...place, centre: [place.centre[0], place.floor - place.radius] };
      const { centre, radius, floor } = place;
      const foot: Point = [centre[0], floor];
      const { kind } = state();
      const reach = 2.02 * radius;
      const spread = Math.atan(mu.value);
      c.beginPath();
      c.moveTo(...foot);
      c.arc(...foot, reach, -Math.PI / 2 - spread, -Math.PI / 2 + spread);
      c.closePath();
      c.fillStyle = palette.region;
      c.fill();
      c.strokeStyle = palette.arrow.friction_force;
      c.lineWidth = 1.5;
      setDash(c, [5, 3]);
      c.stroke();
      c.setLineDash([]);
      ground(c, { left: 0, top: 0, ...size }, floor, radius, turned(), palette);
      ring(
        c,
        {
          x: centre[0],
          y: centre[1],
          radius,
          theta: -turned(),
          colour: kind === 'grips' ? palette.mode.rolling : palette.mode.sliding,
          dash: kind === 'grips' ? [] : [4, 2],
        },
        palette,
      );
      // Its direction is what matters: it vanishes at the horizontal.
      const [wx, wy] = weightOf({
        x: centre[0],
        y: centre[1],
        radius,
        theta: -turned(),
        colour: '',
      });
      const distance = Math.max(1, Math.hypot(wx - foot[0], wy - foot[1]));
      const { normal, friction } = rolling.forces(-turned());
      const length = 0.75 * Math.min(distance, 1.2 * radius);
      const size2 = Math.hypot(normal, friction);
      const [dx, dy] = size2 > 0 ? [friction / size2, -normal / size2] : [0, -1];
      if (kind !== 'pulls')
        force(c, foot, dx * length, dy * length, palette.arrow.normal_force, '', palette);
      c.fillStyle = palette.ink.ink;
      disc(c, foot, 4);
      words(
        c,
        picture.word(kind === 'grips' ? 'grips' : 'slips'),
        [size.width - 8, 20],
        palette,
        'right',
        17,
      );
    },
    () => {
      const { ratio, kind } = state();
      return fill(says[kind], {
        angle: `${plain(angle.value)}°`,
        ratio: plain(ratio, 2),
        mu: plain(mu.value),
        limit: degrees(limit),
      });
    },
    () =>
      linkTo(
        hoopWith({
          theta: -turned(),
          theta_rate: rolling.rate(-turned()),
          mu_s: mu.value,
          mu_k: mu.value,
        }),
      ),
  );
}
