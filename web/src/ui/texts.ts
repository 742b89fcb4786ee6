// The words of the simple view and of the lessons, which are in one file to be translated.

import texts from '../texts.json';

export type LessonName = keyof typeof texts.lessons;

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
export const LESSONS: Readonly<Record<LessonName, Lesson>> = texts.lessons;
export const LESSON_NAMES = Object.keys(texts.lessons) as LessonName[];

/** The lesson that a link names, the link of the motion that it pins, and the rest of the link. */
export function partsOf(fragment: string): {
  lesson: LessonName | null;
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
  const lesson = LESSON_NAMES.find((it) => it === said('lesson')) ?? null;
  const pin = said('pin');
  // A name that is not known stays, to be reported.
  if (lesson !== null) parts.delete('lesson');
  parts.delete('pin');
  return { lesson, pin: pin === null ? null : unescaped(pin), rest: [...parts.values()].join('&') };
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
  return text.replace(/\{(\w+)\}/g, (all, name: string) => values[name] ?? all);
}
