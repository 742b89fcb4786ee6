// The address of the state, and the history: one entry for each change of the problem that is done,
// so that going back undoes it.

import { byId } from '../dom';
import type { Lab } from '../state/lab';
import { type ProblemState, VIEW } from '../state/state';
import { format } from '../state/url';

/** As the document of a notebook's frame the page has no address. */
export const HAS_ADDRESS = location.protocol !== 'about:';

/** Whether no page is around this one. */
export const IS_ALONE = window.parent === window;

/** A frame leaves the history to the page around it. */
const HAS_HISTORY = HAS_ADDRESS && IS_ALONE;

export class Address {
  private readonly undo = byId('undo', HTMLButtonElement);
  /** The problem of the entry that is shown, as a link, and the act that has made the entry. */
  private problem: string;
  private entry = 0;
  /** Counts what a person does: a press of the pointer, a visit to a control, a value that is confirmed. */
  private act = 1;

  constructor(
    private readonly lab: Lab,
    /** The lesson that is shown as a part of a link, which stands first. */
    private readonly lesson: () => string | null,
  ) {
    this.problem = this.said;
    const next = (): void => {
      // What has been changed before is an entry of its own.
      if (HAS_HISTORY && this.said !== this.problem && lab.fieldErrors.length === 0) this.write();
      this.act += 1;
    };
    document.addEventListener('pointerdown', next, true);
    document.addEventListener('focusin', next, true);
    document.addEventListener('change', ({ target }) => {
      // A slider confirms each step.
      if (!(target instanceof HTMLInputElement && target.type === 'range')) next();
    });
    this.undo.hidden = !HAS_HISTORY;
    this.undo.addEventListener('click', () => {
      // What has just been changed may not be written yet.
      this.write();
      history.back();
    });
  }

  private get said(): string {
    return format({ problem: this.lab.state.problem, view: VIEW });
  }

  /** The text after #. */
  get fragment(): string {
    return this.fragmentOf(this.lab.state.problem);
  }

  /** The same of another problem. A motion that is pinned is a link in it. */
  private fragmentOf(problem: ProblemState, lesson = this.lesson()): string {
    const { pinned, state } = this.lab;
    const pin =
      pinned === null ? null : encodeURIComponent(format({ problem: pinned.problem, view: VIEW }));
    const head = [lesson, pin === null ? null : `pin=${pin}`].filter((it) => it !== null);
    return [...head, format({ ...state, problem })].join('&');
  }

  get text(): string {
    return this.textOf(this.lab.state.problem);
  }

  /** The link of a problem, shown as this one. Without an address it is the fragment alone. */
  textOf(problem: ProblemState, lesson = this.lesson()): string {
    const fragment = `#${this.fragmentOf(problem, lesson)}`;
    return HAS_ADDRESS
      ? `${location.origin}${location.pathname}${location.search}${fragment}`
      : fragment;
  }

  /** The entry of the history is that of the state: it has been read from there. */
  taken(): void {
    this.problem = this.said;
    this.entry = 0;
    this.undo.disabled = depth() === 0;
  }

  /** The problem has changed: it can be undone, whether or not it is written yet. */
  changed(): void {
    this.undo.disabled = depth() === 0 && this.said === this.problem;
  }

  write(): void {
    if (!HAS_ADDRESS) return;
    const problem = this.said;
    const isNew = HAS_HISTORY && problem !== this.problem && this.entry !== this.act;
    if (isNew) {
      this.entry = this.act;
      history.pushState({ depth: depth() + 1 }, '', this.text);
    } else {
      history.replaceState(history.state, '', this.text);
    }
    this.problem = problem;
    this.undo.disabled = depth() === 0;
  }
}

/** How many changes lead to the entry of the history that is shown. */
function depth(): number {
  const state: unknown = history.state;
  return typeof state === 'object' && state !== null && 'depth' in state ? Number(state.depth) : 0;
}
