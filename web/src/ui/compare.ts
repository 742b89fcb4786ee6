// A motion that is pinned, to compare others with it: a pale hoop, and a second curve in the plots.

import { numbersOf } from '../core/fields';
import type { Motion } from '../core/motion';
import { brief, byId } from '../dom';
import { COLUMN_ROWS, OUTCOME_ROWS, QUANTITY_ROWS } from '../generated/tables';
import { withMark } from '../language';
import type { Lab } from '../state/lab';
import { numberOf } from '../state/state';
import { filled, TEXTS } from './texts';

export class Compare {
  private readonly button = byId('pin', HTMLButtonElement);
  private readonly text = byId('compared', HTMLParagraphElement);

  constructor(private readonly lab: Lab) {
    this.button.addEventListener('click', () =>
      lab.pin(lab.pinned === null ? lab.state.problem : null),
    );
  }

  showMotion(): void {
    const { pinned, motion } = this.lab;
    this.button.setAttribute('aria-pressed', String(pinned !== null));
    this.text.hidden = pinned === null;
    if (pinned === null) return;
    this.text.textContent = [
      filled(TEXTS.compare.pinned, { fate: this.fate(pinned.motion) }),
      filled(TEXTS.compare.now, { fate: this.fate(motion) }),
      this.differences(),
    ]
      .join(' ')
      .trim();
  }

  /** What becomes of a motion, in a few words. */
  private fate({ hop, events }: Motion): string {
    const {
      units,
      state: {
        problem: { system },
      },
    } = this.lab;
    if (hop !== null)
      return filled(TEXTS.compare.hops, {
        height: `${brief(hop.height * units.gap, 3)} ${COLUMN_ROWS.gap.units[system]}`,
      });
    const last = events.at(-1)!;
    const event = TEXTS.events?.[last.name]?.replace(/\.$/, '');
    if (event !== undefined) return filled(TEXTS.compare.ends, { event });
    return last.name in OUTCOME_ROWS
      ? OUTCOME_ROWS[last.name as keyof typeof OUTCOME_ROWS].label
      : filled(TEXTS.compare.ends, { event: last.label });
  }

  /** The numbers in which the two differ, in the units that are shown. */
  private differences(): string {
    const { pinned, state } = this.lab;
    if (pinned === null || pinned.problem.system !== state.problem.system) return '';
    const changed = [...numbersOf(state.problem.system), 'restitution' as const].flatMap((name) => {
      const [before, now] = [numberOf(pinned.problem, name), numberOf(state.problem, name)];
      const said = (value: number | null): string =>
        value === null ? TEXTS.compare.none : withMark(brief(value, 4), TEXTS.decimal);
      return before === now ? [] : [`${QUANTITY_ROWS[name].sign} ${said(before)} → ${said(now)}`];
    });
    return changed.length === 0 ? TEXTS.compare.change : `${changed.join(', ')}.`;
  }
}
