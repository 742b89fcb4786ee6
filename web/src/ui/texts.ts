// The words of the simple view and of the lessons, which are in one file for each language.

import { brief } from '../dom';
import { LANGUAGE, withMark } from '../language';
import en from '../texts/en.json';

type English = typeof en;

/** What a translation says. Sentences of events and names of classes are the library's, which has English ones. */
type Texts = Omit<English, 'lessons'> & {
  readonly lessons: Record<
    keyof English['lessons'],
    { title: string; question: string; guesses: string[]; answer: string }
  >;
  readonly events?: Readonly<Record<string, string>>;
  readonly classes?: Readonly<Record<string, string>>;
};

const texts: Texts = LANGUAGE === 'de' ? (await import('../texts/de.json')).default : en;

export type LessonName = keyof English['lessons'];

export interface Question {
  question: string;
  guesses: readonly string[];
}

export interface Lesson extends Question {
  title: string;
  link: string;
  /** The motion that is pinned beside it. */
  pin?: string;
  /** Which guess is right. */
  right: number;
  /** When the answer is shown: with an event of this name, at the end, or at an instant; at the start it waits for the guess. */
  until: string;
  answer: string;
}

export const TEXTS = texts;
export const LESSON_NAMES = Object.keys(en.lessons) as LessonName[];
/** In the words of the language; motion and right guess stand in the first file alone. */
export const LESSONS = Object.fromEntries(
  LESSON_NAMES.map((name) => [name, { ...en.lessons[name], ...texts.lessons[name] }]),
) as Record<string, Lesson> as Readonly<Record<LessonName, Lesson>>;

/** What a lesson of one's own may hide, besides what comes. */
export const HIDDEN = ['sliders', 'sentences', 'arrows'] as const;
export type Hidden = (typeof HIDDEN)[number];

/** When an answer may be shown: with an event of this name, at the end, or at once. */
export const UNTIL = ['lift_off', 'landing', 'slip', 'end', 'start'] as const;

/** A lesson that is shown: one of the list, or one that came in a link. */
export interface Asked {
  /** Its name, if it has one. */
  name: LessonName | null;
  lesson: Lesson;
  hides: readonly Hidden[];
  /** Its part of a link. */
  text: string;
}

/** The key of a lesson of one's own in a link. */
const OWN = 'ask';

export function askedOf(name: LessonName): Asked {
  return { name, lesson: LESSONS[name], hides: [], text: `lesson=${name}` };
}

/** A lesson of one's own. */
export function ownLesson(
  lesson: Pick<Lesson, 'question' | 'guesses' | 'right' | 'until' | 'answer'>,
  hides: readonly Hidden[],
): Asked {
  const { question, guesses, right, until, answer } = lesson;
  const says = new URLSearchParams({ question, right: String(right), until, answer });
  for (const guess of guesses) says.append('guess', guess);
  for (const hidden of hides) says.append('hide', hidden);
  const text = `${OWN}=${encodeURIComponent(says.toString())}`;
  return { name: null, lesson: { ...lesson, title: TEXTS.own, link: '' }, hides, text };
}

/** A lesson of one's own as a link has it; none where it makes no sense. */
function readOwn(text: string): Asked | null {
  const says = new URLSearchParams(unescaped(text));
  const guesses = says.getAll('guess');
  const right = Number(says.get('right') ?? NaN);
  const until = UNTIL.find((it) => it === says.get('until'));
  const hides = HIDDEN.filter((it) => says.getAll('hide').includes(it));
  const [question, answer] = [says.get('question') ?? '', says.get('answer') ?? ''];
  if (question === '' || guesses.length < 2 || guesses[right] === undefined || until === undefined)
    return null;
  return ownLesson({ question, guesses, right, until, answer }, hides);
}

/** The lesson of a link, the link of the motion that it pins, and the rest of the link. */
export function partsOf(fragment: string): {
  asked: Asked | null;
  pin: string | null;
  rest: string;
} {
  const parts = new Map(
    fragment
      .replace(/^#/, '')
      .split('&')
      .map((part) => [part.split('=', 1)[0]!, part]),
  );
  const said = (key: string): string | null => parts.get(key)?.slice(key.length + 1) ?? null;
  const name = LESSON_NAMES.find((it) => it === said('lesson'));
  const [own, pin] = [said(OWN), said('pin')];
  const asked = name === undefined ? (own === null ? null : readOwn(own)) : askedOf(name);
  // A lesson that is not known stays, to be reported.
  if (asked !== null) parts.delete(asked.name === null ? OWN : 'lesson');
  parts.delete('pin');
  return { asked, pin: pin === null ? null : unescaped(pin), rest: [...parts.values()].join('&') };
}

function unescaped(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** A text with its values. */
export function filled(text: string, values: Readonly<Record<string, string>>): string {
  return text.replace(/\{(\w+)\}/g, (all, name: string) =>
    withMark(values[name] ?? all, TEXTS.decimal),
  );
}

/** A start in words, its rate in the units that are shown. */
export function sayStart(theta: number, rate: number, unit: string): string {
  const { top, bottom, left, right, rest, counterclockwise, clockwise } = TEXTS.start;
  const degrees = Math.round((theta * 180) / Math.PI);
  const side = degrees > 0 ? left : right;
  const place =
    degrees === 0
      ? top
      : Math.abs(degrees) === 180
        ? bottom
        : filled(side, { angle: String(Math.abs(degrees)) });
  if (rate === 0) return filled(rest, { place });
  return filled(rate > 0 ? counterclockwise : clockwise, {
    place,
    rate: `${brief(Math.abs(rate), 3)} ${unit}`,
  });
}

/** Writes the words into the document: `data-text` is the place of one, `data-label` that of a label that is spoken. */
export function writeTexts(): void {
  document.documentElement.lang = LANGUAGE;
  const wordOf = (key: string | undefined): string => {
    const words: Readonly<Record<string, string>> = TEXTS.page;
    const word = words[key ?? ''];
    if (word === undefined) throw new Error(`there is no text named ${key}`);
    return word;
  };
  for (const element of document.querySelectorAll<HTMLElement>('[data-text]'))
    element.textContent = wordOf(element.dataset.text);
  for (const element of document.querySelectorAll<HTMLElement>('[data-label]'))
    element.setAttribute('aria-label', wordOf(element.dataset.label));
  for (const element of document.querySelectorAll<HTMLElement>('[data-tip]'))
    element.title = wordOf(element.dataset.tip);
}
