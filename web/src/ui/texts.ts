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

/** The lesson that a link names, and the rest of the link. */
export function lessonOf(fragment: string): { lesson: LessonName | null; rest: string } {
  const parts = fragment.replace(/^#/, '').split('&');
  const named = parts.find((it) => it.startsWith('lesson='))?.slice('lesson='.length);
  const lesson = LESSON_NAMES.find((it) => it === named) ?? null;
  // A name that is not known stays, to be reported.
  return lesson === null ? { lesson, rest: fragment } : { lesson, rest: parts.filter((it) => it !== `lesson=${lesson}`).join('&') };
}

/** A text with its values. */
export function filled(text: string, values: Readonly<Record<string, string>>): string {
  return text.replace(/\{(\w+)\}/g, (all, name: string) => values[name] ?? all);
}
