// What follows the flight: bounces; and a contact that jams.

import { modeOf } from '../../core/motion';
import { type Point, plot, split } from '../draw';
import { jammingHoop, linkTo, most } from '../hoops';
import type { Picture } from '../kit';
import { BOUNCE, FIGURE_3, percent, plain } from '../numbers';
import { fill } from '../rich';
import { MODES, PICTURES } from '../text';
import { Showing } from './course';

/** Columns of the samples of a motion as a curve. */
function curve(showing: Showing, column: 'gap' | 'slip', until: number): Point[] {
  const { samples } = showing.motion;
  return Array.from(samples.time, (time, i): Point => [time, samples[column][i]!]).filter(
    ([time]) => time <= until,
  );
}

export function bounce(picture: Picture): void {
  const says = PICTURES.bounce.says;
  const showing = new Showing(FIGURE_3, { restitution: BOUNCE }, 24);
  const slider = picture.slider(
    'restitution',
    { min: 0, max: 1, step: 0.05, first: BOUNCE, text: (value) => plain(value) },
    (value) => {
      showing.take(FIGURE_3, { restitution: value });
      player.go(0);
    },
  );
  const player = picture.player(showing.course, showing.timeText);
  picture.live(
    (c, size, palette) => {
      const [left, right] = split(size, 0.5);
      const box = { width: left.width, height: left.height };
      const now = showing.draw(c, box, player.time, palette);
      const highest = Math.max(most(showing.motion, 'gap'), 0.1);
      const { begin, end } = showing.motion;
      plot(
        c,
        {
          box: right,
          x: [begin, end],
          y: [-0.04 * highest, 1.06 * highest],
          xName: picture.word('of'),
          yName: picture.word('gap'),
          levels: [0],
          curves: [{ points: curve(showing, 'gap', end), colour: palette.mode.flight }],
          now: now ? [player.time, now.gap] : null,
        },
        palette,
      );
    },
    () => {
      const { events, phases } = showing.motion;
      const strikes = events.filter(({ name }) => name === 'landing').length;
      const settles = events.some(({ name }) => name === 'settle');
      const last = phases.at(-1);
      const filling = { count: plain(strikes), mode: MODES[last?.mode ?? 'rolling'] };
      return fill(
        settles ? says.bounces : slider.value === 0 && strikes === 1 ? says.never : says.counted,
        filling,
      );
    },
    () => linkTo(FIGURE_3, { restitution: slider.value }, { time: player.time }),
  );
}

/** How much of the motion is shown: to the end of its first slip, and a little more. */
const JAM_SHOWN = 1;

export function jam(picture: Picture): void {
  const says = PICTURES.jam.says;
  const first = 0.4;
  const showing = new Showing(jammingHoop(first), { restitution: 0 }, JAM_SHOWN, 0.25);
  const slider = picture.slider(
    'mu',
    { min: 0.1, max: 1, step: 0.02, first, text: (value) => plain(value) },
    (value) => {
      showing.take(jammingHoop(value), { restitution: 0 });
      player.go(0);
    },
  );
  const player = picture.player(showing.course, showing.timeText);
  const jams = (): boolean => showing.motion.events[1]?.name === 'jam';
  picture.live(
    (c, size, palette) => {
      const [left, right] = split(size, 0.5);
      const now = showing.draw(c, { width: left.width, height: left.height }, player.time, palette);
      const slip = curve(showing, 'slip', JAM_SHOWN);
      const start = showing.hoop.slip;
      plot(
        c,
        {
          box: right,
          x: [-0.05, JAM_SHOWN],
          y: [Math.min(-0.1, ...slip.map(([, y]) => y)), 1.1 * start],
          xName: picture.word('of'),
          yName: picture.word('slip'),
          levels: [0],
          curves: [{ points: [[-0.05, start], [0, start], ...slip], colour: palette.arrow.slip }],
          now: now ? [player.time, now.slip] : null,
        },
        palette,
      );
    },
    () => {
      if (jams()) return says.jams;
      const end = showing.motion.phases[0]?.end ?? NaN;
      const { samples } = showing.motion;
      let largest = 0;
      for (
        let i = 0;
        i < samples.length && samples.time[i]! <= end && modeOf(samples.mode[i]!) === 'sliding';
        i++
      )
        largest = Math.max(largest, samples.normal[i]!);
      return fill(says.slides, { time: plain(end, 2), normal: percent(largest) });
    },
    () => linkTo(jammingHoop(slider.value), { restitution: 0 }),
  );
}
