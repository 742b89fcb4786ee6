// What happens, in words: the mode, the sentence, and the table of phases.

import { modeOf, type Event } from '../core/motion';
import { COLUMN_ROWS, type SampleColumn } from '../generated/tables';
import type { Lab } from '../state/lab';
import { byId, make } from '../dom';

/** What the table has of the state at an event, besides the time. */
const STATE = ['theta', 'theta_rate', 'slip'] as const satisfies readonly SampleColumn[];

/** Rows of the table at most. */
const MOST_ROWS = 60;

export class Story {
  private readonly mode = byId('mode', HTMLSpanElement);
  private readonly sentence = byId('sentence', HTMLSpanElement);
  private readonly rows = byId('events', HTMLTableSectionElement);
  /** The event whose sentence is shown. */
  private shown: Event | null = null;

  constructor(private readonly lab: Lab, private readonly go: (time: number) => void) {}

  showMotion(): void {
    const { motion, units, state: { problem: { system } } } = this.lab;
    const head = (column: SampleColumn, what?: string): HTMLElement => {
      const { signs, units: { si } } = COLUMN_ROWS[column];
      const sign = what === undefined ? signs[system] : `${signs[system]} ${what}`;
      return make('th', { scope: 'col' }, system === 'si' ? `${sign} [${si}]` : sign);
    };
    byId('event-heads', HTMLTableRowElement).replaceChildren(
      head('time'), make('th', { scope: 'col' }, 'event'), make('th', { scope: 'col' }, 'then'), ...STATE.map((it) => head(it)),
      ...(motion.impacts.length > 0 ? [make('th', { scope: 'col' }, 'impact'), head('energy', 'lost')] : []));
    const shown = motion.events.slice(0, MOST_ROWS);
    this.rows.replaceChildren(...shown.map((event) => {
      const number = (column: 'time' | (typeof STATE)[number]): string => digits(event[column] * units[column]);
      const button = make('button', { type: 'button', class: 'jump', 'data-time': String(event.time) }, number('time'));
      button.addEventListener('click', () => this.go(event.time));
      return make('tr', { 'data-event': event.name },
        make('td', {}, button),
        make('td', {}, event.label),
        event.to === null ? make('td', {}, 'ends') : make('td', { 'data-mode': event.to }, event.to),
        ...STATE.map((column) => make('td', { class: 'number' }, number(column))),
        ...(event.impact === null ? [] : [
          make('td', {}, event.impact.label), make('td', { class: 'number' }, digits(event.impact.lost * units.energy)),
        ]));
    }));
    const hidden = motion.events.length - shown.length;
    byId('more-events', HTMLParagraphElement).textContent = hidden > 0 ? `and ${hidden} more: the exports have them all` : '';
    byId('outcome', HTMLParagraphElement).textContent = motion.outcomeSentence;
    this.shown = null;
    this.showTime();
  }

  showTime(): void {
    const { motion, time } = this.lab;
    const event = motion.eventAt(time);
    if (event === this.shown) return;
    this.shown = event;
    const sample = motion.at(time);
    const mode = event.to ?? (sample === null ? null : modeOf(sample.mode));
    this.mode.textContent = mode === null ? 'no motion' : event.to === null ? `${mode}, ends` : mode;
    if (mode === null) delete this.mode.dataset['mode'];
    else this.mode.dataset['mode'] = mode;
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
