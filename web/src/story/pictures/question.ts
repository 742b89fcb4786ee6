// The question: a push, and what becomes of the hoop.

import type { Motion } from '../../core/motion';
import { linkTo, most, motionOf, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { degrees, fateOf, jumpOf, PUSH, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';
import { Showing } from './course';

const WORDS = PICTURES.question;

/** What became of it, to its end. */
function verdict(push: number): string {
  const hoop = storyHoop(push);
  const fate = fateOf(hoop);
  if (fate === 'leaves_at_once') return WORDS.says.atOnce;
  if (fate === 'rolls_forever') return WORDS.says.rolls;
  if (fate !== 'lifts_off_later') return WORDS.says.slips;
  const { motion } = motionOf(hoop);
  const said = hopSaid(motion);
  motion.free();
  return said;
}

function hopSaid(motion: Motion): string {
  const jump = jumpOf(motion);
  const lift = motion.events.find(({ name }) => name === 'lift_off');
  return fill(WORDS.says.hops, {
    turned: degrees(Math.abs(lift?.theta ?? NaN)),
    height: plain(most(motion, 'gap'), 2),
    air: degrees(jump?.turned ?? NaN),
  });
}

export function question(picture: Picture): void {
  const showing = new Showing(storyHoop(PUSH));
  const push = picture.slider('push', { min: 0.05, max: 1.3, step: 0.01, first: PUSH, text: (value) => plain(value) }, (value) => {
    showing.take(storyHoop(value));
    said = verdict(value);
    player.go(0);
  });
  let said = verdict(push.value);
  const player = picture.player(showing.course, showing.timeText);
  picture.live(
    (c, size, palette) => showing.draw(c, size, player.time, palette),
    () => said,
    () => linkTo(showing.hoop),
  );
}
