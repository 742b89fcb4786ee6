// The story: each picture is live, each number is computed, and everything can be read, reached and
// printed.

import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import AxeBuilder from '@axe-core/playwright';
import { expect, type Page, test } from '@playwright/test';
import { PICTURES, SHEET, SOURCES, STORY } from '../src/story/text';
import * as de from '../src/story/texts/de';
import * as en from '../src/story/texts/en';
import { ready, watch } from './lab';

test.describe.configure({ mode: 'parallel' });

const NAMES = Object.keys(PICTURES) as (keyof typeof PICTURES)[];

async function open(page: Page, name = 'story'): Promise<void> {
  watch(page);
  await page.goto(`./${name}.html`);
  await ready(page);
}

const figure = (page: Page, name: string) => page.locator(`#picture-${name}`);

/** A sum of the pixels of the picture that is drawn. */
async function drawn(page: Page, name: string): Promise<number> {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
  return figure(page, name)
    .locator('canvas')
    .evaluate((it) => {
      let sum = 0;
      for (const character of (it as HTMLCanvasElement).toDataURL())
        sum = (31 * sum + character.charCodeAt(0)) | 0;
      return sum;
    });
}

async function numberOf(page: Page, name: string): Promise<number> {
  const text = await page.locator(`[data-number="${name}"]`).first().textContent();
  return Number(/[\d.]+/.exec(text!)![0]);
}

test('the question is kept until the hoop has answered it, and the guess is compared', async ({
  page,
}) => {
  await open(page);
  const picture = figure(page, 'question');
  await picture.scrollIntoViewIfNeeded();
  const says = picture.locator('.says');
  const { ask, right, wrong } = PICTURES.question.says;
  const go = (part: number): Promise<void> =>
    picture.getByRole('slider', { name: 'time' }).evaluate((it, to) => {
      (it as HTMLInputElement).value = String(to);
      it.dispatchEvent(new Event('input', { bubbles: true }));
    }, part);
  await expect(says).toHaveText(ask);
  const hops = picture.getByRole('button', { name: 'It hops' });
  const stays = picture.getByRole('button', { name: 'It stays down' });
  await hops.click();
  await expect(hops).toHaveAttribute('aria-pressed', 'true');
  await go(0.3);
  await expect(says).toHaveText(ask);
  await go(1);
  await expect(says).toHaveText(new RegExp(`^${right} It hops\\. It turns by \\d+`));
  await stays.click();
  await expect(says).toHaveText(new RegExp(`^${wrong} It hops`));
  // Once told it stays told; another push is another question.
  await go(0);
  await expect(says).toHaveText(new RegExp(`^${wrong} It hops`));
  await picture.getByRole('slider', { name: 'push' }).press('Home');
  await expect(says).toHaveText(ask);
  await expect(stays).toHaveAttribute('aria-pressed', 'false');
});

test('every control of every picture changes what is drawn', async ({ page }) => {
  // Smaller pictures are read sooner.
  await page.setViewportSize({ width: 640, height: 800 });
  await open(page);
  for (const name of NAMES) {
    const picture = figure(page, name);
    await picture.scrollIntoViewIfNeeded();
    await expect(picture).toHaveAttribute('data-drawn', /./);
    const sliders = picture.locator('input[type=range]');
    for (let i = 0; i < (await sliders.count()); i++) {
      const slider = sliders.nth(i);
      await slider.focus();
      await page.keyboard.press('Home');
      const least = await drawn(page, name);
      await page.keyboard.press('PageUp');
      expect(await drawn(page, name), `${name}, slider ${i}`).not.toBe(least);
      await expect(slider).toHaveAttribute('aria-valuetext', /\S/);
    }
    await expect(picture.locator('.says')).toHaveText(/\S/);
  }
});

test('what is said follows the controls', async ({ page }) => {
  await open(page);
  const says = (name: string) => figure(page, name).locator('.says');
  const set = (name: string, label: string, value: number): Promise<void> =>
    figure(page, name)
      .getByRole('slider', { name: label })
      .evaluate((it, to) => {
        (it as HTMLInputElement).value = String(to);
        it.dispatchEvent(new Event('input', { bubbles: true }));
      }, value);
  const at = async (name: keyof typeof PICTURES): Promise<void> =>
    figure(page, name).scrollIntoViewIfNeeded();

  await at('question');
  for (const [push, fate] of [
    [0.2, 'slips'],
    [1.3, 'atOnce'],
  ] as const) {
    await set('question', 'push', push);
    await expect(says('question')).toHaveText(PICTURES.question.says.ask);
    await set('question', 'time', 1);
    await expect(says('question')).toHaveText(PICTURES.question.says[fate]);
  }

  // N is the cosine of the angle.
  await at('forces');
  await set('forces', 'angle', 60);
  await expect(says('forces')).toContainText('50 %');
  await set('forces', 'angle', 120);
  await expect(says('forces')).toContainText('pull with 50 %');

  // tan 30° is 0.577.
  await at('cone');
  await set('cone', 'angle', 60);
  await expect(says('cone')).toContainText('0.58 times N');
  await expect(says('cone')).toContainText('has slipped at 53.1°');
  await set('cone', 'μ', 0.6);
  await expect(says('cone')).toContainText('it grips');

  await at('inertia');
  await set('inertia', 'inertia', 50);
  await expect(says('inertia')).toContainText('glides, and the ground pushes with 0 %');

  await at('angle');
  await set('angle', 'lift-off', 60);
  await expect(says('angle')).toContainText('lift off 60°');
  // The law: (cos φ − 1 + φ²/2)/(φ − sin φ) = tan 60°.
  const turned = [
    ...(await says('angle').textContent())!.matchAll(/(?:turns|second|third) by ([\d.]+)°/g),
  ].map(([, it]) => (Number(it) * Math.PI) / 180);
  expect(turned).toHaveLength(3);
  for (const phi of turned)
    expect((Math.cos(phi) - 1 + phi ** 2 / 2) / (phi - Math.sin(phi))).toBeCloseTo(
      Math.tan(Math.PI / 3),
      4,
    );

  await at('jam');
  await set('jam', 'μ', 0.9);
  await expect(says('jam')).toHaveText(PICTURES.jam.says.jams);

  await at('bounce');
  await set('bounce', 'restitution', 0);
  await expect(says('bounce')).toContainText('comes down once');

  await at('climb');
  await set('climb', 'slope', 30);
  await expect(says('climb')).toHaveText(PICTURES.climb.says.falls);

  await at('answer');
  await set('answer', 'push', 2);
  await expect(says('answer')).toHaveText(PICTURES.answer.says.atOnce);
  await set('answer', 'push', 0);
  await expect(says('answer')).toHaveText(PICTURES.answer.says.stays);
  await expect(figure(page, 'answer')).toHaveAttribute('data-cells', String(54 * 36));
});

test('ten thousand hoops are let go, and one is chosen by keys and by a finger', async ({
  browser,
  baseURL,
}) => {
  for (const { width, side } of [
    { width: 1440, side: 100 },
    { width: 360, side: 64 },
  ]) {
    const context = await browser.newContext({
      viewport: { width, height: 800 },
      hasTouch: true,
      ...(baseURL === undefined ? {} : { baseURL }),
      // Nothing plays by itself.
      reducedMotion: 'reduce',
    });
    const page = await context.newPage();
    await open(page);
    const picture = figure(page, 'release');
    await expect(picture).toHaveAttribute('data-followed', String(side * side));
    const time = picture.getByRole('slider', { name: 'time' });
    await expect(time).toHaveValue('0');
    const counts = (): Promise<number[]> =>
      picture
        .locator('.counts b')
        .allTextContents()
        .then((all) => all.map((it) => Number(it.replace(/\D/g, ''))));
    const sum = async (): Promise<number> => (await counts()).reduce((a, b) => a + b, 0);
    expect(await sum()).toBe(side * side);
    // At the start nothing has landed; at the end nearly all have come to an end.
    await expect(picture.locator('.says')).toContainText(' 0 have landed');
    await time.focus();
    await page.keyboard.press('End');
    await expect(picture.locator('.says')).not.toContainText(' 0 have landed');
    expect(await sum()).toBe(side * side);
    expect((await counts())[0]).toBeLessThan(0.01 * side * side);
    // By keys: a square is a step. Its hoop is that of the link.
    const link = picture.getByRole('link');
    const startOf = async (): Promise<number[]> => {
      const url = new URLSearchParams((await link.getAttribute('href'))!.split('#')[1]);
      return ['theta', 'theta_rate'].map((it) => Number(url.get(it)));
    };
    await picture.getByRole('slider', { name: 'angle of the weight' }).press('Home');
    await picture.getByRole('slider', { name: 'rate of turning' }).press('Home');
    await drawn(page, 'release');
    const edge = 1 - 1 / side;
    expect(await startOf()).toEqual([
      expect.closeTo(-Math.PI * edge, 9),
      expect.closeTo(4 * edge, 9),
    ]);
    // By a finger, in the middle of the plane.
    const canvas = picture.locator('canvas');
    const [box, grip] = [
      (await canvas.boundingBox())!,
      (await picture.locator('.grip').boundingBox())!,
    ];
    const position = {
      x: grip.x + grip.width / 2 - box.x + 0.2 * box.width,
      y: grip.y + grip.height / 2 - box.y + 0.2 * box.width,
    };
    await canvas.tap({ position });
    await drawn(page, 'release');
    const [theta, rate] = (await startOf()) as [number, number];
    expect(theta).toBeGreaterThan(-2);
    expect(rate).toBeLessThan(3);
    await expect(time).toHaveValue('0');
    await context.close();
  }
});

test('the race says who hopped where and when, at 360 pixels and by keys', async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const picture = figure(page, 'race');
  await picture.scrollIntoViewIfNeeded();
  const { ask, stayed } = PICTURES.race.says;
  const says = picture.locator('.says');
  await expect(says).toHaveText(ask);
  // From event to event, until all have landed.
  await picture.getByRole('button', { name: 'Play' }).press('Enter');
  await expect(says).toContainText(/the light hoop (rolls|slides|flies)/);
  await picture.getByRole('slider', { name: 'time' }).press('End');
  // Events of the three motions by the command line: lift-offs at τ = 3.0125 and 3.4756.
  await expect(says).toContainText(
    /^The light hoop hops after 3\.01 .*; the real hoop hops after 3\.48 /,
  );
  await expect(says).toContainText(stayed.replace('{names}', 'Littlewood’s hoop'));
  // Another start is another race; from a strong push the heavy one leaves at once, too.
  await picture.getByRole('slider', { name: 'push' }).press('Home');
  await expect(says).toHaveText(ask);
  await picture.getByRole('slider', { name: 'time' }).press('End');
  await expect(says).toContainText(/never hops\.$/);
});

test('the weight is dragged, and its slider follows', async ({ page }) => {
  await open(page);
  await figure(page, 'cone').scrollIntoViewIfNeeded();
  await drawn(page, 'cone');
  const grip = (await figure(page, 'cone').locator('.grip').boundingBox())!;
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 60, { steps: 4 });
  await page.mouse.up();
  expect(await figure(page, 'cone').getByRole('slider', { name: 'angle' }).inputValue()).not.toBe(
    '30',
  );
});

test('a start is dropped where one clicks', async ({ page }) => {
  await open(page);
  await figure(page, 'map').scrollIntoViewIfNeeded();
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const canvas = figure(page, 'map').locator('canvas');
  const { width, height } = (await canvas.boundingBox())!;
  // At the top, fast: it leaves at once. In the margins of the plane there is a third of the turn
  // and a half to the left of it.
  await canvas.click({ position: { x: 46 + (width - 60) / 3, y: 14 } });
  await expect(figure(page, 'map').locator('.says')).toHaveText(PICTURES.map.says.leaves_at_once);
  await canvas.click({ position: { x: 46 + (width - 60) / 3, y: height / 2 - 14 } });
  await expect(figure(page, 'map').locator('.says')).toHaveText(PICTURES.map.says.stays);
});

test('a film of the reader follows the time of the picture, and is sent nowhere', async ({
  page,
}) => {
  await open(page);
  const picture = figure(page, 'film');
  await picture.scrollIntoViewIfNeeded();
  // A film of a second, made here.
  const film = await page.evaluate(async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 64, height: 48 });
    const context = canvas.getContext('2d')!;
    const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: 'video/webm' });
    const chunks: Blob[] = [];
    recorder.ondataavailable = ({ data }) => chunks.push(data);
    const stopped = new Promise((done) => {
      recorder.onstop = done;
    });
    recorder.start();
    for (let i = 0; i < 30; i++) {
      context.fillRect(i, i, 9, 9);
      await new Promise((done) => setTimeout(done, 33));
    }
    recorder.stop();
    await stopped;
    return Array.from(new Uint8Array(await new Blob(chunks).arrayBuffer()));
  });
  await picture
    .locator('input[type=file]')
    .setInputFiles({ name: 'hop.webm', mimeType: 'video/webm', buffer: Buffer.from(film) });
  const video = picture.locator('video');
  await expect(video).toBeVisible();
  await expect
    .poll(() => video.evaluate((it) => (it as HTMLVideoElement).readyState))
    .toBeGreaterThan(0);
  const time = picture.getByRole('slider', { name: 'time' });
  await time.focus();
  await page.keyboard.press('Home');
  await picture.getByRole('button', { name: PICTURES.film.controls.mark }).click();
  await time.focus();
  await page.keyboard.press('End');
  await expect
    .poll(() => video.evaluate((it) => (it as HTMLVideoElement).currentTime))
    .toBeGreaterThan(0.2);
});

test('the angle at which it turns once is found, and the answer waits', async ({ page }) => {
  await open(page);
  const picture = figure(page, 'angle');
  await picture.scrollIntoViewIfNeeded();
  await expect(picture.locator('.says')).toContainText('too little');
  await expect(page.locator('[data-number="angle.whole"]')).toBeHidden();
  // tan 72.34° = π.
  await picture.locator('input[type=range]').first().fill('72.3');
  await expect(picture.locator('.says')).toContainText('Once round');
});

test('no number is typed in the text', () => {
  const { list } = SOURCES;
  for (const { STORY, PICTURES, SHEET, SOURCES } of [en, de]) {
    const text = JSON.stringify([STORY, PICTURES, SHEET, SOURCES.heading]);
    const left = text
      .replace(/\b(19|20)\d\d\b/g, '')
      .replace(/"id":"[^"]*"|\(\d\.\d+\)|N = 0|= 0|Figure \d/g, '');
    expect(left.match(/.{0,30}\d.{0,10}/g)).toBeNull();
  }
  expect(Object.keys(list).length).toBeGreaterThan(5);
});

test('the numbers are those of the theory', async ({ page }) => {
  await open(page);
  const degrees = (angle: number): number => (angle * 180) / Math.PI;
  for (const [name, expected, digits] of [
    // Littlewood's place: N = cos θ.
    ['rolling.zero', 90, 1],
    ['rolling.friction', 1, 2],
    // (3.9) of the paper.
    ['cone.angle', degrees(2 * Math.atan(0.5)), 1],
    // The law of the jump: a whole turn at tan θ = π, four times a small angle.
    ['angle.whole', degrees(Math.atan(Math.PI)), 1],
    ['angle.small', 4, 1],
    ['angle.example', 45, 0],
    // θ′² = 1/h at the top, h = 0.8.
    ['push.most', Math.sqrt(1 / 0.8), 2],
    // P = 0 at θ = 0.5 for m₁ = m₂/8: μ = (ϱ + h²s²)/(hs(1 + hc)), ϱ = 1 − h², h = 8/9.
    [
      'jam.mu',
      (1 - (8 / 9) ** 2 + ((8 / 9) * Math.sin(0.5)) ** 2) /
        ((8 / 9) * Math.sin(0.5) * (1 + (8 / 9) * Math.cos(0.5))),
      2,
    ],
  ] as const) {
    expect(Math.abs((await numberOf(page, name)) - expected), name).toBeLessThanOrEqual(
      0.5001 * 10 ** -digits,
    );
  }
  // A push that is too weak by energy: θ′² > (1 − h)/2h.
  expect(await numberOf(page, 'push.least')).toBeGreaterThan(Math.sqrt(0.2 / 1.6));
  // The disc of the ramp: the study of it has 0.0029 R, and R is 50 mm. Each is rounded to two
  // digits.
  expect(Math.abs((await numberOf(page, 'ramp.slip')) - 50 * 0.0029)).toBeLessThanOrEqual(
    0.005 + 50 * 0.00005,
  );
  await expect(page.locator('#story')).not.toContainText(/NaN|undefined|\{|∞/);
});

test('its links lead into the laboratory, and back', async ({ page }) => {
  await open(page);
  await figure(page, 'ramp').scrollIntoViewIfNeeded();
  await figure(page, 'ramp').getByRole('link').click();
  await ready(page);
  await expect(page.locator('#outcome')).toContainText('Lands');
  await expect(page.locator('#banner')).toBeHidden();
  await page.getByRole('link', { name: 'The story' }).click();
  await ready(page);
  // Places of the page, and pages beside it.
  const targets = await page
    .locator('a[href]')
    .evaluateAll((all) => all.map((it) => it.getAttribute('href')!));
  for (const target of new Set(targets)) {
    if (target.startsWith('#')) await expect(page.locator(target), target).toHaveCount(1);
    else expect(target).toMatch(/^(\.\/(index|sheet)\.html(#[^\s]*)?|\?lang=de)$/);
  }
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, { tag: '@thorough' }, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    for (const name of ['story', 'sheet']) {
      await open(page, name);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations.map((it) => `${it.id}: ${it.nodes[0]?.html}`)).toEqual([]);
    }
  });
}

test('who wants no motion gets steps, and nothing moves by itself', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const picture = figure(page, 'question');
  await picture.scrollIntoViewIfNeeded();
  await drawn(page, 'question');
  const count = async (): Promise<number> => Number(await picture.getAttribute('data-drawn'));
  const before = await count();
  await page.waitForTimeout(300);
  expect(await count()).toBe(before);
  await picture.getByRole('button', { name: 'Play' }).click();
  // At once at the next event, and still until the one after.
  await expect(picture.getByRole('slider', { name: 'time' })).not.toHaveValue('0');
  await drawn(page, 'question');
  const stepped = await count();
  await page.waitForTimeout(300);
  expect(await count()).toBe(stepped);
  await picture.getByRole('button', { name: 'Pause' }).click();
});

test('it plays, is paused, and stops out of sight', async ({ page }) => {
  await open(page);
  const picture = figure(page, 'question');
  await picture.scrollIntoViewIfNeeded();
  await picture.getByRole('button', { name: 'Play' }).click();
  await expect(picture.locator('.says')).toHaveAttribute('aria-busy', 'true');
  await expect
    .poll(() => picture.getByRole('slider', { name: 'time' }).inputValue().then(Number))
    .toBeGreaterThan(0.05);
  await page.evaluate(() => window.scrollTo(0, document.body.scrollHeight));
  await expect(picture.locator('.play')).toHaveText('Play');
  await expect(picture.locator('.says')).toHaveAttribute('aria-busy', 'false');
});

for (const width of [390, 320]) {
  test(`nothing is wider than ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    for (const name of ['story', 'sheet']) {
      await open(page, name);
      expect(
        await page.evaluate(() => document.documentElement.scrollWidth),
        name,
      ).toBeLessThanOrEqual(width);
    }
  });
}

test('it is fetched in at most 420 kB, and in 850 kB with the maps', async ({ page }) => {
  // The service worker fetches what is not shown, too.
  await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, 'serviceWorker'));
  await open(page);
  await figure(page, 'map').scrollIntoViewIfNeeded();
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  for (const name of NAMES) await figure(page, name).scrollIntoViewIfNeeded();
  // What was asked for until the text was there, and all.
  const fetched = (until: string | null): Promise<string[]> =>
    page.evaluate((mark) => {
      const end = mark === null ? Infinity : performance.getEntriesByName(mark)[0]!.startTime;
      const all = performance.getEntriesByType('resource').filter((it) => it.startTime < end);
      const files = all.map(({ name }) => new URL(name).pathname.split('/hoop/')[1]!);
      return ['story.html', ...new Set(files)];
    }, until);
  const compressed = (files: readonly string[]): number =>
    files
      .map((it) => readFileSync(new URL(`../dist/${it}`, import.meta.url)))
      .reduce((sum, file) => sum + gzipSync(file, { level: 9 }).length, 0);
  const modules = (files: readonly string[]) => files.filter((it) => it.endsWith('.wasm'));
  const first = await fetched('ready');
  expect(modules(first)).toHaveLength(1);
  expect(compressed(first)).toBeLessThanOrEqual(420_000);
  const all = await fetched(null);
  expect(modules(all)).toHaveLength(2);
  expect(compressed(all)).toBeLessThanOrEqual(850_000);
});

test('it works without a network once it has been there', async ({ page, context }) => {
  await open(page);
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.reload();
  await ready(page);
  await context.setOffline(true);
  await page.reload();
  await ready(page);
  await figure(page, 'angle').scrollIntoViewIfNeeded();
  await expect(figure(page, 'angle').locator('.says')).toContainText('189.085°');
  await page.goto('./sheet.html');
  await ready(page);
});

test('the sheet is one page of paper', async ({ page }) => {
  await open(page, 'sheet');
  await page.emulateMedia({ media: 'print' });
  await expect(page.getByRole('button')).toBeHidden();
  for (const format of ['A4', 'Letter']) {
    const pdf = await page.pdf({ format });
    expect(pdf.toString('latin1').match(/\/Type\s*\/Page\b/g), format).toHaveLength(1);
  }
});

test('title and description are those of the text', async ({ page }) => {
  for (const [name, title] of [
    ['story', STORY.title],
    ['sheet', SHEET.title],
  ] as const) {
    await open(page, name);
    await expect(page).toHaveTitle(title);
    await expect(page.locator('h1')).toHaveText(title);
  }
});
