// A motion that changes with its controls, and is drawn as in the laboratory.

import type { Motion, Sample } from '../../core/motion';
import type { Palette } from '../../generated/palette';
import type { Size } from '../../views/canvas';
import { drawHoop, type HoopScene } from '../../views/hoop';
import { type Hoop, motionOf, type Run } from '../hoops';
import type { Course } from '../kit';
import { plain } from '../numbers';

/** Time up to which motions are shown, if no other is given: many go on for ever. */
const LONG = 14;

/** Time for a second of the screen: half of what it is for a hula hoop. */
const SPEED = 2.2;

export class Showing {
  hoop!: Hoop;
  run!: Run;
  motion!: Motion;
  h = 0;

  /** `longest` is the time up to which the motion is shown. */
  constructor(
    hoop: Hoop,
    run: Run = {},
    private readonly longest = LONG,
    private readonly speed = SPEED,
  ) {
    this.take(hoop, run);
  }

  take(hoop: Hoop, run: Run = {}): void {
    if (this.motion !== undefined) this.motion.free();
    this.hoop = hoop;
    this.run = run;
    ({ motion: this.motion, h: this.h } = motionOf(hoop, { ...run, until: this.longest }));
  }

  readonly course = (): Course => ({
    from: this.motion.begin,
    to: this.motion.end,
    stops: this.motion.events.map(({ time }) => time),
    speed: this.speed,
  });

  readonly timeText = (time: number): string => `${plain(time)} √(R/g)`;

  scene(time: number, palette: Palette, follow = true): HoopScene {
    const { offset, slope } = this.hoop;
    return {
      motion: this.motion,
      sample: this.motion.at(time),
      offset,
      h: this.h,
      slope,
      follow,
      landing: null,
      palette,
    };
  }

  draw(
    c: CanvasRenderingContext2D,
    size: Size,
    time: number,
    palette: Palette,
    follow = true,
  ): Sample | null {
    const scene = this.scene(time, palette, follow);
    drawHoop(c, size, scene);
    return scene.sample;
  }
}
