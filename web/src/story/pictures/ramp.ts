// Slopes: the disc that jumps on a ramp, and the one that climbs.

import { climbingDisc, linkTo, rampDisc } from '../hoops';
import type { Picture } from '../kit';
import {
  CLIMB,
  climbOf,
  millimetres,
  plain,
  RAMP,
  RAMP_RADIUS,
  RAMP_RADIUS_M,
  slipsOf,
} from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';
import { Showing } from './course';

const radians = (value: number): number => (value * Math.PI) / 180;

const inDegrees = (value: number): string => `${plain(value)}°`;

/** Long enough for a jump on the gentlest slope. */
const LONG = 20;

export function ramp(picture: Picture): void {
  const says = PICTURES.ramp.says;
  const showing = new Showing(rampDisc(RAMP.slope, RAMP.theta), {}, LONG);
  const take = (): void => {
    showing.take(rampDisc(radians(slope.value), radians(release.value)));
    player.go(0);
  };
  const slope = picture.slider(
    'slope',
    { min: 10, max: 45, step: 1, first: 30, text: inDegrees },
    take,
  );
  const release = picture.slider(
    'release',
    { min: -180, max: 180, step: 5, first: 30, text: inDegrees },
    take,
  );
  const player = picture.player(showing.course, showing.timeText);
  picture.live(
    (c, size, palette) => showing.draw(c, size, player.time, palette),
    () => {
      if (!showing.motion.events.some(({ name }) => name === 'lift_off')) return says.stays;
      const slip = millimetres(slipsOf(showing.motion).at(-1)! * RAMP_RADIUS_M);
      return fill(says.jumps, { radius: RAMP_RADIUS, slip });
    },
    () => linkTo(showing.hoop),
  );
}

export function climb(picture: Picture): void {
  const says = PICTURES.climb.says;
  const disc = (): Parameters<typeof climbingDisc> => [
    radians(slope.value),
    -radians(uphill.value),
  ];
  const showing = new Showing(climbingDisc(CLIMB.slope, CLIMB.theta));
  const take = (): void => {
    showing.take(climbingDisc(...disc()));
    player.go(0);
  };
  const slope = picture.slider(
    'slope',
    { min: 1, max: 30, step: 0.5, first: (CLIMB.slope * 180) / Math.PI, text: inDegrees },
    take,
  );
  const uphill = picture.slider(
    'release',
    { min: 0, max: 180, step: 1, first: (-CLIMB.theta * 180) / Math.PI, text: inDegrees },
    take,
  );
  const player = picture.player(showing.course, showing.timeText);
  picture.live(
    (c, size, palette) => showing.draw(c, size, player.time, palette, false),
    () => {
      const height = climbOf(showing.motion, showing.hoop.slope);
      return height > 0.005 ? fill(says.climbs, { height: plain(height, 2) }) : says.falls;
    },
    () => linkTo(showing.hoop, {}, { follow: false }),
  );
}
