// The question: a push, and what becomes of the hoop.

import { HULA_SECOND } from '../../core/fields';
import { STILL } from '../../dom';
import { type Hoop, linkTo, most, motionOf, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { degrees, fateOf, jumpOf, PUSH, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';
import { Showing } from './course';

const SAYS = PICTURES.question.says;

/** What becomes of it, to its end. */
function verdict(hoop: Hoop): string {
  const fate = fateOf(hoop);
  if (fate === 'leaves_at_once') return SAYS.atOnce;
  if (fate === 'rolls_forever') return SAYS.rolls;
  if (fate !== 'lifts_off_later') return SAYS.slips;
  const { motion } = motionOf(hoop);
  const lift = motion.events.find(({ name }) => name === 'lift_off');
  const said = fill(SAYS.hops, {
    turned: degrees(Math.abs((lift?.theta ?? NaN) - hoop.theta)),
    height: plain(most(motion, 'gap'), 2),
    air: degrees(jumpOf(motion)?.turned ?? NaN),
  });
  motion.free();
  return said;
}

export function question(picture: Picture): void {
  let hoop = storyHoop(PUSH);
  const showing = new Showing(hoop);
  const take = (next: Hoop): void => {
    hoop = next;
    showing.take(hoop);
    said = verdict(hoop);
    player.go(0);
  };
  const push = picture.slider(
    'push',
    { min: 0, max: 1.3, step: 0.01, first: PUSH, text: (value) => plain(value) },
    (value) => {
      take(storyHoop(value));
    },
  );
  let said = verdict(hoop);
  const player = picture.player(showing.course, showing.timeText);
  picture.hold(
    (palette) => ({
      scene: () => showing.scene(player.time, palette()),
      start: () => hoop,
      set: (start) => {
        take({ ...hoop, ...start });
        // The slider has the pushes at the top alone.
        push.show(-hoop.theta_rate);
      },
      grabbed: () => player.pause(),
      released: () => {
        if (!STILL.matches) player.play();
      },
      second: HULA_SECOND,
      say: ({ theta, theta_rate }) =>
        fill(picture.word('where'), { angle: degrees(-theta), rate: plain(-theta_rate) }),
    }),
    () => said,
    () => linkTo(hoop),
  );
}
