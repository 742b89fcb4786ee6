// The address of the state, and the history: one entry for each change of the problem that is done, so that going back undoes it.

import type { Lab } from '../state/lab';
import type { ProblemState } from '../state/state';
import { format } from '../state/url';

const HAS_ADDRESS = location.protocol !== 'about:';

/** A frame leaves the history to the page around it. */
const HAS_HISTORY = HAS_ADDRESS && window.parent === window;

export class Address {
  /** The problem of the entry that is shown, and the act that has made the entry. */
  private problem: ProblemState;
  private entry = 0;
  /** Counts what a person does: a press of the pointer, a visit to a control, a value that is confirmed. */
  private act = 1;

  constructor(private readonly lab: Lab) {
    this.problem = lab.state.problem;
    const next = (): void => {
      this.act += 1;
    };
    document.addEventListener('pointerdown', next, true);
    document.addEventListener('focusin', next, true);
    document.addEventListener('change', ({ target }) => {
      // A slider confirms each step.
      if (!(target instanceof HTMLInputElement && target.type === 'range')) next();
    });
  }

  /** As the document of a notebook's frame the page has no address, and this is the fragment alone. */
  get text(): string {
    const fragment = `#${format(this.lab.state)}`;
    return HAS_ADDRESS ? `${location.origin}${location.pathname}${location.search}${fragment}` : fragment;
  }

  /** The entry of the history is that of the state: it has been read from there. */
  taken(): void {
    this.problem = this.lab.state.problem;
    this.entry = 0;
  }

  write(): void {
    if (!HAS_ADDRESS) return;
    const { problem } = this.lab.state;
    const isNew = HAS_HISTORY && problem !== this.problem && this.entry !== this.act;
    if (isNew) {
      this.entry = this.act;
      history.pushState(null, '', this.text);
    } else {
      history.replaceState(null, '', this.text);
    }
    this.problem = problem;
  }
}
