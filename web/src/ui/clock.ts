// Play and pause: the cursor moves with real time.

import type { Lab } from '../state/lab';

/** How much slower it plays around a lift-off, and from when before it to when after it, τ. */
const SLOWER = 0.25;
const BEFORE = 0.25;
const AFTER = 0.35;

export class Clock {
  playing = false;
  private before = 0;

  constructor(
    private readonly lab: Lab,
    private readonly isSlow: () => boolean,
    private readonly changed: () => void,
  ) {}

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  play(): void {
    if (this.playing) return;
    if (this.lab.time >= this.lab.motion.end) this.lab.setTime(this.lab.motion.begin);
    this.playing = true;
    this.before = performance.now();
    this.changed();
    requestAnimationFrame(this.tick);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.changed();
  }

  private readonly tick = (now: number): void => {
    if (!this.playing) return;
    // A page in the background stops; it does not leap when it comes back.
    const seconds = Math.min(Math.max(now - this.before, 0), 100) / 1000;
    this.before = now;
    const { motion, state, time: shown, units } = this.lab;
    const isNear = motion.liftOffs.some((it) => shown > it - BEFORE && shown < it + AFTER);
    const speed = state.view.speed * (isNear && this.isSlow() ? SLOWER : 1);
    const time = shown + (seconds * speed) / units.time;
    if (time < motion.end) {
      this.lab.setTime(time);
    } else if (state.view.loop) {
      this.lab.setTime(motion.begin);
    } else {
      this.lab.setTime(motion.end);
      this.pause();
      return;
    }
    requestAnimationFrame(this.tick);
  };
}
