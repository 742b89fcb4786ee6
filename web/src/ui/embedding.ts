// The page as a frame in another one: the hoop, what happens, and the time line, with a link to the
// whole laboratory.

import { byId } from '../dom';
import type { Lab } from '../state/lab';
import { format } from '../state/url';

export class Embedding {
  private readonly whole = byId('whole', HTMLAnchorElement);

  constructor(private readonly lab: Lab) {
    // The link is of the instant at which it is followed.
    for (const kind of ['pointerdown', 'focus', 'click'] as const)
      this.whole.addEventListener(kind, () => this.showLink());
  }

  showView(): void {
    const { embed } = this.lab.state.view;
    if (embed) document.documentElement.dataset.embed = 'true';
    else delete document.documentElement.dataset.embed;
    this.whole.hidden = !embed;
    this.showLink();
  }

  private showLink(): void {
    const { state } = this.lab;
    this.whole.href = `#${format({ ...state, view: { ...state.view, embed: false } })}`;
  }
}
