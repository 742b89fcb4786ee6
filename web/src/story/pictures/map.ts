// The outcome map, in which a start is dropped.

import { inOrder } from '../../core/fields';
import { make } from '../../dom';
import type { Class } from '../../generated/tables';
import { OutcomePicture } from '../../map/client';
import {
  type Curves,
  curvesOf,
  drawMotion,
  drawPlane,
  FROM,
  Frame,
  TO,
  wrapped,
} from '../../views/plane';
import { hoopWith, linkTo, problemOf, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { degrees, fateOf, plain } from '../numbers';
import { PICTURES } from '../text';
import { Showing } from './course';

/** Rates that are shown either way. */
const RATE = 4;

export function map(picture: Picture): void {
  const says = PICTURES.map.says;
  const base = storyHoop(0);
  const showing = new Showing({ ...base, theta: 1, theta_rate: -1.2 });
  const legend = make('ul', { class: 'legend' });
  const problem = problemOf(base);
  const curves: Curves = curvesOf(problem, RATE);
  problem.free();
  let fate: Class = fateOf(showing.hoop);
  const take = (): void => {
    showing.take(hoopWith({ ...base, theta: angle.value, theta_rate: rate.value }));
    fate = fateOf(showing.hoop);
    player.go(0);
  };
  const angle = picture.slider(
    'angle',
    { min: -3.1, max: 6.2, step: 0.05, first: 1, text: (value) => degrees(value) },
    take,
  );
  const rate = picture.slider(
    'rate',
    { min: -RATE, max: RATE, step: 0.05, first: -1.2, text: (value) => plain(value) },
    take,
  );
  const player = picture.player(showing.course, showing.timeText);
  picture.controls.before(legend);

  let outcomes: OutcomePicture | null = null;
  const frame = (): Frame => new Frame(picture.size, RATE);
  picture.handle(
    () => [frame().x(wrapped(angle.value)), frame().y(rate.value)],
    (x, y) => {
      const { theta, rateAt } = { theta: frame().theta(x), rateAt: frame().rateAt(y) };
      angle.set(Math.min(Math.max(theta, FROM), TO));
      rate.set(rateAt);
    },
    true,
  );
  picture.live(
    (c, size, palette) => {
      // The map is asked for when somebody comes to see it.
      if (outcomes === null) {
        outcomes = new OutcomePicture(
          palette,
          () => {
            const present = outcomes?.present.filter((name) => name !== 'not_computed') ?? [];
            const swatch = (): HTMLElement =>
              make('span', { class: 'swatch', 'aria-hidden': 'true' });
            legend.replaceChildren(
              ...present.map((name) =>
                make('li', { 'data-class': name }, swatch(), picture.word(name)),
              ),
            );
            picture.changed();
          },
          (message) => {
            throw new Error(message);
          },
        );
        outcomes.ask({
          numbers: inOrder('dimensionless', base),
          restitution: undefined,
          law: undefined,
          rate: RATE,
          shows: 'outcome',
        });
        shown = palette;
      } else if (shown !== palette) {
        shown = palette;
        outcomes.setPalette(palette);
      }
      const now = showing.motion.at(player.time);
      drawPlane(c, new Frame(size, RATE), {
        curves,
        symbols: false,
        map: outcomes.picture,
        mapSize: outcomes.side,
        palette,
      });
      drawMotion(c, new Frame(size, RATE), showing.motion, now, palette);
    },
    () =>
      fate === 'leaves_at_once' || fate === 'lifts_off_later' || fate === 'rolls_forever'
        ? says[fate]
        : says.stays,
    () => linkTo(showing.hoop),
  );
  let shown: unknown = null;
}
