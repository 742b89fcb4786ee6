// Slow motion of the lift-off.

import type { Motion } from '../../core/motion';
import { drawHoop } from '../../views/hoop';
import { type Point, plot, split } from '../draw';
import { linkTo, motionOf, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { PUSH, percent, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';

/** How long before and after the lift-off is shown. */
const AROUND = 0.5;

/** By how much the gap is drawn larger than N. */
const LARGER = 10;

export function liftoff(picture: Picture): void {
  const says = PICTURES.liftoff.says;
  let motion!: Motion;
  let h = 0;
  let hoop = storyHoop(PUSH);
  let instant = 0;
  const take = (push: number): void => {
    motion?.free();
    hoop = storyHoop(push);
    ({ motion, h } = motionOf(hoop));
    instant = motion.events.find(({ name }) => name === 'lift_off')?.time ?? motion.begin;
  };
  take(PUSH);
  picture.slider(
    'push',
    { min: 0.8, max: 1.1, step: 0.01, first: PUSH, text: (value) => plain(value) },
    (value) => {
      take(value);
      player.go(instant - AROUND);
    },
  );
  const player = picture.player(
    () => ({ from: instant - AROUND, to: instant + AROUND, stops: [instant], speed: 0.2 }),
    (time) => `${plain(time - instant, 2)} √(R/g)`,
    instant,
  );
  picture.live(
    (c, size, palette) => {
      const [left, right] = split(size, 0.45);
      const sample = motion.at(player.time);
      const box = { width: left.width, height: left.height };
      drawHoop(c, box, {
        motion,
        sample,
        offset: 1,
        h,
        slope: 0,
        follow: true,
        landing: null,
        palette,
      });
      const [from, to] = [instant - AROUND, instant + AROUND];
      const column = (name: 'normal' | 'gap', factor: number): Point[] =>
        Array.from({ length: 161 }, (_, i): Point => {
          const time = from + (i / 160) * (to - from);
          return [time, (motion.at(time)?.[name] ?? NaN) * factor];
        });
      const [normal, gap] = [column('normal', 1), column('gap', LARGER)];
      const most = Math.max(...normal.map(([, y]) => y), ...gap.map(([, y]) => y));
      plot(
        c,
        {
          box: right,
          x: [from, to],
          y: [-0.04 * most, 1.06 * most],
          xName: picture.word('of'),
          yName: fill(picture.word('force'), { times: plain(LARGER) }),
          levels: [0],
          uprights: [{ x: instant, name: picture.word('instant') }],
          curves: [
            { points: normal, colour: palette.arrow.normal_force },
            { points: gap, colour: palette.mode.flight, dash: [3, 1.5] },
          ],
          now: [
            player.time,
            player.time <= instant ? (sample?.normal ?? NaN) : (sample?.gap ?? NaN) * LARGER,
          ],
        },
        palette,
      );
    },
    () => {
      const sample = motion.at(player.time);
      const filling = { normal: percent(sample?.normal ?? NaN), gap: percent(sample?.gap ?? NaN) };
      return fill(player.time <= instant ? says.before : says.after, filling);
    },
    () => linkTo(hoop, {}, { time: player.time }),
  );
}
