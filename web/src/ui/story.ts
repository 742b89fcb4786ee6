// What happens, in words: the mode, the sentence, and the table of phases.

import type { Event } from '../core/motion';
import type { Lab } from '../state/lab';
import { byId, make } from './dom';

export class Story {
  private readonly mode = byId('mode', HTMLSpanElement);
  private readonly sentence = byId('sentence', HTMLSpanElement);
  private readonly rows = byId('events', HTMLTableSectionElement);
  private told: Event | null = null;

  constructor(private readonly lab: Lab, private readonly go: (time: number) => void) {}

  showMotion(): void {
    const { motion, timeUnit } = this.lab;
    const si = this.lab.state.problem.system === 'si';
    byId('time-head', HTMLTableCellElement).textContent = si ? 't [s]' : 'τ';
    const shown = motion.events.length > 60 ? motion.events.slice(0, 60) : motion.events;
    const scale = (value: number, unit: number): string => digits(value * unit);
    const length = si ? (this.lab.state.problem.numbers[2] ?? 1) : 1;
    this.rows.replaceChildren(...shown.map((event) => {
      const button = make('button', { type: 'button', class: 'jump', 'data-time': String(event.time) },
        scale(event.time, timeUnit));
      button.addEventListener('click', () => this.go(event.time));
      const follows = event.to ?? 'ends';
      return make('tr', { 'data-cause': event.cause },
        make('td', {}, button),
        make('td', {}, event.cause.replaceAll('_', ' ')),
        make('td', { class: follows }, follows),
        make('td', { class: 'number' }, digits(event.theta)),
        make('td', { class: 'number' }, scale(event.theta_rate, 1 / timeUnit)),
        make('td', { class: 'number' }, scale(event.slip, length / timeUnit)));
    }));
    byId('more-events', HTMLParagraphElement).textContent =
      motion.events.length > shown.length ? `and ${motion.events.length - shown.length} more: the exports have them all` : '';
    byId('outcome', HTMLParagraphElement).textContent = motion.outcomeSentence;
    this.told = null;
    this.showTime();
  }

  showTime(): void {
    const { motion, time } = this.lab;
    const event = motion.eventAt(time);
    if (event === this.told) return;
    this.told = event;
    const sample = motion.at(time);
    const name = sample === null ? 'no motion' : ['rolling', 'sliding', 'gliding', 'flight'][sample.mode] ?? '';
    const mode = event.to ?? (sample === null ? 'none' : name);
    this.mode.textContent = event.to === null && sample !== null ? `${name}, ends` : sample === null ? name : mode;
    this.mode.className = `mode ${sample === null ? 'none' : name}`;
    if (event.to !== null) this.mode.className = `mode ${mode}`;
    this.sentence.textContent = event.sentence;
    [...this.rows.rows].forEach((row, i) => row.classList.toggle('now', motion.events[i] === event));
  }
}

/** Ten digits after the point, as far as they mean anything. */
function digits(value: number): string {
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  return (Math.abs(value) < 1e-4 || Math.abs(value) >= 1e6 ? value.toExponential(6) : value.toFixed(10)).replaceAll('-', '−');
}
