// A lesson of one's own: a question about the motion that is shown, as a link.

import { byId, make } from '../dom';
import { type Asked, HIDDEN, type Hidden, ownLesson, UNTIL } from './texts';

/** In words. */
const UNTIL_WORDS: Readonly<Record<(typeof UNTIL)[number], string>> = {
  lift_off: 'at the lift-off',
  landing: 'at the landing',
  slip: 'at the first slip',
  end: 'at the end',
  start: 'with the guess',
};

const HIDDEN_WORDS: Readonly<Record<Hidden, string>> = {
  sliders: 'the sliders',
  sentences: 'the sentences of events',
  arrows: 'the arrows of forces',
};

export class OwnLesson {
  private readonly form = byId('own-lesson', HTMLDetailsElement);
  private readonly question = byId('own-question', HTMLInputElement);
  private readonly guesses = byId('own-guesses', HTMLTextAreaElement);
  private readonly right = byId('own-right', HTMLSelectElement);
  private readonly until = byId('own-until', HTMLSelectElement);
  private readonly answer = byId('own-answer', HTMLTextAreaElement);
  private readonly link = byId('own-text', HTMLTextAreaElement);
  private readonly message = byId('own-message', HTMLSpanElement);
  private readonly hides: readonly (readonly [Hidden, HTMLInputElement])[];

  constructor(private readonly address: (asked: Asked) => string) {
    this.until.append(...UNTIL.map((value) => make('option', { value }, UNTIL_WORDS[value])));
    this.hides = HIDDEN.map((name) => {
      const box = make('input', { type: 'checkbox', value: name });
      byId('own-hides', HTMLSpanElement).append(make('label', {}, box, ` ${HIDDEN_WORDS[name]}`));
      return [name, box] as const;
    });
    this.form.addEventListener('input', () => this.show());
    this.form.addEventListener('toggle', () => this.show());
    this.show();
  }

  private show(): void {
    const guesses = this.guesses.value
      .split('\n')
      .map((it) => it.trim())
      .filter((it) => it !== '');
    // The choice of the right one keeps its place.
    const chosen = Math.max(0, this.right.selectedIndex);
    this.right.replaceChildren(
      ...guesses.map((text, i) => make('option', { value: String(i) }, text)),
    );
    this.right.selectedIndex = Math.min(chosen, guesses.length - 1);
    const question = this.question.value.trim();
    const isWhole = question !== '' && guesses.length >= 2;
    this.message.textContent = isWhole ? '' : 'A question, and two guesses or more.';
    const asked = ownLesson(
      {
        question,
        guesses,
        right: this.right.selectedIndex,
        until: this.until.value,
        answer: this.answer.value.trim(),
      },
      this.hides.filter(([, { checked }]) => checked).map(([name]) => name),
    );
    this.link.value = isWhole ? this.address(asked) : '';
    byId('copy-own-text', HTMLButtonElement).disabled = !isWhole;
  }
}
