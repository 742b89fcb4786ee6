// The answer: which hoops hop, and which pushes make them.

import { make } from '../../dom';
import type { Palette } from '../../generated/palette';
import type { Class } from '../../generated/tables';
import { type Point, words } from '../draw';
import { type Hoop, linkTo, most, motionOf, thinHoop } from '../hoops';
import type { Picture } from '../kit';
import { fateOf, PUSH, percent, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';

type Fate = 'hops' | 'atOnce' | 'stays';

const FATES = ['hops', 'atOnce', 'stays'] as const satisfies readonly Fate[];

/** The colours of the same classes in the outcome maps. */
const CLASS_OF = {
  hops: 'lifts_off_later',
  atOnce: 'leaves_at_once',
  stays: 'rolls_forever',
} as const satisfies Record<Fate, Class>;

const COLUMNS = 54;
const ROWS = 36;

const PUSHES = [0, 2] as const;
const SHARES = [0.1, 0.98] as const;

/** Kinetic friction over static. */
const KINETIC = 0.8;

/** Milliseconds of a frame that the map may take. */
const SLICE = 7;

function fateIn(hoop: Hoop): Fate {
  const fate = fateOf(hoop);
  return fate === 'leaves_at_once' ? 'atOnce' : fate === 'lifts_off_later' ? 'hops' : 'stays';
}

export function answer(picture: Picture): void {
  const says = PICTURES.answer.says;
  const hoopOf = (push: number, share: number): Hoop =>
    thinHoop((1 - share) / share, { theta_rate: -push, mu_s: mu.value, mu_k: KINETIC * mu.value });
  const [share, push, mu] = [
    picture.slider('share', {
      min: 10,
      max: 98,
      step: 1,
      first: 80,
      text: (value) => percent(value / 100),
    }),
    picture.slider('push', {
      min: 0,
      max: 2,
      step: 0.01,
      first: PUSH,
      text: (value) => plain(value),
    }),
    picture.slider(
      'mu',
      { min: 0.1, max: 1.5, step: 0.05, first: 0.5, text: (value) => plain(value) },
      () => {
        cells.fill(-1);
        next = 0;
      },
    ),
  ];
  const cells = new Int8Array(COLUMNS * ROWS).fill(-1);
  let next = 0;
  const hoop = (): Hoop => hoopOf(push.value, share.value / 100);
  const between = ([from, to]: readonly [number, number], part: number): number =>
    from + part * (to - from);

  /** Every cell once, from coarse to fine: in steps that are prime to their number. */
  const compute = (): void => {
    const begin = performance.now();
    while (next < cells.length && performance.now() - begin < SLICE) {
      const cell = (next * 601) % cells.length;
      const [column, row] = [cell % COLUMNS, Math.floor(cell / COLUMNS)];
      const at = hoopOf(
        between(PUSHES, (column + 0.5) / COLUMNS),
        between(SHARES, 1 - (row + 0.5) / ROWS),
      );
      cells[cell] = FATES.indexOf(fateIn(at));
      next += 1;
    }
    if (next < cells.length) requestAnimationFrame(picture.changed);
    picture.figure.dataset.cells = String(next);
  };

  const legend = make('ul', { class: 'legend' });
  for (const fate of FATES) {
    legend.append(
      make(
        'li',
        { 'data-class': CLASS_OF[fate] },
        make('span', { class: 'swatch', 'aria-hidden': 'true' }),
        picture.word(CLASS_OF[fate]),
      ),
    );
  }
  picture.controls.before(legend);

  const MARGIN = { left: 34, right: 12, top: 12, bottom: 30 };
  const frame = (): { left: number; top: number; width: number; height: number } => {
    const { width, height } = picture.size;
    return {
      left: MARGIN.left,
      top: MARGIN.top,
      width: width - MARGIN.left - MARGIN.right,
      height: height - MARGIN.top - MARGIN.bottom,
    };
  };
  const place = (): Point => {
    const { left, top, width, height } = frame();
    const part = ([from, to]: readonly [number, number], value: number): number =>
      (value - from) / (to - from);
    return [
      left + part(PUSHES, push.value) * width,
      top + (1 - part(SHARES, share.value / 100)) * height,
    ];
  };
  picture.handle(
    place,
    (x, y) => {
      const { left, top, width, height } = frame();
      push.set(between(PUSHES, (x - left) / width));
      share.set(100 * between(SHARES, 1 - (y - top) / height));
    },
    true,
  );

  picture.live(
    (c, _, palette: Palette) => {
      compute();
      const { left, top, width, height } = frame();
      cells.forEach((fate, cell) => {
        if (fate < 0) return;
        const [column, row] = [cell % COLUMNS, Math.floor(cell / COLUMNS)];
        const [x, y] = [left + (column / COLUMNS) * width, top + (row / ROWS) * height];
        c.fillStyle = palette.class[CLASS_OF[FATES[fate]!]];
        c.fillRect(x, y, width / COLUMNS + 0.6, height / ROWS + 0.6);
      });
      c.strokeStyle = palette.ink.soft;
      c.lineWidth = 1;
      c.strokeRect(left, top, width, height);
      words(c, picture.word('push'), [left + width / 2, top + height + 16], palette, 'center', 13);
      c.save();
      c.translate(14, top + height / 2);
      c.rotate(-Math.PI / 2);
      words(c, picture.word('share'), [0, 0], palette, 'center', 13);
      c.restore();
      const [x, y] = place();
      for (const [colour, thick] of [
        [palette.ink.paper, 7],
        [palette.ink.ink, 3],
      ] as const) {
        c.strokeStyle = colour;
        c.lineWidth = thick;
        c.beginPath();
        c.arc(x, y, 11, 0, 2 * Math.PI);
        c.stroke();
      }
    },
    () => {
      const fate = fateIn(hoop());
      if (fate !== 'hops') return says[fate];
      const { motion } = motionOf(hoop());
      const height = plain(most(motion, 'gap'), 2);
      motion.free();
      return fill(says.hops, { height });
    },
    () => linkTo(hoop()),
  );
}
