// Light or dark paper.

import { PALETTES, type Palette } from '../generated/palette';
import type { Theme } from '../state/state';

const DARK = matchMedia('(prefers-color-scheme: dark)');

export function isDark(theme: Theme): boolean {
  return theme === 'dark' || (theme === 'auto' && DARK.matches);
}

/** The colours for what is drawn. */
export function paletteOf(theme: Theme): Palette {
  return PALETTES[isDark(theme) ? 'dark' : 'light'];
}

/** Gives the document the theme. */
export function setTheme(theme: Theme): void {
  if (theme === 'auto') delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
}

export function onSystemTheme(changed: () => void): void {
  DARK.addEventListener('change', changed);
}
