// What moves the event that is shown, and by how much, as bars.

import { type Move, movesOf } from '../core/derivatives';
import { later, loadLater } from '../core/later';
import type { Event } from '../core/motion';
import { brief, byId, make } from '../dom';
import { COLUMN_ROWS, QUANTITY_ROWS, STATE_COLUMNS, type StateColumn } from '../generated/tables';
import type { Lab } from '../state/lab';

export class MovesPane {
  private readonly pane = byId('moves', HTMLElement);
  private readonly column = byId('moves-column', HTMLSelectElement);
  private readonly rows = byId('moves-rows', HTMLUListElement);
  private readonly reasons = byId('moves-reasons', HTMLParagraphElement);
  private shown: Event | null = null;
  private stale = true;

  constructor(
    private readonly lab: Lab,
    private readonly draw: () => void,
    private readonly failed: (message: string) => void,
  ) {
    this.column.addEventListener('change', () => {
      this.stale = true;
      draw();
    });
  }

  showMotion(): void {
    this.stale = true;
  }

  /** Shows what is stale; while something is dragged the drawing has the time. */
  paint(): void {
    const {
      lab: { held, transition },
    } = this;
    if (held || (!this.stale && transition === this.shown)) return;
    this.pane.hidden = transition === null;
    if (later() === null) {
      loadLater().then(this.draw, (error: unknown) => this.failed(String(error)));
      return;
    }
    this.stale = false;
    this.shown = transition;
    if (transition !== null) this.show(transition);
  }

  private show(event: Event): void {
    const {
      units,
      state: { problem },
    } = this.lab;
    const { label, time } = event;
    const { system } = problem;
    const column = STATE_COLUMNS.find((it) => it === this.column.value) ?? 'time';
    this.column.replaceChildren(
      ...STATE_COLUMNS.map((it) =>
        make(
          'option',
          { value: it },
          `${COLUMN_ROWS[it].signs[system]}, ${COLUMN_ROWS[it].longName}`,
        ),
      ),
    );
    this.column.value = column;
    const { signs, units: unit } = COLUMN_ROWS.time;
    byId('moves-place', HTMLElement).textContent =
      `${label}, ${signs[system]} = ${brief(time * units.time)}${system === 'si' ? ` ${unit.si}` : ''}`;
    const { rows, sentence } = movesOf(problem, event, column) ?? { rows: [], sentence: '' };
    byId('moves-sentence', HTMLParagraphElement).textContent = sentence;
    this.column.hidden = rows.length === 0;
    const known = rows.filter((it) => it.moved !== null);
    const most = Math.abs(known[0]?.moved ?? 0);
    this.rows.replaceChildren(...known.map((it) => this.row(it, most, column)));
    const reasons = new Map<string, string[]>();
    for (const { quantity, reason } of rows) {
      if (reason !== null)
        reasons.set(reason, [...(reasons.get(reason) ?? []), QUANTITY_ROWS[quantity].sign]);
    }
    this.reasons.textContent = [...reasons]
      .map(([reason, names]) => `${names.join(', ')}: ${reason}.`)
      .join(' ');
  }

  private row({ quantity, change, moved }: Move, most: number, column: StateColumn): HTMLElement {
    const {
      state: {
        problem: { system },
      },
    } = this.lab;
    const { sign, unit, longName } = QUANTITY_ROWS[quantity];
    const size = moved ?? 0;
    const bar = make('span', { class: 'bar', 'aria-hidden': 'true' }, make('span'));
    const filled = bar.firstElementChild as HTMLElement;
    const width = most > 0 ? (50 * Math.abs(size)) / most : 0;
    filled.style.width = `${width}%`;
    filled.style.left = `${size < 0 ? 50 - width : 50}%`;
    const by =
      `${signed(size)} ${COLUMN_ROWS[column].units[system] || (column === 'theta' ? 'rad' : '')}`.trim();
    return make(
      'li',
      { 'data-quantity': quantity, 'data-moved': String(size), title: longName },
      make(
        'span',
        { class: 'name' },
        make('i', {}, sign),
        make('span', { class: 'unseen' }, `, ${longName}`),
      ),
      make('span', { class: 'soft' }, `${signed(change)} ${unit}`.trim()),
      make('span', { class: 'unseen' }, ' moves it by '),
      make('span', { class: 'by' }, by),
      bar,
    );
  }
}

function signed(value: number): string {
  return `${value > 0 ? '+' : ''}${brief(value, 3)}`;
}
