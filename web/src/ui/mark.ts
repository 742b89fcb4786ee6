// Stopwatch and ruler: what has gone by, and how far the hoop has come, since an instant that is
// marked.

import { brief, byId } from '../dom';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';

const MEASURED = ['time', 'x', 'theta'] as const;

export class Mark {
  private readonly button = byId('mark', HTMLButtonElement);
  private readonly text = byId('since', HTMLOutputElement);
  private marked: number | null = null;

  constructor(private readonly lab: Lab) {
    this.button.title = 'Measure time and way from this instant';
    this.button.addEventListener('click', () => {
      this.marked = this.marked === null ? lab.time : null;
      this.showTime();
    });
  }

  showTime(): void {
    const { motion, time, units, state } = this.lab;
    const [from, to] =
      this.marked === null ? [null, null] : [motion.at(this.marked), motion.at(time)];
    this.button.setAttribute('aria-pressed', String(this.marked !== null));
    this.text.hidden = from === null || to === null;
    if (from === null || to === null) return;
    const { system } = state.problem;
    const said = MEASURED.map((name) => {
      const { signs, units: names } = COLUMN_ROWS[name];
      return `Δ${signs[system]} = ${brief((to[name] - from[name]) * units[name], 4)} ${names[system]}`.trim();
    });
    this.text.textContent = said.join(', ');
  }
}
