// The table of the phases, as the command line prints it: each row goes to its time.

import type { Row } from '../core/motion';
import { byId, make } from '../dom';
import type { Lab } from '../state/lab';

/** Rows of the table at most. */
const MOST_ROWS = 200;

/** The columns of the name of a motion and of the time. */
const MOTION = 1;
const TIME = 2;

export class PhaseTable {
  private readonly body = byId('phases', HTMLTableSectionElement);
  private rows: [number, HTMLTableRowElement][] = [];
  private now: HTMLTableRowElement | null = null;

  constructor(
    private readonly lab: Lab,
    private readonly go: (time: number) => void,
  ) {}

  showMotion(): void {
    this.fill(false);
    byId('outcome', HTMLParagraphElement).textContent = this.lab.motion.outcomeSentence;
  }

  showTime(): void {
    const now = this.rows.findLast(([time]) => time <= this.lab.time)?.[1] ?? null;
    if (now === this.now) return;
    this.now?.classList.remove('now');
    now?.classList.add('now');
    this.now = now;
  }

  /** Fills the table, with all bounces or with as few rows as tell the motion. */
  private fill(all: boolean): void {
    const { head, rows, numbers } = this.lab.motion.table(all);
    this.now = null;
    this.rows = [];
    byId('phase-heads', HTMLTableRowElement).replaceChildren(
      ...head.map((text, i) =>
        make('th', { scope: 'col', ...(numbers.includes(i) ? { class: 'number' } : {}) }, text),
      ),
    );
    this.body.replaceChildren(...rows.slice(0, MOST_ROWS).map((row) => this.row(row, numbers)));
    const hidden = rows.length - MOST_ROWS;
    byId('more-phases', HTMLParagraphElement).textContent =
      hidden > 0 ? `and ${hidden} more: the exports have them all` : '';
    this.showTime();
  }

  private row({ mode, time, folds, cells }: Row, numbers: readonly number[]): HTMLTableRowElement {
    const parts = cells.map((text, i) => {
      const cell = make('td', numbers.includes(i) ? { class: 'number' } : {});
      if (i === TIME && time !== null) {
        cell.append(
          this.button(text, () => this.go(time), {
            'data-time': String(time),
            'aria-label': `${cells[MOTION] ?? ''} from ${text}`,
          }),
        );
      } else if (i === MOTION && folds !== null) {
        cell.append(this.button(text, () => this.unfold(), { title: 'Show all rows' }));
      } else {
        cell.append(text);
      }
      if (i === MOTION && mode !== null) cell.dataset.mode = mode;
      return cell;
    });
    const row = make('tr', folds === null ? {} : { class: 'fold' }, ...parts);
    if (time !== null) this.rows.push([time, row]);
    return row;
  }

  private button(
    text: string,
    click: () => void,
    attributes: Record<string, string>,
  ): HTMLButtonElement {
    const button = make('button', { type: 'button', class: 'jump', ...attributes }, text);
    button.addEventListener('click', click);
    return button;
  }

  private unfold(): void {
    this.fill(true);
    this.body.querySelector<HTMLElement>('button')?.focus();
  }
}
