// Exports: the bytes of the command line, pictures, and lines to copy.

import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { open, type } from './lab';

async function text(
  page: Page,
  button: string,
): Promise<{ name: string; text: string; bytes: Buffer }> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator(button).click(),
  ]);
  const bytes = readFileSync(await download.path());
  return { name: download.suggestedFilename(), text: bytes.toString('utf8'), bytes };
}

test('data have the format of the command line', async ({ page }) => {
  await open(page, 'case=figure-3');
  await page.locator('#open-share').click();
  const json = await text(page, '#save-json');
  expect(json.name).toBe('figure-3.json');
  const document = JSON.parse(json.text);
  expect(document.case).toBe('figure-3');
  expect(document.transitions).toHaveLength(4);
  expect(Math.abs(document.transitions[2].time - 1.518670213819437)).toBeLessThan(1e-14);
  // As samples, unless the field is emptied: then as events.
  const instants = 400 + 2 * 3;
  expect(document.samples).toHaveLength(instants);
  const curves = await text(page, '#save-csv');
  const [columns, ...rows] = curves.text.trim().split('\n');
  expect(columns!.split(',')).toEqual(expect.arrayContaining(['normal', 'friction', 'energy']));
  expect(rows).toHaveLength(instants);
  await page.locator('#samples').fill('');
  expect(JSON.parse((await text(page, '#save-json')).text).samples).toBeUndefined();
  const csv = await text(page, '#save-csv');
  expect(csv.text.split('\n')[0]).toBe('time,theta,theta_rate,slip,x,from,to,direction,cause');
  expect(csv.text.trim().split('\n')).toHaveLength(6);
  await page.locator('#samples').fill('100');
  const sampled = await text(page, '#save-csv');
  // A hundred instants, and every transition within twice.
  expect(sampled.text.trim().split('\n')).toHaveLength(1 + 100 + 2 * 3);
  await page.locator('#samples').fill('1');
  await expect(page.locator('#samples-message')).not.toBeEmpty();
});

test('what is copied says so where it is seen, from the page and from the dialogue', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, 'case=figure-3');
  /** Whether nothing lies over the note. */
  const isSeen = (): Promise<boolean> =>
    page.locator('#toast').evaluate((note) => {
      const { x, y, width, height } = note.getBoundingClientRect();
      note.style.pointerEvents = 'auto';
      const top = document.elementFromPoint(x + width / 2, y + height / 2);
      return width > 0 && getComputedStyle(note).visibility === 'visible' && note.contains(top);
    });
  for (const button of ['#copy-link', '#copy-python-text']) {
    if (button !== '#copy-link') await page.locator('#open-share').click();
    await page.locator(button).click();
    await expect(page.locator('#toast')).toHaveText('Copied.');
    await expect.poll(isSeen).toBe(true);
  }
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(
    'lw.case("figure-3")',
  );
});

test('every view is an SVG and a PNG', { tag: '@thorough' }, async ({ page }) => {
  await open(page, 'case=figure-3&at=2');
  await page.locator('#open-share').click();
  await expect(page.locator('#picture-impact')).toBeHidden();
  await page.locator('#close-share').click();
  await page.locator('#bounces').check();
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  await page.locator('#open-share').click();
  const views = [
    ['hoop', ['C', 'm₂']],
    ['plane', ['3π/2', '𝓡']],
    ['plots', ['|F|/N', 'E']],
    ['impact', ['end', '√(gR)']],
  ] as const;
  for (const [view, labels] of views) {
    const svg = await text(page, `#svg-${view}`);
    expect(svg.name).toBe(`figure-3-bounces-${view}.svg`);
    const problems = await page.evaluate((source) => {
      const parsed = new DOMParser().parseFromString(source, 'image/svg+xml');
      return parsed.querySelector('parsererror')?.textContent ?? '';
    }, svg.text);
    expect(problems).toBe('');
    for (const label of labels) expect(svg.text).toContain(label);
    expect(svg.text).not.toContain('NaN');
    const png = await text(page, `#png-${view}`);
    expect(png.bytes.subarray(1, 4).toString()).toBe('PNG');
    expect(png.bytes.readUInt32BE(16)).toBe(1800);
  }
});

test('the lines to copy have every digit', async ({ page }) => {
  await open(page, 'case=figure-3');
  await page.locator('#open-share').click();
  await expect(page.locator('#shell-text')).toHaveValue('littlewood simulate figure-3');
  await expect(page.locator('#python-text')).toHaveValue(
    'import littlewood as lw; motion = lw.case("figure-3").simulate()',
  );
  await page.locator('#close-share').click();
  await type(page, 'theta', '-0.1234567890123456');
  await page.locator('#open-share').click();
  await expect(page.locator('#shell-text')).toHaveValue(
    'littlewood simulate --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 --theta -0.1234567890123456 --theta-rate 2',
  );
  await expect(page.locator('#python-text')).toHaveValue(
    'import littlewood as lw; motion = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4).simulate(theta=-0.1234567890123456, theta_rate=2)',
  );
  await page.locator('#close-share').click();
  await page.locator('#bounces').check();
  await page.locator('#law').selectOption('poisson');
  await type(page, 'gap_rate', '0.25');
  await page.locator('#open-share').click();
  await expect(page.locator('#shell-text')).toHaveValue(
    'littlewood simulate --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4 --theta -0.1234567890123456 --theta-rate 2 --gap-rate 0.25 --restitution 0.5 --restitution-law poisson',
  );
  await expect(page.locator('#python-text')).toHaveValue(
    'import littlewood as lw; motion = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5, restitution_law="poisson").simulate(theta=-0.1234567890123456, theta_rate=2, gap_rate=0.25)',
  );
});

test('a film of the hoop is a GIF, and MP4 where this browser encodes video', async ({ page }) => {
  // A fast clock makes a short film.
  await open(page, 'case=figure-3&speed=4');
  await page.locator('#open-share').click();
  const said = page.locator('#film-progress');
  const gif = await text(page, '#gif-hoop');
  expect(gif.name).toBe('figure-3.gif');
  expect(gif.bytes.subarray(0, 6).toString()).toBe('GIF89a');
  expect(gif.bytes.readUInt16LE(6)).toBe(720);
  // 3.85 of the motion at 4 a second are 0.96 s: 20 frames, of which the first has the colours.
  expect(gif.bytes.toString('latin1').split('\x21\xf9\x04')).toHaveLength(1 + 20);
  await expect(said).toContainText('figure-3.gif');
  if (await page.evaluate(() => 'VideoEncoder' in window)) {
    const { name, bytes } = await text(page, '#mp4-hoop');
    expect(name).toBe('figure-3.mp4');
    // In a page of its own: this one plays nothing.
    const other = await page.context().newPage();
    const [duration, width] = await other.evaluate(
      async (data) => {
        const video = document.createElement('video');
        await new Promise((done, failed) => {
          [video.onloadeddata, video.onerror] = [done, failed];
          video.src = data;
        });
        return [video.duration, video.videoWidth] as const;
      },
      `data:video/mp4;base64,${bytes.toString('base64')}`,
    );
    await other.close();
    expect(width).toBe(720);
    expect(Math.abs(duration - 0.96)).toBeLessThan(0.1);
  }
  // Where it does not, it says so.
  await page.evaluate(() => Reflect.deleteProperty(window, 'VideoEncoder'));
  await page.locator('#mp4-hoop').click();
  await expect(said).toHaveText('No film: this browser does not encode video; take the GIF.');
});
