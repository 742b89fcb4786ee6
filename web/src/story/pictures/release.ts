// Thousands of hoops, let go at once: the plane of their starts lights up as they slip, fly and land.

import { inOrder } from '../../core/fields';
import { make } from '../../dom';
import type { Palette } from '../../generated/palette';
import type { Class } from '../../generated/tables';
import { type Counts, colourOf, DOINGS, type Doing, Release } from '../../map/release';
import { drawHoop } from '../../views/hoop';
import { type Box, split, words } from '../draw';
import { type Hoop, linkTo, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { degrees, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';
import { Showing } from './course';

/** Starts each way; a telephone has fewer. */
const [SIDE, SMALL] = [100, 64];

const RATE = 4;

/** Milliseconds between two counts that are shown. */
const COUNT_PAUSE = 200;

/** The part of the motions that the film waits for, and the time for a second of the screen. */
const PART = 0.93;
const SPEED = 1.3;

/** The first hoop that is shown: one that hops, and not that of the question; in parts of the plane. */
const FIRST = [0.75, 0.25] as const;

/** Pixels about the plane. */
const MARGIN = { left: 26, right: 8, top: 8, bottom: 26 };

export function release(picture: Picture): void {
  const says = PICTURES.release.says;
  const base = storyHoop(0);
  const side = matchMedia('(max-width: 600px)').matches ? SMALL : SIDE;
  const hoops = new Release(side, RATE, () => {
    if (hoops.isComplete) begin();
    else picture.changed();
  });
  let [asked, touched] = [false, false];
  let last = 10;
  let failure: string | null = null;
  const cellAt = (part: number): number => Math.min(Math.max(Math.floor(part * side), 0), side - 1);
  const hoop = (): Hoop => ({ ...base, ...hoops.startOf(column.value, row.value) });
  let showing: Showing | null = null;
  const take = (): void => {
    touched = true;
    showing = null;
    // A hoop that is chosen is seen from its start, if nothing plays.
    if (!player.playing) {
      player.go(0);
      if (hoops.isComplete) player.playUnlessStill();
    }
  };
  const cells = { min: 0, max: side - 1, step: 1 };
  const column = picture.slider(
    'angle',
    {
      ...cells,
      first: cellAt(FIRST[0]),
      text: (value) => degrees(hoops.startOf(value, 0).theta),
    },
    take,
  );
  // Upwards is faster, and the rows are counted from the top.
  const row = picture.slider(
    'rate',
    {
      ...cells,
      first: cellAt(FIRST[1]),
      text: (value) => plain(hoops.startOf(0, value).theta_rate),
    },
    take,
  );
  const player = picture.player(
    () => ({ from: 0, to: last, stops: [0.5, 1, 2, 3, 4, 6, 8], speed: SPEED }),
    (time) => `${plain(time)} √(R/g)`,
  );

  /** All are known: they are let go, if somebody watches. */
  const begin = (): void => {
    last = Math.ceil(hoops.timeOf(PART));
    picture.figure.dataset.followed = String(side * side);
    if (!touched && player.time === 0) player.playUnlessStill();
    picture.changed();
  };

  const legend = make('ul', { class: 'legend counts' });
  picture.controls.before(legend);
  let counted = { at: -Infinity, text: '' };

  const plane = (): { box: Box; left: number; top: number; edge: number; hoop: Box } => {
    const [box, other] = split(picture.size, 0.5);
    const edge = Math.min(
      box.width - MARGIN.left - MARGIN.right,
      box.height - MARGIN.top - MARGIN.bottom,
    );
    const left = box.left + MARGIN.left + (box.width - MARGIN.left - MARGIN.right - edge) / 2;
    return { box, left, top: box.top + MARGIN.top, edge, hoop: other };
  };
  picture.handle(
    () => {
      const { left, top, edge } = plane();
      return [left + ((column.value + 0.5) / side) * edge, top + ((row.value + 0.5) / side) * edge];
    },
    (x, y) => {
      const { left, top, edge } = plane();
      if (x > left + edge || y > top + edge) return;
      column.set(cellAt((x - left) / edge));
      row.set(cellAt((y - top) / edge));
    },
    true,
  );

  const frames: number[] = [];
  picture.live(
    (c, _, palette) => {
      if (!asked) {
        asked = true;
        hoops.follow(inOrder('dimensionless', base), (message) => {
          failure = message;
          picture.changed();
        });
      }
      const { left, top, edge, hoop: right } = plane();
      const counts = hoops.paint(hoops.isComplete ? player.time : 0, palette);
      c.imageSmoothingEnabled = false;
      c.drawImage(hoops.picture, left, top, edge, edge);
      c.strokeStyle = palette.ink.soft;
      c.lineWidth = 1;
      c.strokeRect(left, top, edge, edge);
      // The square that is chosen.
      const each = edge / side;
      for (const [colour, thick] of [
        [palette.ink.paper, 4],
        [palette.ink.ink, 2],
      ] as const) {
        c.strokeStyle = colour;
        c.lineWidth = thick;
        c.strokeRect(
          left + column.value * each - 1,
          top + row.value * each - 1,
          each + 2,
          each + 2,
        );
      }
      words(c, picture.word('across'), [left + edge / 2, top + edge + 14], palette, 'center', 13);
      c.save();
      c.translate(left - 13, top + edge / 2);
      c.rotate(-Math.PI / 2);
      words(c, picture.word('upwards'), [0, 0], palette, 'center', 13);
      c.restore();
      const now = performance.now();
      if (now - counted.at > COUNT_PAUSE || !player.playing) {
        counted = { at: now, text: tell(legend, counts, hoops.present, picture, palette) };
      }
      showing ??= new Showing(hoop());
      c.save();
      c.beginPath();
      c.rect(right.left, right.top, right.width, right.height);
      c.clip();
      c.translate(right.left, right.top);
      const { motion } = showing;
      drawHoop(c, right, {
        ...showing.scene(Math.min(player.time, motion.end), palette),
        symbols: false,
      });
      c.restore();
      // For the benchmark and the test, which count frames from outside.
      frames.push(now);
      if (frames.length > 60) frames.shift();
      const [first = now] = frames;
      const rate = (1000 * (frames.length - 1)) / Math.max(now - first, 1);
      picture.figure.dataset.rate = rate.toFixed(1);
    },
    () => {
      if (failure !== null) return failure;
      if (!hoops.isComplete)
        return fill(says.follows, { count: whole(hoops.rows * side), of: whole(side * side) });
      return fill(says.now, {
        count: whole(side * side),
        time: plain(player.time),
        counts: counted.text,
      });
    },
    () => linkTo(hoop()),
  );
}

/** Shows how many do what; the sentence of it. */
function tell(
  legend: HTMLElement,
  { doing, classes }: Counts,
  present: readonly Class[],
  picture: Picture,
  palette: Palette,
): string {
  const entry = (name: Doing | Class, count: number, colour: string): HTMLElement => {
    const swatch = make('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = colour;
    const number = make('b', {}, whole(count));
    return make('li', {}, swatch, `${picture.word(name)} `, number);
  };
  const cssOf = (pixel: number): string => {
    const [red, green, blue] = new Uint8Array(Uint32Array.of(pixel).buffer);
    return `rgb(${red} ${green} ${blue})`;
  };
  legend.replaceChildren(
    ...DOINGS.map((it) => entry(it, doing[it], cssOf(colourOf(it, palette)))),
    ...present.map((it) => entry(it, classes[it], palette.class[it])),
  );
  const { says } = PICTURES.release;
  const landed = classes.leaves_at_once + classes.lifts_off_later;
  const ended = present.reduce((sum, it) => sum + classes[it], 0);
  return fill(says.counts, {
    flies: whole(doing.flies),
    landed: whole(landed),
    stays: whole(ended - landed),
  });
}

/** A count, with a thin space between thousands. */
function whole(count: number): string {
  return String(count).replace(/(?<=\d)(?=(\d{3})+$)/g, '\u202f');
}
