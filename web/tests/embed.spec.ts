// The page as a frame in another one.

import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { open, ready } from './lab';

/** Another page, on the same machine. */
async function lecture(page: Page, body: string): Promise<void> {
  await page.route('**/lecture', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><title>a lecture</title>${body}`,
    }),
  );
  await page.goto('/lecture');
}

test('a frame shows the hoop, what happens, and the time line, and nothing to set', async ({
  page,
}) => {
  await page.setViewportSize({ width: 640, height: 420 });
  await open(page, 'case=figure-3&at=1.2&embed=1');
  for (const id of ['hoop', 'sentence', 'play', 'time', 'now', 'whole'])
    await expect(page.locator(`#${id}`)).toBeVisible();
  for (const id of [
    'case',
    'open-share',
    'theme',
    'fields',
    'plane',
    'plots',
    'phases',
    'speed',
    'loop',
    'follow',
    'next',
  ]) {
    await expect(page.locator(`#${id}`)).toBeHidden();
  }
  for (const it of ['.weight', '#pin', '.ask', '.words'])
    await expect(page.locator(it)).toBeHidden();
  // Everything is in sight: neither is there a bar to scroll.
  const { width, height } = await page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    height: document.documentElement.scrollHeight,
  }));
  expect([width, height]).toEqual([640, 420]);
  await page.locator('#play').click();
  await expect
    .poll(async () => Number((await page.locator('#now').textContent())!.slice(4)))
    .toBeGreaterThan(1.25);
  await page.locator('#play').click();
  await expect(page).toHaveURL(/embed=1/);
});

test('a frame computes no map', async ({ page }) => {
  await open(page, 'case=figure-3&embed=1');
  await page.waitForTimeout(200);
  expect(page.workers()).toHaveLength(0);
  expect(await page.locator('html').getAttribute('data-map')).toBeNull();
  await page.evaluate(() => (location.hash = 'case=figure-3'));
  await expect(page.locator('#plane')).toBeVisible();
  await expect(page.locator('html[data-map=done]')).toBeAttached();
});

test('its link opens the whole laboratory at the same instant', async ({ page, context }) => {
  await open(page, 'case=figure-3&at=1.2&embed=1');
  await page.locator('#time').press('Home');
  await page.locator('#time').press('End');
  const [other] = await Promise.all([context.waitForEvent('page'), page.locator('#whole').click()]);
  await ready(other);
  await expect(other.locator('#plane')).toBeVisible();
  await expect(other.locator('#now')).toHaveText('τ = 3.847');
});

test('the dialogue has the frame, and the frame shows the motion', async ({ page }) => {
  await open(page, 'case=figure-7&at=2');
  await page.locator('#open-share').click();
  const text = await page.locator('#frame-text').inputValue();
  await lecture(page, text);
  const frame = page.frameLocator('iframe');
  await expect(frame.locator('#mode')).toHaveText('gliding');
  await expect(frame.locator('#now')).toHaveText('τ = 2.000');
});

test('the dialogue says where the frame works', async ({ page, baseURL }) => {
  await open(page, 'case=figure-7');
  await page.locator('#open-share').click();
  await expect(page.locator('#frame-note')).toContainText(
    'the frame works in pages served from it, as http://localhost',
  );
  // The same files on a host of the web.
  const web = await page.context().newPage();
  await web.route('https://hoop.example/**', async (route) => {
    const file = new URL(route.request().url()).pathname.slice(1);
    await route.fulfill({ response: await route.fetch({ url: `${baseURL}${file}` }) });
  });
  await web.goto('https://hoop.example/#case=figure-7');
  await ready(web);
  await web.locator('#open-share').click();
  await expect(web.locator('#frame-note')).toHaveText(
    'Any page may have this frame; one with a content security policy must name hoop.example in its frame-src.',
  );
  expect(await web.locator('#frame-text').inputValue()).toContain('src="https://hoop.example/#');
});

const program = process.env.LITTLEWOOD ?? '';

/** `littlewood lab`, and the address that it tells. */
async function lab(): Promise<[ChildProcess, string]> {
  const server = spawn(program, ['lab', '--no-open', '--page', 'dist'], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const address = await new Promise<string>((resolve) => {
    server.stdout!.on('data', (text: Buffer) => {
      const found = /http:\S+/.exec(text.toString());
      if (found) resolve(found[0]);
    });
  });
  return [server, address];
}

test('pages of this machine may have the page of littlewood lab in a frame, and no others', async ({
  page,
}) => {
  test.skip(!existsSync(program), 'LITTLEWOOD names no program');
  const [server, address] = await lab();
  let lectures: Server | undefined;
  try {
    const errors: string[] = [];
    page.on('console', (it) => it.type() === 'error' && errors.push(it.text()));
    await page.goto(`${address}#case=figure-7&at=2`);
    await ready(page);
    // The service worker that it is given ends itself.
    const workers = (): Promise<number> =>
      page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length);
    await expect.poll(workers).toBe(0);
    await page.locator('#open-share').click();
    const text = await page.locator('#frame-text').inputValue();
    expect(errors).toEqual([]);
    const mode = page.frameLocator('iframe').locator('#mode');
    lectures = createServer((request, response) => {
      const found = request.url === '/' ? 200 : 204;
      response.writeHead(found, { 'content-type': 'text/html' }).end(found === 200 ? text : '');
    }).listen(0, '127.0.0.1');
    await once(lectures, 'listening');
    const { port } = lectures.address() as AddressInfo;
    for (const host of ['127.0.0.1', 'localhost']) {
      await page.goto(`http://${host}:${port}/`);
      await expect(mode).toHaveText('gliding');
    }
    expect(errors).toEqual([]);
    // Another name, though it leads to this machine, too.
    await page.goto(`http://lecture.localhost:${port}/`);
    await expect.poll(() => errors.join(' ')).toContain('frame-ancestors');
    await expect(mode).toHaveCount(0);
  } finally {
    server.kill();
    lectures?.close();
  }
});

for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing in a frame, ${theme}`, async ({ page }) => {
    await page.setViewportSize({ width: 360, height: 400 });
    await open(page, `case=figure-3-bounces&at=4.2&embed=1&theme=${theme}`);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(
      violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.html).join(' ')}`),
    ).toEqual([]);
  });
}

test('a frame and the page around it tell each other of the state', async ({ page, baseURL }) => {
  await lecture(page, '<iframe id="frame" width="640" height="420"></iframe>');
  await page.evaluate(() => {
    Object.assign(window, { heard: [] });
    window.addEventListener('message', ({ data }) =>
      (window as unknown as { heard: unknown[] }).heard.push(data),
    );
  });
  await page
    .locator('#frame')
    .evaluate(
      (frame: HTMLIFrameElement, base) => (frame.src = `${base}#case=figure-3&embed=1`),
      baseURL!,
    );
  const heard = (): Promise<unknown[]> => page.evaluate('heard');
  await expect.poll(heard).toContainEqual({ littlewood: { ready: true } });
  const frame = page.frameLocator('#frame');
  await page
    .locator('#frame')
    .evaluate((it: HTMLIFrameElement) =>
      it.contentWindow!.postMessage({ littlewood: { link: 'case=figure-7&at=2&embed=1' } }, '*'),
    );
  await expect(frame.locator('#mode')).toHaveText('gliding');
  await frame.locator('#time').press('Home');
  await expect.poll(heard).toContainEqual({ littlewood: { link: 'case=figure-7&embed=1' } });
});

test('a frame tells of what changes, not of what it was opened with', async ({ page, baseURL }) => {
  await lecture(page, '<iframe id="frame" width="640" height="420"></iframe>');
  await page.evaluate((src) => {
    Object.assign(window, { heard: [] });
    window.addEventListener('message', ({ data }) =>
      (window as unknown as { heard: unknown[] }).heard.push(data),
    );
    document.querySelector('iframe')!.src = src;
  }, `${baseURL}#case=figure-7&at=2&embed=1`);
  const frame = page.frameLocator('#frame');
  await expect(frame.locator('#now')).toHaveText('τ = 2.000');
  await page.waitForTimeout(1000);
  const heard = (): Promise<unknown[]> => page.evaluate('heard');
  expect(await heard()).toEqual([{ littlewood: { ready: true } }]);
  await frame.locator('#time').press('Home');
  await expect.poll(heard).toContainEqual({ littlewood: { link: 'case=figure-7&embed=1' } });
});
