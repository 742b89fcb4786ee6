// Each language has the same texts, with the same places, links and colours in them.

import { expect, type Page, test } from '@playwright/test';
import { CAUSES, CLASSES, OUTCOMES } from '../src/generated/tables';
import * as de from '../src/story/texts/de';
import * as en from '../src/story/texts/en';
import german from '../src/texts/de.json' with { type: 'json' };
import english from '../src/texts/en.json' with { type: 'json' };
import { ready, watch } from './lab';

/** The texts of a file by their places in it. */
function textsOf(value: unknown, place = ''): [string, string][] {
  if (typeof value === 'string') return [[place, value]];
  if (typeof value !== 'object' || value === null) return [];
  return Object.entries(value).flatMap(([key, part]) => textsOf(part, `${place}/${key}`));
}

/** What of a text is no word: places of numbers, addresses, what gives a colour. */
function marksOf(text: string): string[] {
  return [...text.matchAll(/\{[\w.]+\}|\]\([^)]+\)|<\w+:/g)].map(([mark]) => mark).sort();
}

function agree(first: unknown, second: unknown): void {
  const [a, b] = [new Map(textsOf(first)), new Map(textsOf(second))];
  expect([...b.keys()]).toEqual([...a.keys()]);
  for (const [place, text] of a) {
    expect(marksOf(b.get(place)!), place).toEqual(marksOf(text));
    expect(b.get(place)!.trim(), place).not.toBe('');
  }
}

test('the files of the languages have the same keys and places', () => {
  const { LIBRARY: _, SOURCES: sources, ...story } = de;
  const { LIBRARY: __, SOURCES: englishSources, ...englishStory } = en;
  agree(englishStory, story);
  expect(Object.keys(sources.list)).toEqual(Object.keys(englishSources.list));
  // Motion and right guess of a lesson are no text.
  const { events, classes, ...texts } = german;
  const lessons = Object.fromEntries(
    Object.entries(english.lessons).map(([name, { title, question, guesses, answer }]) => [
      name,
      { title, question, guesses, answer },
    ]),
  );
  agree({ ...english, lessons }, texts);
  expect(Object.keys(classes).sort()).toEqual([...CLASSES].sort());
  const told = ['start', ...CAUSES, ...OUTCOMES.filter((it) => !/not_computed|invalid/.test(it))];
  expect(Object.keys(events).sort()).toEqual([...new Set(told)].sort());
});

const open = async (page: Page, address: string): Promise<void> => {
  watch(page);
  await page.goto(address);
  await ready(page);
};

test('the page and the story speak German, keep it, and go back with the motion', async ({
  page,
}) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await open(page, './story.html?lang=de');
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.locator('h1')).toHaveText(de.STORY.title);
  await expect(page).toHaveTitle(de.STORY.title);
  await expect(page.locator('#story')).not.toContainText(/NaN|undefined|\{|∞/);
  await expect(page.locator('[data-number="push.least"]')).toHaveText(/^0,78/);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
  const race = page.locator('#picture-race');
  await race.scrollIntoViewIfNeeded();
  await race.getByRole('slider', { name: 'Zeit' }).press('End');
  await expect(race.locator('.says')).toContainText(/^Der leichte Reifen springt nach 3,01 /);
  // The laboratory speaks it, too.
  await open(page, './#case=figure-3&level=simple');
  await expect(page.locator('h1')).toHaveText(german.page.title);
  await page.getByRole('button', { name: german.opening.guesses[0]! }).click();
  await page.getByRole('button', { name: german.page.last }).click();
  await expect(page.locator('#answer')).toContainText('HOPP: 0,63 R hoch. Du hattest recht.');
  await expect(page.locator('#sentence')).toHaveText(german.events.landing);
  // No English word is left in what the simple view shows.
  const shown = await page.locator('body').innerText();
  expect(shown.match(/\b(the|of|it|is|hop|to|none|grip)\b.*/gi)).toEqual([
    expect.stringContaining('of a rigid body'),
  ]);
  await page.getByRole('link', { name: 'English' }).click();
  await ready(page);
  await expect(page).toHaveURL(/lang=en#.*case=figure-3/);
  await expect(page.locator('h1')).toHaveText(english.page.title);
});
