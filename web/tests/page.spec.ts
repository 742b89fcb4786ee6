// The page as a page: accessible, offline, small screens, light and dark, and what it shows when it
// breaks.

import { readdirSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { CURVE_ROWS, CURVES } from '../src/generated/palette';
import { DIMENSIONLESS, QUANTITY_ROWS, SI } from '../src/generated/tables';
import { open, phases, pixelOf, ready, swipe } from './lab';

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, { tag: '@thorough' }, async ({ page }) => {
    test.slow();
    await page.emulateMedia({ colorScheme });
    for (const state of [
      'case=figure-3&at=0.7',
      'case=figure-7&at=2.4',
      'case=painleve',
      'mu_k=7',
      'case=figure-3-bounces&at=6&shows=hops',
      'case=jam&map=0',
      'case=ramp-jump&map=0',
      'mu_s=0.6&mu_k=0.3&restitution=0.6&map=0',
    ]) {
      await open(page, state);
      await page.reload();
      await ready(page);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(
        violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.html).join(' ')}`),
      ).toEqual([]);
    }
    await page.locator('#open-share').click();
    const { violations } = await new AxeBuilder({ page }).include('#share').analyze();
    expect(violations.map((it) => it.id)).toEqual([]);
  });
}

test('axe finds nothing in the simple view and in a lesson', { tag: '@thorough' }, async ({
  page,
}) => {
  test.slow();
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    for (const state of ['level=simple', 'lesson=grip', 'case=figure-3&map=0&symbols=0']) {
      await open(page, state);
      await page.reload();
      await ready(page);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(
        violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.html).join(' ')}`),
      ).toEqual([]);
    }
  }
});

test(
  'every view is drawn, and nothing is wider than the screen',
  { tag: '@thorough' },
  async ({ page }, info) => {
    const screens = [
      ['light', 1440, 900],
      ['dark', 1440, 900],
      ['light', 1280, 800],
      ['light', 1024, 768],
      ['light', 390, 844],
      ['light', 320, 700],
    ] as const;
    for (const [[theme, width, height], name] of screens.flatMap(
      (it) =>
        [
          [it, 'figure-3'],
          [it, 'figure-3-bounces'],
        ] as const,
    )) {
      await page.setViewportSize({ width, height });
      await open(page, `case=${name}&at=1.2&theme=${theme}&level=full`);
      await page.reload();
      await ready(page);
      await expect(page.locator('html[data-map=done]')).toBeAttached();
      await page.screenshot({
        path: info.outputPath(`${name}-${theme}-${width}.png`),
        fullPage: width < 1000,
      });
      // Something is drawn on every canvas: not all of its pixels are alike.
      for (const id of [
        'hoop',
        'plane-base',
        'plane-top',
        ...(name === 'figure-3' ? [] : ['routh']),
      ]) {
        const alike = await page.locator(`#${id}`).evaluate((canvas: HTMLCanvasElement) => {
          const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
          const pixels = new Uint32Array(data.buffer);
          return pixels.every((pixel) => pixel === pixels[0]);
        });
        expect(alike, id).toBe(false);
      }
      // No part of the page is wider than the screen.
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
        width,
      );
    }
  },
);

test('the theme button turns the page, and the link keeps it', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await open(page, 'case=figure-3');
  await page.locator('#theme').click();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
  await expect(page).toHaveURL(/theme=dark/);
  await page.locator('#theme').click();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'light');
});

test('on a phone the start is dragged with a finger', async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    baseURL: baseURL!,
  });
  const page = await context.newPage();
  await open(page, 'case=rolls-forever&level=full');
  await page.locator('#plane').scrollIntoViewIfNeeded();
  const to = await pixelOf(page, Math.PI / 2, 2);
  await page.touchscreen.tap(to.x, to.y);
  expect((await phases(page)).map((it) => it.mode)).toEqual([
    'sliding',
    'rolling',
    'sliding',
    'flight',
  ]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await context.close();
});

test('a swipe that begins on the plane scrolls the page, and leaves the start', ({
  browser,
  baseURL,
}) =>
  swipe([browser, baseURL!], 'map=0&level=full', async (page) => {
    await page.locator('#plane').scrollIntoViewIfNeeded();
    return pixelOf(page, 0, 0);
  }));

test('the numbers of an axis have the room that they need', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  // An axis is as wide as its longest number.
  const widths = await page
    .locator('.chart')
    .evaluateAll((charts) =>
      charts.map(
        (it) =>
          it.querySelector('.u-over')!.getBoundingClientRect().left -
          it.getBoundingClientRect().left,
      ),
    );
  const [, , normal, , energy] = widths as [number, number, number, number, number];
  expect(energy).toBeGreaterThan(normal);
  expect(energy).toBeGreaterThanOrEqual(12 + 8 * 3);
});

test('with the colours of the system phases, energy and legends keep theirs', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await open(page, 'case=figure-3-bounces&at=4&map=1');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const colours = (selector: string): Promise<Set<string>> =>
    page
      .locator(selector)
      .evaluateAll((all) => all.map((it) => getComputedStyle(it).backgroundColor))
      .then((all) => new Set(all));
  expect((await colours('.band')).size).toBeGreaterThan(2);
  expect((await colours('#energy-bar .part')).size).toBeGreaterThan(1);
  expect((await colours('#legend .swatch')).size).toBeGreaterThan(1);
});

test('on paper there is nothing to press', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await page.emulateMedia({ media: 'print' });
  for (const id of [
    'play',
    'copy-link',
    'open-share',
    'theme',
    'zoom-in',
    'start-handle',
    'slope-handle',
    'slider-mu_k',
  ]) {
    await expect(page.locator(`#${id}`)).toBeHidden();
  }
  for (const id of ['hoop', 'plane-base', 'phases', 'field-mu_k', 'sentence'])
    await expect(page.locator(`#${id}`)).toBeVisible();
});

test('it works without a network once it has been there', async ({ page, context }) => {
  await open(page, 'case=figure-3');
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.reload();
  await ready(page);
  await context.setOffline(true);
  await page.goto('./#case=figure-7');
  // It has read the address before it is left.
  await expect(page.locator('#case')).toHaveValue('figure-7');
  await page.reload();
  await ready(page);
  expect((await phases(page)).map((it) => it.end)).toContain('particle at the plane');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  await page.locator('#open-share').click();
  // The part that is loaded when it is needed is there as well.
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('#svg-hoop').click(),
  ]);
  expect(download.suggestedFilename()).toBe('figure-7-hoop.svg');
});

test('a panic of the core shows what happened, and a way out', async ({ page }) => {
  await page.goto('./#panic');
  const defect = page.locator('.defect');
  await expect(defect).toContainText('Internal error');
  await expect(defect).toContainText('asked for');
  await defect.getByRole('button', { name: 'Start with figure 3' }).click();
  await ready(page);
  await expect(page.locator('#case')).toHaveValue('figure-3');
});

test('a core that does not load is no blank page', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.fulfill({ status: 404, body: 'gone' }));
  await page.goto('./');
  await expect(page.locator('.defect')).toContainText('the core could not be loaded');
  await page.unroute('**/*.wasm');
  await page.getByRole('button', { name: 'Reload' }).click();
  await ready(page);
});

test('the outcome map follows the hoop', async ({ page }) => {
  await open(page, 'case=figure-3');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  await expect(page.locator('#legend li')).toHaveText(
    ['leaves at once', 'lifts off later', 'rolls for ever'],
    { useInnerText: true },
  );
  await page.locator('#massless').check();
  await expect(page.locator('#legend')).toContainText('particle at the plane');
  await page.locator('#map').uncheck();
  await expect(page.locator('#legend')).toBeHidden();
});

test('every quantity of the tables has a field with its unit, and every curve its place in the legend', async ({
  page,
}) => {
  await open(page, 'case=figure-3');
  await expect(page.locator('#curves li')).toHaveText([
    ...CURVES.map((it) => CURVE_ROWS[it].label),
    '𝓡, hatched: it can roll here',
  ]);
  const shown = async (): Promise<string[][]> =>
    page
      .locator('#fields .row')
      .evaluateAll((rows) =>
        rows
          .filter((row) => row.querySelector('input'))
          .map((row) => [
            row.querySelector('input')!.name,
            row.querySelector('.unit')!.textContent ?? '',
          ]),
      );
  for (const names of [
    [...DIMENSIONLESS, 'until'],
    [...SI, 'until_s'],
  ] as const) {
    expect(new Set(await shown())).toEqual(
      new Set([...names, 'restitution' as const].map((name) => [name, QUANTITY_ROWS[name].unit])),
    );
    await page.locator('#si').check();
  }
});

/** Bytes of files of the page, compressed as hosts compress them. */
function compressed(names: readonly string[]): number {
  const size = (name: string): number =>
    gzipSync(readFileSync(new URL(`../dist/${name}`, import.meta.url)), { level: 9 }).length;
  return names.reduce((sum, name) => sum + size(name), 0);
}

test('the page fetches at most 450 kB before its first picture, and 850 kB with the map', async ({
  page,
}) => {
  // The service worker fetches what is not shown, too.
  await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, 'serviceWorker'));
  await open(page, 'level=full');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const fetched = await page.evaluate(() => {
    const [ready] = performance.getEntriesByName('ready');
    return performance.getEntriesByType('resource').map(({ name, startTime }) => ({
      name: new URL(name).href.slice(new URL('.', location.href).href.length),
      isFirst: startTime < ready!.startTime,
    }));
  });
  const isCore = ({ name }: { name: string }): boolean => name.endsWith('.wasm');
  const sizeOf = (files: typeof fetched): number =>
    compressed(['index.html', ...new Set(files.map(({ name }) => name))]);
  const first = fetched.filter(({ isFirst }) => isFirst);
  expect(first.filter(isCore)).toHaveLength(1);
  expect(fetched.filter(isCore)).toHaveLength(2);
  expect(sizeOf(first)).toBeLessThanOrEqual(450_000);
  expect(sizeOf(fetched)).toBeLessThanOrEqual(850_000);
  // What makes films, codes and other languages is fetched by who wants it.
  expect(fetched.map(({ name }) => name).join(' ')).not.toMatch(/film|\bde-/);
});

test('colours are written in the generated files, and those of the page alone in its theme', () => {
  const root = new URL('../src/', import.meta.url);
  const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter((name) =>
    /\.(ts|css|js)$/.test(name),
  );
  const own = files.filter((name) => !/^(generated|wasm)\/|^style\/theme\.css$/.test(name));
  expect(own.length).toBeGreaterThan(30);
  expect(
    own.filter((name) => /#[\da-f]{6}\b/i.test(readFileSync(new URL(name, root), 'utf8'))),
  ).toEqual([]);
});
