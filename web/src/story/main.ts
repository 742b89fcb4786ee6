// The story: its text, with the numbers that the library computes, and its live pictures.

import '../generated/palette.css';
import '../style/theme.css';
import '../style/base.css';
import '../style/hoop.css';
import '../style/story.css';
import { namesAgree } from '../core/motion';
import { startCore } from '../core/wasm';
import { byId, make } from '../dom';
import { LANGUAGE, otherLanguage } from '../language';
import type { Theme } from '../state/state';
import { isDark, onSystemTheme, paletteOf, setTheme } from '../ui/theme';
import { addressOf } from './addresses';
import type { Picture } from './kit';
import { numbersOfText } from './numbers';
import { pictureOf } from './pictures';
import { type Filling, rich } from './rich';
import { COMMON, type Part, SOURCES, STORY } from './text';

let theme: Theme = 'auto';
const main = byId('story', HTMLElement);
const themeButton = byId('theme', HTMLButtonElement);

document.documentElement.lang = LANGUAGE;
document.title = STORY.title;
byId('skip', HTMLAnchorElement).textContent = COMMON.skip;
themeButton.title = COMMON.theme;
themeButton.setAttribute('aria-label', COMMON.theme);
byId('nav', HTMLElement).setAttribute('aria-label', COMMON.nav);

try {
  await startCore((message) => show(message));
  if (!namesAgree()) throw new Error('page and core have different versions');
  tell(numbersOfText());
  document.documentElement.dataset.ready = 'true';
  performance.mark('ready');
} catch (error) {
  show(String(error));
}

/** What happened where the pictures cannot be computed. */
function show(message: string): void {
  main.prepend(
    make('p', { class: 'defect', role: 'alert' }, COMMON.defect.replace('{reason}', message)),
  );
}

function tell(numbers: Filling): void {
  const paragraph = (text: string): HTMLParagraphElement =>
    make('p', {}, ...rich(text, numbers, addressOf));
  for (const [name, words] of Object.entries(COMMON.links))
    themeButton.before(make('a', { href: addressOf(name) }, words), ' ');
  const other = otherLanguage();
  themeButton.before(make('a', { href: other.address, lang: other.language }, other.name), ' ');
  const pictures: Picture[] = [];
  const bodyOf = (body: Part['body']): HTMLElement[] =>
    body.map((it) => {
      if (typeof it === 'string') return paragraph(it);
      if ('quote' in it) {
        const source = make('footer', {}, ...rich(it.source, numbers, addressOf));
        return make('blockquote', {}, paragraph(it.quote), source);
      }
      if ('riddle' in it)
        return make(
          'details',
          { class: 'riddle' },
          make('summary', {}, it.riddle),
          paragraph(it.answer),
        );
      const picture = pictureOf(it.picture, COMMON, paletteOf(theme));
      pictures.push(picture);
      return picture.figure;
    });
  const section = ({ id, heading, body }: Part): HTMLElement =>
    make(
      'section',
      { id, 'aria-labelledby': `${id}-heading` },
      make('h2', { id: `${id}-heading` }, heading),
      ...bodyOf(body),
    );
  const lede = make('div', { class: 'lede' }, ...bodyOf(STORY.lede));
  main.append(make('h1', {}, STORY.title), lede, ...STORY.parts.map(section));
  const sources = Object.entries(SOURCES.list).map(([name, text]) =>
    make('li', { id: `source-${name}` }, ...rich(text, numbers, addressOf)),
  );
  main.append(
    make(
      'section',
      { 'aria-labelledby': 'sources' },
      make('h2', { id: 'sources' }, SOURCES.heading),
      make('ul', { class: 'sources' }, ...sources),
    ),
  );

  const showTheme = (): void => {
    setTheme(theme);
    for (const picture of pictures) picture.setPalette(paletteOf(theme));
  };
  themeButton.addEventListener('click', () => {
    theme = isDark(theme) ? 'light' : 'dark';
    showTheme();
  });
  onSystemTheme(showTheme);
  // The text has come after the address: its place is found only now.
  const place = location.hash.length > 1 ? document.getElementById(location.hash.slice(1)) : null;
  place?.scrollIntoView();
}

if ('serviceWorker' in navigator && import.meta.env.PROD) {
  void navigator.serviceWorker.register('./sw.js').catch(() => {
    // Without it the page needs the network; that is all.
  });
}
