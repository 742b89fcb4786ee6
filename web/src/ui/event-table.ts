// The table of events.

import type { Event } from '../core/motion';
import { COLUMN_ROWS, type SampleColumn } from '../generated/tables';
import type { Lab } from '../state/lab';
import { brief, byId, make } from '../dom';
import { runsOf } from './event-rows';

/** What the table has of the state at an event, besides the time. */
const STATE = ['theta', 'theta_rate', 'slip'] as const satisfies readonly SampleColumn[];

/** Rows of the table at most. */
const MOST_ROWS = 60;

export class EventTable {
  private readonly body = byId('events', HTMLTableSectionElement);
  private rows = new Map<Event, HTMLTableRowElement>();
  private now: HTMLTableRowElement | null = null;

  constructor(private readonly lab: Lab, private readonly go: (time: number) => void) {}

  showMotion(): void {
    this.fill(false);
    byId('outcome', HTMLParagraphElement).textContent = this.lab.motion.outcomeSentence;
  }

  showTime(): void {
    const { motion, time } = this.lab;
    const now = this.rows.get(motion.eventAt(time)) ?? null;
    if (now === this.now) return;
    this.now?.classList.remove('now');
    now?.classList.add('now');
    this.now = now;
  }

  /** Fills the table, with all bounces or with the first and the last. */
  private fill(all: boolean): void {
    const { motion: { events, impacts } } = this.lab;
    this.fillHead(impacts.length > 0);
    this.rows = new Map();
    this.now = null;
    this.body.replaceChildren();
    let hidden = events.length;
    for (const run of runsOf(events, all)) {
      const rest = MOST_ROWS - this.body.rows.length;
      if (rest <= 0) break;
      const shown = run.isFolded ? run.events : run.events.slice(0, rest);
      hidden -= shown.length;
      const folded = run.isFolded ? this.folded(run.events.length) : null;
      for (const event of shown) this.rows.set(event, folded ?? this.row(event, events[events.indexOf(event) + 1]));
      this.body.append(...(folded ? [folded] : shown.map((event) => this.rows.get(event)!)));
    }
    byId('more-events', HTMLParagraphElement).textContent = hidden > 0 ? `and ${hidden} more: the exports have them all` : '';
    this.showTime();
  }

  private fillHead(withImpacts: boolean): void {
    const { system } = this.lab.state.problem;
    const head = (column: SampleColumn, what = ''): HTMLElement => {
      const { signs, units: { si } } = COLUMN_ROWS[column];
      return make('th', { scope: 'col' }, `${signs[system]}${what}${system === 'si' ? ` [${si}]` : ''}`);
    };
    this.body.parentElement?.classList.toggle('tight', withImpacts);
    byId('event-heads', HTMLTableRowElement).replaceChildren(
      head('time'), make('th', { scope: 'col' }, 'event'), make('th', { scope: 'col' }, 'then'), ...STATE.map((it) => head(it)),
      ...(withImpacts ? [make('th', { scope: 'col' }, 'impact'), head('energy', ' lost')] : []));
  }

  private row(event: Event, next: Event | undefined): HTMLTableRowElement {
    const { units, motion: { impacts } } = this.lab;
    const number = (column: 'time' | (typeof STATE)[number]): string => digits(event[column] * units[column]);
    const button = make('button', { type: 'button', class: 'jump', 'data-time': String(event.time) }, number('time'));
    button.addEventListener('click', () => this.go(event.time));
    return make('tr', { 'data-event': event.name },
      make('td', {}, button),
      make('td', {}, event.label),
      event.to === null ? make('td', {}, next?.impact ? '–' : 'ends') : make('td', { 'data-mode': event.to }, event.to),
      ...STATE.map((column) => make('td', { class: 'number' }, number(column))),
      ...(impacts.length > 0 ? this.impactCells(event) : []));
  }

  private impactCells({ impact }: Event): HTMLElement[] {
    if (impact === null) return [make('td', { colspan: '2' })];
    const { motion, units } = this.lab;
    const lost = brief(motion.lostIn(impact) * units.energy, 3);
    return [make('td', {}, impact.label), make('td', { class: 'number' }, lost)];
  }

  private folded(count: number): HTMLTableRowElement {
    const button = make('button', { type: 'button', class: 'jump', id: 'show-bounces' }, `${count} more bounces`);
    button.addEventListener('click', () => {
      this.fill(true);
      this.body.querySelector<HTMLElement>('button')?.focus();
    });
    return make('tr', { class: 'fold' }, make('td', { colspan: '8' }, button));
  }
}

/** Ten digits after the point, as far as they mean anything. */
function digits(value: number): string {
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  return (Math.abs(value) < 1e-4 || Math.abs(value) >= 1e6 ? value.toExponential(6) : value.toFixed(10)).replaceAll('-', '−');
}
