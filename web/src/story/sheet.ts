// The sheet for teachers, from the same words and numbers as the story.

import '../generated/palette.css';
import '../style/theme.css';
import '../style/base.css';
import '../style/sheet.css';
import { startCore } from '../core/wasm';
import { byId, make } from '../dom';
import { LANGUAGE } from '../language';
import { addressOf } from './addresses';
import { numbersOfText } from './numbers';
import { rich } from './rich';
import { COMMON, SHEET } from './text';

const main = byId('sheet', HTMLElement);
document.documentElement.lang = LANGUAGE;
document.title = SHEET.title;

try {
  await startCore((message) => show(message));
  const numbers = numbersOfText();
  const said = (text: string): Node[] => rich(text, numbers, addressOf);
  const print = make('button', { type: 'button' }, SHEET.print);
  print.addEventListener('click', () => window.print());
  const { lessons, measure, questions } = SHEET;
  main.append(
    make('h1', {}, SHEET.title),
    make('p', { class: 'tools' }, print, ' ', make('a', { href: addressOf('story') }, SHEET.story)),
    make('p', {}, ...said(SHEET.lede)),
    ...lessons.flatMap(({ heading, text }) => [
      make('h2', {}, heading),
      make('p', {}, ...said(text)),
    ]),
    make('h2', {}, measure.heading),
    make('ul', {}, ...measure.items.map((it) => make('li', {}, ...said(it)))),
    make('h2', {}, questions.heading),
    make(
      'dl',
      {},
      ...questions.list.flatMap(([question, answer]) => [
        make('dt', {}, ...said(question)),
        make('dd', {}, ...said(answer)),
      ]),
    ),
    make('p', { class: 'foot' }, SHEET.foot),
  );
  document.documentElement.dataset.ready = 'true';
} catch (error) {
  show(String(error));
}

function show(message: string): void {
  main.prepend(make('p', { role: 'alert' }, COMMON.defect.replace('{reason}', message)));
}
