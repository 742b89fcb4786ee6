// The language of the page: that of the address (`?lang=de`), or of the last visit.

export const LANGUAGES = ['en', 'de'] as const;
export type Language = (typeof LANGUAGES)[number];

/** Where the browser keeps what was chosen last. */
const KEY = 'littlewood-language';

export const LANGUAGE: Language = chosen();

function chosen(): Language {
  // Tests read the texts without a page.
  if (typeof location === 'undefined') return 'en';
  const known = (text: string | null): Language | undefined => LANGUAGES.find((it) => it === text);
  const asked = known(new URLSearchParams(location.search).get('lang'));
  try {
    if (asked !== undefined) localStorage.setItem(KEY, asked);
    return asked ?? known(localStorage.getItem(KEY)) ?? 'en';
  } catch {
    // A frame without an origin keeps nothing.
    return asked ?? 'en';
  }
}

/** A text in another language, of which the compiler knows the same keys. */
export type Translated<T> = T extends string
  ? string
  : { readonly [K in keyof T]: Translated<T[K]> };

/** The link to the same page in the other language. */
export function otherLanguage(): { language: Language; name: string; address: string } {
  const language = LANGUAGE === 'en' ? 'de' : 'en';
  const names = { en: 'English', de: 'Deutsch' } as const;
  return { language, name: names[language], address: `?lang=${language}` };
}

/** Numbers of a text with the decimal mark of its language. */
export function withMark(text: string, mark: string): string {
  return mark === '.' ? text : text.replaceAll(/(?<=\d)\.(?=\d)/g, mark);
}
