// Three hoops that lift off at one angle, and turn through one angle in the air.

import type { Motion } from '../../core/motion';
import type { Palette } from '../../generated/palette';
import { setDash } from '../../views/canvas';
import { line, ring, words } from '../draw';
import { linkTo, motionOf } from '../hoops';
import type { Picture } from '../kit';
import { jumpOf, liftingOff, percent, plain, THREE } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';

/** The turn that is asked for, and how near to it is near enough, in degrees. */
const [WHOLE, CLOSE] = [360, 2];

const { says } = PICTURES.angle;

const NAMES = ['first', 'second', 'third'] as const;

const radians = (value: number): number => (value * Math.PI) / 180;

/** More digits than an eye sees: they are the same. */
const inDegrees = (angle: number): string => `${plain((angle * 180) / Math.PI, 6)}°`;

export function angle(picture: Picture): void {
  let motions: Motion[] = [];
  const take = (before: number): void => {
    for (const motion of motions) motion.free();
    motions = THREE.map((hoop) => motionOf(liftingOff(hoop, radians(before))).motion);
  };
  const slider = picture.slider(
    'angle',
    { min: 20, max: 80, step: 0.1, first: 45, text: (value) => `${plain(value)}°` },
    (value) => {
      take(value);
      player.go(player.time);
    },
  );
  take(slider.value);
  // A move of the slider is one try, however far it is dragged.
  slider.input.addEventListener('change', () => {
    tries += 1;
  });
  let tries = 0;
  const turned = (motion: Motion): number => jumpOf(motion)?.turned ?? NaN;
  // Its time is the part of the flight that has passed, the same for all three.
  const player = picture.player(
    () => ({ from: 0, to: 1, stops: [0.5], speed: 0.25 }),
    (time) => percent(time),
    1,
  );
  const one = (
    c: CanvasRenderingContext2D,
    place: number,
    width: number,
    height: number,
    palette: Palette,
  ): void => {
    const motion = motions[place]!;
    const jump = jumpOf(motion);
    if (jump === null) return;
    const now = motion.at(jump.from + player.time * (jump.to - jump.from) * (1 - 1e-9));
    if (now === null) return;
    const { offset } = THREE[place]!;
    const floor = height - 30;
    const highest = Math.max(
      ...motions.map((it) => it.samples.gap.reduce((a, b) => Math.max(a, b), 0)),
    );
    const radius = Math.min(0.34 * width, (floor - 34) / (2 + highest));
    const x = (place + 0.5) * width;
    const y = floor - radius * now.centre_y;
    c.strokeStyle = palette.ink.ink;
    c.lineWidth = 2;
    line(c, [place * width + 6, floor], [(place + 1) * width - 6, floor]);
    const start = radians(slider.value);
    // From where the weight was at the lift-off, clockwise.
    const before = { x, y, radius, theta: start, offset, colour: palette.ink.faint };
    c.strokeStyle = palette.accent.violet;
    c.lineWidth = 5;
    for (const [turn, from] of wholeTurns(start - now.theta).entries()) {
      c.beginPath();
      const inner = radius * (0.62 - 0.11 * turn);
      c.arc(
        x,
        y,
        Math.max(4, inner),
        -Math.PI / 2 - start + from[0],
        -Math.PI / 2 - start + from[1],
      );
      c.stroke();
    }
    c.strokeStyle = palette.ink.soft;
    c.lineWidth = 1.5;
    setDash(c, [3, 3]);
    line(c, [x, y], [x - radius * Math.sin(before.theta), y - radius * Math.cos(before.theta)]);
    c.setLineDash([]);
    ring(
      c,
      {
        x,
        y,
        radius,
        theta: now.theta,
        offset,
        colour: palette.mode.flight,
        width: [4, 9, 2][place]!,
      },
      palette,
    );
    words(c, picture.word(NAMES[place]!), [x, floor + 16], palette, 'center', 13);
  };
  const task = (by: number): string => {
    const left = WHOLE - by;
    if (Math.abs(left) < CLOSE) return fill(says.done, { tries: plain(tries + 1) });
    const open = fill(says.task, { whole: `${WHOLE}°`, close: `${CLOSE}°` });
    return `${open} ${fill(left > 0 ? says.more : says.less, { by: `${plain(Math.abs(left))}°` })}`;
  };
  picture.live(
    (c, { width, height }, palette) => {
      for (const place of THREE.keys()) one(c, place, width / 3, height, palette);
    },
    () => {
      const [first, second, third] = motions.map((motion) => inDegrees(turned(motion)));
      const said = fill(says.turned, {
        angle: `${plain(slider.value)}°`,
        first: first!,
        second: second!,
        third: third!,
      });
      return `${said} ${task((turned(motions[0]!) * 180) / Math.PI)}`;
    },
    () => linkTo(liftingOff(THREE[1]!, radians(slider.value))),
  );
}

/** An angle as whole turns and the rest, each from where to where. */
function wholeTurns(angle: number): [number, number][] {
  const turns: [number, number][] = [];
  for (let left = angle; left > 0; left -= 2 * Math.PI)
    turns.push([0, Math.min(left, 2 * Math.PI)]);
  return turns;
}
