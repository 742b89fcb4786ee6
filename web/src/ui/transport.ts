// The time line with its transitions, and the buttons that move along it.

import { modeOf } from '../core/motion';
import { brief, byId, make } from '../dom';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';
import { SPEEDS } from '../state/state';
import type { Clock } from './clock';
import { TEXTS } from './texts';

/** Energy over m2 g R that no mark tells from none. */
const LEAST_LOSS = 1e-6;

/** The part of the motion by which an arrow key moves the time; a tenth of it with Shift. */
const KEY_STEP = 0.01;

/** What does something itself where the space bar is pressed. */
const TAKES_SPACE = 'button, a, input, select, textarea, summary, [contenteditable]';

export class Transport {
  private readonly play = byId('play', HTMLButtonElement);
  private readonly range = byId('time', HTMLInputElement);
  private readonly track = byId('track', HTMLDivElement);
  private readonly marks = byId('marks', HTMLDivElement);
  private readonly clockText = byId('now', HTMLOutputElement);
  private readonly speed = byId('speed', HTMLSelectElement);
  private readonly slow = byId('slow', HTMLInputElement);
  private readonly loop = byId('loop', HTMLInputElement);

  constructor(
    private readonly lab: Lab,
    private readonly clock: Clock,
  ) {
    for (const speed of SPEEDS)
      this.speed.append(make('option', { value: String(speed) }, `${speed}×`));
    this.play.addEventListener('click', () => clock.toggle());
    byId('first', HTMLButtonElement).addEventListener('click', () => this.go(lab.motion.begin));
    byId('previous', HTMLButtonElement).addEventListener('click', () => this.step(-1));
    byId('next', HTMLButtonElement).addEventListener('click', () => this.step(1));
    byId('last', HTMLButtonElement).addEventListener('click', () => this.go(lab.motion.end));
    this.range.addEventListener('input', () => this.go(this.timeOf(Number(this.range.value))));
    this.range.addEventListener('keydown', (event) => {
      const step =
        (event.shiftKey ? KEY_STEP / 10 : KEY_STEP) * (lab.motion.end - lab.motion.begin);
      const { key } = event;
      if (key === 'ArrowLeft' || key === 'ArrowDown') this.go(lab.time - step);
      else if (key === 'ArrowRight' || key === 'ArrowUp') this.go(lab.time + step);
      else if (key === 'PageDown') this.step(-1);
      else if (key === 'PageUp') this.step(1);
      else return;
      event.preventDefault();
    });
    document.addEventListener('keydown', (event) => {
      const { target, key } = event;
      // A button or a field that has the focus takes the key for itself.
      if (
        key !== ' ' ||
        (target instanceof Element && target.matches(TAKES_SPACE) && target !== this.range)
      )
        return;
      event.preventDefault();
      clock.toggle();
    });
    this.speed.addEventListener('change', () => lab.setView({ speed: Number(this.speed.value) }));
    this.slow.addEventListener('change', () => lab.setView({ slow: this.slow.checked }));
    this.loop.addEventListener('change', () => lab.setView({ loop: this.loop.checked }));
  }

  private timeOf(part: number): number {
    const { begin, end } = this.lab.motion;
    return begin + (end - begin) * part;
  }

  private go(time: number): void {
    this.clock.pause();
    this.lab.setTime(time);
  }

  /** To the next or the previous event. */
  private step(way: 1 | -1): void {
    const now = this.lab.time;
    const times = this.lab.motion.events
      .map((event) => event.time)
      .filter((it) => it <= this.lab.motion.end);
    const next = way > 0 ? times.find((it) => it > now) : times.findLast((it) => it < now);
    this.go(next ?? (way > 0 ? this.lab.motion.end : this.lab.motion.begin));
  }

  showMotion(): void {
    const { motion } = this.lab;
    const span = motion.end - motion.begin || 1;
    const part = (time: number): number =>
      (100 * (Math.min(time, motion.end) - motion.begin)) / span;
    const children: HTMLElement[] = motion.phases.map((phase) => {
      const band = make('span', { class: 'band', 'data-mode': phase.mode });
      band.style.left = `${part(phase.start)}%`;
      band.style.width = `${part(phase.end) - part(phase.start)}%`;
      return band;
    });
    for (const event of motion.events.slice(1)) {
      if (event.impact !== null || event.time > motion.end) continue;
      const tick = make('span', { class: 'tick', title: event.sentence });
      tick.style.left = `${part(event.time)}%`;
      children.push(tick);
    }
    this.track.replaceChildren(...children);
    this.showMarks(part);
    this.showTime();
  }

  /** A mark over the line for each impact, the taller the more of the energy is lost in it. */
  private showMarks(part: (time: number) => number): void {
    const { impacts } = this.lab.motion;
    // Where nothing is lost there is only rounding, which has no height.
    const most = impacts.reduce(
      (most, { impact }) => Math.max(most, Math.abs(impact.lost)),
      LEAST_LOSS,
    );
    this.marks.replaceChildren(
      ...impacts.map(({ time, impact, sentence, name }) => {
        const mark = make('span', {
          class: 'mark',
          title: sentence,
          'data-arrow': 'impulse',
          'data-cause': name,
        });
        mark.style.left = `${part(time)}%`;
        mark.style.height = `${35 + 65 * Math.sqrt(Math.abs(impact.lost) / most)}%`;
        return mark;
      }),
    );
  }

  showTime(): void {
    const {
      motion,
      time,
      units,
      state: {
        problem: { system },
      },
    } = this.lab;
    const span = motion.end - motion.begin || 1;
    this.range.value = String((time - motion.begin) / span);
    // The unit of a dimensionless time goes without saying.
    const unit = system === 'si' ? ` ${COLUMN_ROWS.time.units.si}` : '';
    const shown = `${COLUMN_ROWS.time.signs[system]} = ${(time * units.time).toFixed(3).replace('-', '−')}${unit}`;
    this.clockText.textContent = shown;
    const sample = motion.at(time);
    const name = sample === null ? 'no motion' : modeOf(sample.mode);
    this.range.setAttribute(
      'aria-valuetext',
      `${shown} of ${brief(motion.end * units.time, 4)}, ${name}`,
    );
  }

  showView(): void {
    const { view } = this.lab.state;
    this.speed.value = String(view.speed);
    this.slow.checked = view.slow;
    this.loop.checked = view.loop;
    const { playing } = this.clock;
    this.play.dataset.state = playing ? 'playing' : 'paused';
    this.play.setAttribute('aria-label', playing ? TEXTS.page.pause : TEXTS.page.play);
  }
}
