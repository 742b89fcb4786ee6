// The numbers of the text, computed by the library when the page begins.

import { HULA_SECOND } from '../core/fields';
import type { Event, Motion } from '../core/motion';
import { classOf } from '../core/wasm';
import { brief } from '../dom';
import { CLASSES, type Class } from '../generated/tables';
import { withMark } from '../language';
import {
  climbingDisc,
  FIGURE_7,
  type Hoop,
  hoopWith,
  jammingHoop,
  most,
  motionOf,
  problemOf,
  Rolling,
  rampDisc,
  slipped,
  storyHoop,
  thinHoop,
} from './hoops';
import type { Filling } from './rich';
import { DECIMAL } from './text';

/** The usual number of digits. */
const DIGITS = 3;

export function plain(value: number, digits = DIGITS): string {
  return withMark(brief(value, digits), DECIMAL);
}

export function degrees(angle: number, digits = DIGITS): string {
  return `${plain((angle * 180) / Math.PI, digits)}°`;
}

/** A part of one, in per cent where that is short. */
export function percent(part: number, digits = 2): string {
  return `${plain(100 * part, digits)}\u00a0%`;
}

export function millimetres(metres: number): string {
  return `${plain(1000 * metres, 2)}\u00a0mm`;
}

/** The radius of the disc on the ramp, in metres and in words. */
export const RAMP_RADIUS_M = 0.05;
export const RAMP_RADIUS = `${plain(100 * RAMP_RADIUS_M)}\u00a0cm`;

/** A class of the motion of a hoop. */
export function fateOf(hoop: Hoop): Class {
  const problem = problemOf(hoop);
  const fate = CLASSES[classOf(problem)]!;
  problem.free();
  return fate;
}

/** Where a condition that holds at `yes` and fails at `no` ends. */
export function boundary(yes: number, no: number, holds: (value: number) => boolean): number {
  let [inside, outside] = [yes, no];
  // Far below the digits that are shown.
  for (let i = 0; i < 18; i++) {
    const middle = 0.5 * (inside + outside);
    if (holds(middle)) inside = middle;
    else outside = middle;
  }
  return 0.5 * (inside + outside);
}

/** A hoop in the instant of its lift-off, so far before the top: its slide ends where the mass centre's circling balances gravity. */
export function liftingOff(hoop: Hoop, before: number): Hoop {
  const problem = problemOf(hoop);
  const { h } = problem;
  problem.free();
  return { ...hoop, theta: before, theta_rate: -1 / Math.sqrt(h * Math.cos(before)), slip: -0.5 };
}

/** The angle that a motion turns through from its lift-off to its landing, and both. */
export function jumpOf(motion: Motion): { turned: number; from: number; to: number } | null {
  const events = motion.events;
  const landing = events.findIndex(({ name }) => name === 'landing');
  if (landing < 0) return null;
  const before = events[landing - 1]!;
  return {
    turned: Math.abs(events[landing]!.theta - before.theta),
    from: before.time,
    to: events[landing]!.time,
  };
}

/** The three hoops that jump by one angle: of three masses, offsets and inertias. */
export const THREE: readonly Hoop[] = [
  thinHoop(3, { offset: 1, mu_s: 0.5, mu_k: 0.4 }),
  hoopWith({ mass_ratio: 1, offset: 0.8, inertia: 0.5, mu_s: 0.3, mu_k: 0.2 }),
  thinHoop(0.05, { mu_s: 0.8, mu_k: 0.6 }),
];

/** By which angle a hoop turns in the air if it lifts off so far before the top. */
export function turnOf(hoop: Hoop, before: number): number {
  const { motion } = motionOf(liftingOff(hoop, before));
  const turned = jumpOf(motion)?.turned ?? NaN;
  motion.free();
  return turned;
}

/** How the weight of a hoop with little inertia strays from that of a hoop with none, from the start of Figure 7 to the ground. */
export function strays(inertia: number): number {
  const bare = motionOf(hoopWith(FIGURE_7)).motion;
  const light = motionOf(hoopWith({ ...FIGURE_7, inertia }), { until: bare.end }).motion;
  const distance = distanceOf(light, bare);
  bare.free();
  light.free();
  return distance;
}

/** The largest distance between the weights of two motions, at the same time. */
export function distanceOf(a: Motion, b: Motion): number {
  const end = Math.min(a.end, b.end);
  let largest = 0;
  for (let i = 0; i <= 100; i++) {
    const time = (i / 100) * end;
    const [p, q] = [a.at(time), b.at(time)];
    if (p && q)
      largest = Math.max(
        largest,
        Math.hypot(p.particle_x - q.particle_x, p.particle_y - q.particle_y),
      );
  }
  return largest;
}

/** The push of the hop in the text. */
export const PUSH = 0.9;

/** The rolling resistance of the real hoop of the race, over its radius. */
export const REAL_RESISTANCE = 0.01;

/** The film of a hula hoop. */
export const FILM_RATE = 240;

/** The start of the motion of Figure 3 of the paper, mirrored so that it goes to the right. */
export const FIGURE_3 = thinHoop(1, { theta: -Math.PI / 2, theta_rate: -2 });

export const BOUNCE = 0.5;

export const RAMP = { slope: Math.PI / 6, theta: Math.PI / 6 } as const;

export const CLIMB = { slope: (8.5 * Math.PI) / 180, theta: (-57 * Math.PI) / 180 } as const;

/** The slips of a motion, in the order of its slides, over R. */
export function slipsOf(motion: Motion): number[] {
  return motion.phases
    .filter(({ mode }) => mode === 'sliding')
    .map(({ start, end }) => slipped(motion, start, end));
}

/** By how much the centre of a disc rises on its slope, over R. */
export function climbOf(motion: Motion, slope: number): number {
  return Math.max(0, most(motion, 'x')) * Math.sin(slope);
}

export function numbersOfText(): Filling {
  const found: Record<string, string> = {};

  const nudged = { theta: -1e-3 };
  const rough = motionOf(hoopWith({ ...nudged, mu_s: 10, mu_k: 10 })).motion;
  const zero = rough.events.find(({ name }) => name === 'normal_force_zero')!;
  const rolling = new Rolling(hoopWith());
  const near = rolling.forces(zero.theta + 1e-4);
  found['rolling.zero'] = degrees(Math.abs(zero.theta));
  found['rolling.friction'] = plain(Math.abs(near.friction) / near.normal, 2);
  rough.free();

  const slips = hoopWith(nudged);
  const skid = motionOf(slips).motion;
  found['cone.mu'] = plain(slips.mu_s);
  found['cone.angle'] = degrees(Math.abs(skid.events.find(({ name }) => name === 'slip')!.theta));
  skid.free();

  found['light.thousandth'] = percent(strays(1e-3));
  found['light.ratio'] = plain(strays(1e-3) / strays(1e-4), 2);

  const story = storyHoop(PUSH);
  const { motion } = motionOf(story);
  const [slip, stick, again, lift] = (['slip', 'stick', 'slip', 'lift_off'] as const).map(
    (name, i) => {
      const event = motion.events[i + 1];
      if (event?.name !== name) throw new Error(`the hoop of the story has no ${name} there`);
      return event;
    },
  ) as [Event, Event, Event, Event];
  found['story.ratio'] = plain(1 / story.mass_ratio);
  found['hop.push'] = plain(PUSH);
  found['hop.slip'] = degrees(Math.abs(slip.theta));
  found['hop.stick'] = degrees(Math.abs(stick.theta));
  found['hop.again'] = degrees(Math.abs(again.theta));
  found['hop.before'] = degrees(2 * Math.PI - Math.abs(lift.theta));
  found['hop.height'] = plain(most(motion, 'gap'), 2);
  const hops = (push: number): boolean => fateOf(storyHoop(push)) === 'lifts_off_later';
  found['push.least'] = plain(boundary(PUSH, 0.2, hops));
  found['push.most'] = plain(boundary(PUSH, 2, hops));

  const { from, to } = jumpOf(motion)!;
  found['film.rate'] = plain(FILM_RATE);
  found['film.time'] = plain((to - from) * HULA_SECOND, 2);
  found['film.count'] = plain(Math.floor((to - from) * HULA_SECOND * FILM_RATE));
  motion.free();

  const eighth = Math.PI / 4;
  found['angle.example'] = degrees(eighth);
  found['angle.turned'] = degrees(turnOf(THREE[0]!, eighth));
  found['angle.small'] = plain(turnOf(THREE[0]!, 0.01) / 0.01, 2);
  found['angle.whole'] = degrees(
    boundary(1, 1.35, (before) => turnOf(THREE[0]!, before) < 2 * Math.PI),
  );

  found['race.resistance'] = plain(REAL_RESISTANCE);
  found['bounce.e'] = plain(BOUNCE);

  const jams = (mu: number): boolean => {
    const jam = motionOf(jammingHoop(mu), { restitution: 0, until: 0.01 }).motion;
    const is = jam.events[1]?.name === 'jam';
    jam.free();
    return is;
  };
  found['jam.mu'] = plain(boundary(0.9, 0.2, jams), 2);

  const ramp = motionOf(rampDisc(RAMP.slope, RAMP.theta)).motion;
  const before = slipsOf(ramp);
  found['ramp.radius'] = RAMP_RADIUS;
  found['ramp.release'] = degrees(RAMP.theta);
  found['ramp.slope'] = degrees(RAMP.slope);
  found['ramp.slip'] = millimetres(before.at(-1)! * RAMP_RADIUS_M);
  found['ramp.earlier'] = millimetres(before.at(-2)! * RAMP_RADIUS_M);
  ramp.free();

  const climb = motionOf(climbingDisc(CLIMB.slope, CLIMB.theta)).motion;
  found['climb.height'] = plain(climbOf(climb, CLIMB.slope), 2);
  climb.free();

  return found;
}
