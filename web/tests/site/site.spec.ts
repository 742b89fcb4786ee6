// The site in a browser: its pages are whole, readable and accessible, the laboratory lives in
// them, and search finds.

import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';

/** Pages of each kind: text with a frame, formulas, long tables, flags, docstrings, pictures. */
const PAGES = [
  'docs/index',
  'docs/start',
  'docs/theory/jumps',
  'docs/theory/contact',
  'docs/sweep',
  'docs/reference/command-line',
  'docs/reference/python',
  'docs/reference/files',
  'docs/gallery',
  'docs/howto/embed',
];

/** Opens a page. Any error in it, and any request to another host, fails the test. */
async function open(page: Page, name: string): Promise<void> {
  page.on('pageerror', (error) => {
    if (!error.message.startsWith('ResizeObserver loop')) throw error;
  });
  page.on('console', (message) => {
    if (message.type() === 'error') throw new Error(`${message.text()} ${message.location().url}`);
  });
  page.on('request', (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (protocol.startsWith('http') && hostname !== '127.0.0.1')
      throw new Error(`a request to ${request.url()}`);
  });
  await page.goto(`./${name}.html`);
}

test('nothing is wider than a phone', async ({ page }, info) => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const name of PAGES) {
    await page.goto(`./${name}.html`);
    await expect(page.locator('h1')).toHaveCount(1);
    expect(
      await page.evaluate(() => document.documentElement.scrollWidth),
      name,
    ).toBeLessThanOrEqual(390);
    await page.screenshot({ path: info.outputPath(`${name.replaceAll('/', '-')}.png`) });
  }
});

for (const [name, scheme] of [
  ['docs/index', 'light'],
  ['docs/index', 'dark'],
  ['docs/theory/jumps', 'light'],
  ['docs/howto/embed', 'dark'],
  ['docs/sweep', 'light'],
] as const) {
  test(`${name}, ${scheme}: axe finds nothing`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width: 390, height: 844 });
    await open(page, name);
    // What is in a frame is tested with the laboratory.
    const { violations } = await new AxeBuilder({ page }).exclude('iframe').analyze();
    expect(
      violations.map(
        (it) =>
          `${it.id}: ${it.nodes
            .slice(0, 3)
            .map((node) => node.html)
            .join(' ')}`,
      ),
    ).toEqual([]);
  });
}

test('the laboratory lives in its page', async ({ page }) => {
  await open(page, 'docs/live');
  const lab = page.frameLocator('iframe');
  await expect(lab.locator('html[data-map=done]')).toBeAttached();
  await expect(lab.locator('#now')).toHaveText('τ = 1.200');
  await lab.locator('#start-handle').focus();
  await page.keyboard.press('ArrowUp');
  await expect(lab.locator('#field-theta_rate')).toHaveValue('2.05');
});

test('a frame plays, and follows the theme of the page', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await open(page, 'docs/index');
  const frame = page.frameLocator('iframe');
  await frame.locator('#play').click();
  await expect
    .poll(async () => Number((await frame.locator('#now').textContent())!.slice(4)))
    .toBeGreaterThan(0.1);
  await page.evaluate(() => (document.body.dataset.theme = 'dark'));
  await expect(frame.locator('html')).toHaveAttribute('data-theme', 'dark');
  await page.evaluate(() => (document.body.dataset.theme = 'light'));
  await expect(frame.locator('html')).toHaveAttribute('data-theme', 'light');
});

test('the story has its place in the documentation', async ({ page }) => {
  await open(page, 'docs/story');
  await expect(page).toHaveURL(/lab\/story\.html$/);
  await expect(page.locator('html[data-ready=true]')).toBeAttached();
  await expect(page.locator('[data-number="cone.angle"]').first()).toHaveText('53.1°');
});

test('the first address leads to the first page', async ({ page }) => {
  await open(page, 'index');
  await expect(page).toHaveURL(/docs\/index\.html$/);
});

for (const [word, found] of [
  ['restitution', 'After the landing'],
  ['jump', 'One angle of a jump'],
  ['outcome_map', 'Python'],
] as const) {
  test(`search finds ${word} without a server`, async ({ page }) => {
    const site = resolve(process.env.LITTLEWOOD_SITE ?? '../target/site');
    await page.goto(`${pathToFileURL(site).href}/search.html?q=${word}`);
    await expect(
      page.locator('#search-results li a').filter({ hasText: found }).first(),
    ).toBeVisible();
  });
}

test('what names everything is found last', async ({ page }) => {
  const site = resolve(process.env.LITTLEWOOD_SITE ?? '../target/site');
  await page.goto(`${pathToFileURL(site).href}/search.html?q=hoop%20jump`);
  const found = page.locator('#search-results li > a');
  await expect(found.filter({ hasText: 'Changelog' })).toBeVisible();
  await expect(found.first()).not.toHaveText('Changelog');
});

test('the documentation of Rust is there, and is searched', async ({ page }) => {
  await page.goto('./docs/reference/rust.html');
  await page.locator('article a[href$="rust/littlewood/index.html"]').click();
  await expect(page).toHaveURL(/rust\/littlewood\/index\.html/);
  await expect(page.locator('h1')).toContainText('littlewood');
});
