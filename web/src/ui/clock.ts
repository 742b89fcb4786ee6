// Play and pause: the cursor moves with real time.

import type { Lab } from '../state/lab';

export class Clock {
  playing = false;
  private before = 0;

  constructor(
    private readonly lab: Lab,
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
    const { motion, state, units } = this.lab;
    const time = this.lab.time + (seconds * state.view.speed) / units.time;
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
