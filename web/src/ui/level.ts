// How much of the page is shown: simple, for who meets the hoop for the first time, or full.

import { byId } from '../dom';
import type { Lab } from '../state/lab';
import { HAS_ADDRESS, IS_ALONE } from './address';
import { TEXTS } from './texts';

/** Where the browser keeps what was chosen last. */
const KEY = 'littlewood-level';

/** Screens on which the full view does not fit. */
const SMALL = matchMedia('(max-width: 760px), (max-height: 500px)');

type Shown = 'simple' | 'full';

export class Level {
  private readonly button = byId('level', HTMLButtonElement);
  private readonly symbols = byId('symbols', HTMLInputElement);

  constructor(private readonly lab: Lab) {
    this.button.addEventListener('click', () => {
      const level: Shown = this.isSimple ? 'full' : 'simple';
      remember(level);
      lab.setView({ level });
    });
    this.symbols.addEventListener('change', () => lab.setView({ symbols: this.symbols.checked }));
    SMALL.addEventListener('change', () => lab.setView({}));
    this.showView();
  }

  /** Of a page that was opened without a link: a first visit begins simple, and says so in its link. */
  first(): void {
    if (HAS_ADDRESS && IS_ALONE && recall() === null) this.lab.setView({ level: 'simple' });
  }

  /** Whether tables are out of sight of who drags: in the simple view, and on small screens. */
  get hidesTables(): boolean {
    return this.isSimple || SMALL.matches;
  }

  get isSimple(): boolean {
    return this.shown === 'simple';
  }

  private get shown(): Shown {
    const { level, embed } = this.lab.state.view;
    if (embed || document.documentElement.hasAttribute('data-lecture')) return 'full';
    if (level !== 'auto') return level;
    const isLesson = document.documentElement.hasAttribute('data-lesson');
    return recall() ?? (IS_ALONE && (SMALL.matches || isLesson) ? 'simple' : 'full');
  }

  showView(): void {
    document.documentElement.dataset.level = this.shown;
    const { symbols } = this.lab.state.view;
    document.documentElement.toggleAttribute('data-words', !symbols);
    this.symbols.checked = symbols;
    byId('skip', HTMLAnchorElement).textContent = this.isSimple
      ? TEXTS.page.to_weight
      : TEXTS.page.to_start;
    this.button.textContent = this.isSimple ? TEXTS.page.full : TEXTS.page.simple;
  }
}

function recall(): Shown | null {
  try {
    const level = localStorage.getItem(KEY);
    return level === 'simple' || level === 'full' ? level : null;
  } catch {
    // A frame without an origin keeps nothing.
    return null;
  }
}

function remember(level: Shown): void {
  try {
    localStorage.setItem(KEY, level);
  } catch {
    // It is chosen anew at the next visit.
  }
}
