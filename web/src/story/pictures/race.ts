// A race: three hoops from one start, each on a track of its own, to the hop.

import { type Motion, modeOf } from '../../core/motion';
import { MODE_DASHES, type Palette } from '../../generated/palette';
import { arrow, setDash } from '../../views/canvas';
import { type Box, disc, ground, line, ring, weightOf, words } from '../draw';
import { type Hoop, hoopWith, linkTo, motionOf, thinHoop } from '../hoops';
import type { Picture, Slider } from '../kit';
import { degrees, fateOf, PUSH, plain, REAL_RESISTANCE } from '../numbers';
import { fill } from '../rich';
import { MODES, PICTURES } from '../text';

const RACERS = ['massless', 'light', 'real'] as const;
type Racer = (typeof RACERS)[number];

/** Their hoops, without the start: Littlewood's, a light one, and one that the ground resists as it rolls. */
const HOOPS: Readonly<Record<Racer, Hoop>> = {
  massless: hoopWith(),
  light: thinHoop(0.05),
  real: thinHoop(0.25, { rolling_resistance: REAL_RESISTANCE }),
};

/** Time after which none is waited for, and for which the place of a hop is looked at. */
const LONGEST = 12;
const AFTER = 0.3;

/** Radii to the left of the start, to the right of the last place, and over a rim. */
const [LEFT, RIGHT, ABOVE] = [1.2, 1.3, 0.35];

/** Pixels under a track, for a name. */
const NAME = 20;

interface Running {
  racer: Racer;
  hoop: Hoop;
  motion: Motion;
}

export function race(picture: Picture): void {
  const says = PICTURES.race.says;
  let running: Running[] = [];
  /** Until the last one has landed; of one that does not hop, until the others have. */
  let end = 0;
  let farthest = 0;
  const take = (): void => {
    for (const { motion } of running) motion.free();
    running = RACERS.map((racer) => {
      const start = { theta: (-angle.value * Math.PI) / 180, theta_rate: -push.value };
      const hoop = { ...HOOPS[racer], ...start };
      return { racer, hoop, motion: motionOf(hoop, { until: LONGEST }).motion };
    });
    const hops = running.map(({ motion }) => motion.hop).filter((hop) => hop !== null);
    const stops = running.map(({ motion }) => motion.end).filter((it) => it < LONGEST);
    end = Math.min(LONGEST, Math.max(...hops.map((hop) => hop.end), ...stops, 5) + AFTER);
    farthest = Math.max(...running.map(({ motion }) => stateAt(motion, end)?.x ?? 0), 1);
  };
  const moved = (): void => {
    take();
    player.go(0);
  };
  const [angle, push]: readonly [Slider, Slider] = [
    picture.slider(
      'angle',
      { min: 0, max: 90, step: 1, first: 0, text: (value) => `${plain(value)}°` },
      moved,
    ),
    picture.slider(
      'push',
      { min: 0, max: 1.3, step: 0.01, first: PUSH, text: (value) => plain(value) },
      moved,
    ),
  ];
  take();
  const player = picture.player(
    () => ({
      from: 0,
      to: end,
      stops: running.flatMap(({ motion }) => motion.events.map(({ time }) => time)).sort(upwards),
      speed: 1.2,
    }),
    (time) => `${plain(time)} √(R/g)`,
  );

  /** Radii that a racer needs upwards. */
  const room = ({ motion }: Running): number => 2 + (motion.hop?.height ?? 0) + ABOVE;
  /** The pixels of a radius, one scale for all. */
  const scale = (): number => {
    const { width, height } = picture.size;
    const rooms = running.reduce((sum, it) => sum + room(it), 0);
    const up = (height - RACERS.length * NAME) / rooms;
    return Math.max(4, Math.min(up, width / (farthest + LEFT + RIGHT)));
  };
  /** The track of a racer, in pixels; what is left in height is shared. */
  const track = (place: number): Box => {
    const { width, height } = picture.size;
    const [radius, rooms] = [scale(), running.map(room)];
    const left = height - RACERS.length * NAME - radius * rooms.reduce((a, b) => a + b, 0);
    const heights = rooms.map((it) => it * radius + left / RACERS.length);
    const top = heights.slice(0, place).reduce((sum, it) => sum + it + NAME, 0);
    return { left: 0, top, width, height: heights[place]! };
  };
  const start = (): readonly [number, number] => {
    const [radius, { top, height }] = [scale(), track(0)];
    const theta = (-angle.value * Math.PI) / 180;
    return weightOf({
      x: LEFT * radius,
      y: top + height - radius,
      radius,
      theta,
      colour: '',
    });
  };
  picture.handle(start, (x, y) => {
    const [radius, { top, height }] = [scale(), track(0)];
    const turned = Math.atan2(x - LEFT * radius, top + height - radius - y);
    angle.set((turned * 180) / Math.PI);
  });

  picture.live(
    (c, _, palette) => {
      for (const [place, it] of running.entries())
        drawTrack(c, track(place), scale(), it, player.time, picture, palette);
    },
    () => {
      const { time } = player;
      if (time === 0) return says.ask;
      if (time >= end) return verdict(running, picture);
      const now = running.map(({ racer, motion }) =>
        fill(says.now, { name: picture.word(racer), mode: wordAt(motion, time) }),
      );
      return `${now.join('; ')}.`;
    },
    () => linkTo(running[2]!.hoop),
  );
}

function drawTrack(
  c: CanvasRenderingContext2D,
  box: Box,
  radius: number,
  { racer, motion }: Running,
  time: number,
  picture: Picture,
  palette: Palette,
): void {
  const floor = box.top + box.height;
  const x = (along: number): number => box.left + (LEFT + along) * radius;
  ground(c, box, floor, radius, 0, palette);
  const now = stateAt(motion, time);
  if (now === null) return;
  const mode = modeOf(now.mode);
  const colour = palette.mode[mode];
  // Where it was let go.
  c.strokeStyle = palette.ink.faint;
  c.lineWidth = 1.5;
  setDash(c, [3, 3]);
  line(c, [x(0), floor], [x(0), floor - 2 * radius]);
  c.setLineDash([]);
  const { hop } = motion;
  if (hop !== null && time >= hop.start) {
    const from = motion.at(hop.start)?.x ?? 0;
    c.strokeStyle = palette.mode.flight;
    c.lineWidth = 5;
    line(c, [x(from), floor], [x(now.x), floor]);
    c.fillStyle = palette.ink.ink;
    disc(c, [x(from), floor], 4);
  }
  ring(
    c,
    {
      x: x(now.x),
      y: floor - now.centre_y * radius,
      radius,
      theta: now.theta,
      colour,
      dash: MODE_DASHES[mode],
      // The massless rim is thin, the heavy one thick.
      width: { massless: 2, light: 3, real: 5 }[racer],
    },
    palette,
  );
  // The push, where it is let go.
  if (time === 0) arrow(c, x(now.x), floor - radius, -now.theta_rate * radius, 0, palette.ink.soft);
  words(c, picture.word(racer), [8, floor + 12], palette, 'left', 13);
}

/** Its state; of a motion that has ended, the last one. */
function stateAt(motion: Motion, time: number): ReturnType<Motion['at']> {
  return motion.at(Math.min(time, motion.end));
}

function wordAt(motion: Motion, time: number): string {
  const { says } = PICTURES.race;
  if (time < motion.end || motion.end >= LONGEST) {
    const now = motion.at(time);
    return now === null ? '' : MODES[modeOf(now.mode)];
  }
  return motion.hop === null ? says.over : says.landed;
}

/** Who has hopped where and when, the first one first. */
function verdict(running: readonly Running[], picture: Picture): string {
  const { says } = PICTURES.race;
  const [hopped, others] = [true, false].map((hops) =>
    running.filter(({ motion }) => (motion.hop !== null) === hops),
  ) as [Running[], Running[]];
  hopped.sort((a, b) => upwards(a.motion.hop!.start, b.motion.hop!.start));
  const parts = hopped.map(({ racer, motion }) => {
    const { start, height } = motion.hop!;
    const state = motion.at(start);
    return fill(start === 0 ? says.atOnce : says.hopped, {
      name: picture.word(racer),
      time: plain(start),
      place: plain(state?.x ?? 0),
      angle: degrees(Math.abs(state?.theta ?? 0)),
      height: plain(height, 2),
    });
  });
  // It is followed to its end, not only as far as the race.
  const isLate = ({ hoop }: Running): boolean => fateOf(hoop) === 'lifts_off_later';
  for (const [text, these] of [
    [says.late, others.filter(isLate)],
    [says.stayed, others.filter((it) => !isLate(it))],
  ] as const) {
    const names = these.map(({ racer }) => picture.word(racer)).join(` ${says.and} `);
    if (names !== '') parts.push(fill(text, { names }));
  }
  const sentence = parts.join('; ');
  return `${sentence.charAt(0).toUpperCase()}${sentence.slice(1)}.`;
}

function upwards(a: number, b: number): number {
  return a - b;
}
