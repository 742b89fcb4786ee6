// The words of the story and of the sheet for teachers, in the language of the page. A file of
// `texts/` has all those of one language.

import { LANGUAGE, type Translated } from '../language';
import * as en from './texts/en';

/** A picture is shown where its name stands between paragraphs. */
export type PictureName = keyof typeof en.PICTURES;

type Body = readonly (
  | string
  | { picture: PictureName }
  | { quote: string; source: string }
  | { riddle: string; answer: string }
)[];

export interface Part {
  id: string;
  heading: string;
  body: Body;
}

export interface Article {
  title: string;
  lede: Body;
  parts: readonly Part[];
}

/** What each file says: the compiler compares their keys. */
export interface StoryTexts {
  DECIMAL: string;
  LIBRARY: Readonly<Record<string, string>>;
  COMMON: Translated<typeof en.COMMON>;
  STORY: Article;
  PICTURES: Translated<typeof en.PICTURES>;
  MODES: Translated<typeof en.MODES>;
  SOURCES: Translated<typeof en.SOURCES>;
  SHEET: Translated<typeof en.SHEET>;
}

const texts: StoryTexts = LANGUAGE === 'de' ? await import('./texts/de') : en;

export const { DECIMAL, LIBRARY, COMMON, STORY, PICTURES, MODES, SOURCES, SHEET } = texts;
