// The question over the hoop: of the simple view and of the lessons. A guess plays the motion; what
// it does is the answer, as soon as it does it.

import { brief, byId, make, STILL } from '../dom';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';
import type { Clock } from './clock';
import { type Asked, askedOf, filled, LESSON_NAMES, LESSONS, type Lesson, TEXTS } from './texts';

export class Ask {
  private readonly pane = byId('question', HTMLHeadingElement);
  private readonly guesses = byId('guesses', HTMLDivElement);
  private readonly answer = byId('answer', HTMLParagraphElement);
  private readonly hop = byId('hop', HTMLParagraphElement);
  private readonly choice = byId('lesson', HTMLSelectElement);
  /** The lesson that is shown; none for the question of the simple view. */
  asked: Asked | null = null;
  private guess: number | null = null;
  /** The place of a lesson of one's own in the list. */
  private readonly own = make('option', { value: 'own' }, TEXTS.own);
  /** Whether the motion has answered since the question was asked: what comes is no secret any more. */
  private isKnown = false;

  constructor(
    private readonly lab: Lab,
    private readonly clock: Clock,
    private readonly isAsking: () => boolean,
    open: (asked: Asked | null) => void,
  ) {
    this.choice.append(
      make('option', { value: '' }, TEXTS.none),
      ...LESSON_NAMES.map((name) => make('option', { value: name }, LESSONS[name].title)),
      this.own,
    );
    this.choice.addEventListener('change', () => {
      const name = LESSON_NAMES.find((it) => it === this.choice.value);
      open(name === undefined ? null : askedOf(name));
    });
  }

  private get lesson(): Lesson | null {
    return this.asked?.lesson ?? null;
  }

  /** Shows a lesson, or the question of the simple view. */
  open(asked: Asked | null): void {
    this.asked = asked;
    this.guess = null;
    this.isKnown = false;
    const isOwn = asked !== null && asked.name === null;
    this.own.hidden = !isOwn;
    this.choice.value = isOwn ? this.own.value : (asked?.name ?? '');
    const root = document.documentElement;
    root.toggleAttribute('data-lesson', asked !== null);
    this.lab.hidesArrows = asked?.hides.includes('arrows') ?? false;
    root.dataset.hides = asked?.hides.join(' ') ?? '';
    const { question, guesses } = this.lesson ?? TEXTS.opening;
    this.pane.textContent = question;
    this.guesses.replaceChildren(
      ...guesses.map((text, i) => {
        const button = make('button', { type: 'button', 'aria-pressed': 'false' }, text);
        button.addEventListener('click', () => this.take(i));
        return button;
      }),
    );
    this.showTime();
  }

  private take(guess: number): void {
    this.guess = guess;
    const { answerTime, lab, clock } = this;
    const { begin } = lab.motion;
    if (answerTime > begin) {
      lab.setTime(STILL.matches ? answerTime : begin);
      if (!STILL.matches) clock.play();
    }
    this.showTime();
  }

  /** Another motion is another question. */
  showMotion(): void {
    if (this.lesson === null) this.guess = null;
    this.showTime();
  }

  /** When the motion has answered. */
  private get answerTime(): number {
    const { motion } = this.lab;
    if (this.lesson === null) return motion.hop?.start ?? motion.end;
    const { until } = this.lesson;
    if (until === 'start') return motion.begin;
    if (until === 'landing') return motion.hop?.end ?? motion.end;
    const instant = Number(until);
    return Math.min(
      Number.isNaN(instant)
        ? (motion.events.find(({ name }) => name === until)?.time ?? motion.end)
        : instant,
      motion.end,
    );
  }

  showTime(): void {
    const {
      lab: { motion, time },
      clock,
      lesson,
      guess,
    } = this;
    const isTold = time >= this.answerTime && (time > motion.begin || guess !== null);
    this.isKnown ||= isTold;
    this.showSecret();
    this.answer.textContent = isTold ? this.verdict : clock.playing ? TEXTS.opening.watch : '';
    this.answer.dataset.told = String(isTold);
    for (const [i, button] of [...this.guesses.children].entries())
      button.setAttribute('aria-pressed', String(i === guess));
    const { hop } = motion;
    // What leaves the plane is seen to do so.
    const isUp =
      hop !== null && time >= hop.start && time < hop.end && (clock.playing || lesson !== null);
    this.hop.hidden = !isUp;
  }

  /** Until the motion has answered, neither the time line nor the path of the hoop gives it away. */
  showSecret(): void {
    const isSecret = !this.isKnown && (this.lesson !== null || this.isAsking());
    this.lab.isSecret = isSecret;
    document.documentElement.toggleAttribute('data-secret', isSecret);
  }

  private get verdict(): string {
    const {
      lab: {
        motion: { hop },
        units,
        state: {
          problem: { system },
        },
      },
      lesson,
      guess,
    } = this;
    const said = (right: number): string =>
      guess === null ? '' : guess === right ? TEXTS.right : TEXTS.wrong;
    if (lesson !== null) return [said(lesson.right), lesson.answer].join(' ').trim();
    const { hops, stays, again } = TEXTS.opening;
    const found =
      hop === null
        ? stays
        : filled(hops, {
            height: `${brief(hop.height * units.gap, 2)} ${COLUMN_ROWS.gap.units[system]}`,
          });
    return [found, said(hop === null ? 1 : 0), again].filter((it) => it !== '').join(' ');
  }
}
