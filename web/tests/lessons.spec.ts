// Lessons: a question, a guess, an answer; and two motions side by side.

import { expect, test } from '@playwright/test';
import texts from '../src/texts/en.json' with { type: 'json' };
import { field, open, phases, ready, watch } from './lab';

/** What the paper, its equations and the reference motions say: how each lesson's motion goes on, and which guess is right. */
const TRUTH = {
  hop: { modes: ['sliding', 'rolling', 'sliding', 'flight'], right: 'It hops' },
  // Section 2(f): rolls, slips once, then jumps.
  slip: { modes: ['rolling', 'sliding', 'flight'], right: 'It slips' },
  grip: { modes: ['sliding', 'rolling', 'sliding', 'flight'], right: 'More grip, lower' },
  // With h = 1/2 the pull is needed above θ′ = √2; 1.3 is below.
  spin: { modes: ['rolling'], right: 'About 1.4' },
  weight: { modes: ['rolling'], right: 'Only the pale one' },
  // Figure 7: it rolls, and glides until the particle reaches the plane.
  massless: { modes: ['rolling', 'gliding'], right: 'It stays down' },
  // Without resistance it rolls for ever. A half swing of a small amplitude a loses 2χ/h, so that two
  // lose all of a = π − 2.5 at χ = ah/4 = 0.080.
  stop: { modes: ['rolling'], right: 'About 0.08' },
} as const;

for (const [name, { modes, right }] of Object.entries(TRUTH)) {
  test(`the lesson ${name} asks, and answers after a guess`, async ({ page }) => {
    await open(page, `lesson=${name}`);
    const lesson = texts.lessons[name as keyof typeof texts.lessons];
    await expect(page.locator('#question')).toHaveText(lesson.question);
    await expect(page.locator('#answer')).toBeEmpty();
    expect((await phases(page)).map((it) => it.mode).slice(0, modes.length)).toEqual(modes);
    await page.getByRole('button', { name: right }).click();
    // Not waiting for the film: to its end.
    if (lesson.until !== 'start') await page.locator('#last').click();
    await expect(page.locator('#answer')).toHaveText(`${texts.right} ${lesson.answer}`);
    // The address has the lesson and the motion, and shows both again.
    await expect(page).toHaveURL(new RegExp(`#lesson=${name}&`));
    await page.reload();
    await expect(page.locator('#question')).toHaveText(lesson.question);
    await page.getByRole('combobox', { name: 'Lesson' }).selectOption('');
    await expect(page).not.toHaveURL(/lesson=/);
  });
}

test('in the lesson of the stop the hoop swings less and less, and rests in a band', async ({
  page,
}) => {
  await open(page, 'lesson=stop');
  const resistance = page.getByRole('slider', { name: 'Rolling resistance' });
  await expect(resistance).toHaveAttribute('aria-valuetext', 'none, as in the paper');
  for (const { chi, passes } of [
    { chi: 0.05, passes: true },
    { chi: 0.07, passes: true },
    { chi: 0.08, passes: false },
    { chi: 0.1, passes: false },
  ]) {
    await resistance.fill(String(chi));
    await expect(resistance).toHaveAttribute('aria-valuetext', String(chi));
    const places = (await phases(page)).map(({ theta }) => theta);
    // Turning points: on the far side, and back again.
    expect(places[1]!).toBeGreaterThan(Math.PI);
    expect(places[2]! < Math.PI).toBe(passes);
    // With h = 1/2.
    expect(Math.abs(0.5 * Math.sin(places.at(-1)!))).toBeLessThan(chi);
    for (const theta of places.slice(1, -1))
      expect(0.5 * Math.abs(Math.sin(theta))).toBeGreaterThan(chi);
  }
  await page.locator('#last').click();
  await expect(page.locator('#mode')).toHaveText('rest');
});

test('every lesson is tested', () => {
  expect(Object.keys(texts.lessons)).toEqual(Object.keys(TRUTH));
});

test('a wrong guess is told so', async ({ page }) => {
  await open(page, 'lesson=hop');
  await page.getByRole('button', { name: 'It stays down' }).click();
  await page.locator('#last').click();
  await expect(page.locator('#answer')).toHaveText(new RegExp(`^${texts.wrong} It hops`));
});

test('a lesson that there is not is reported', async ({ page }) => {
  await open(page, 'lesson=no-such-lesson');
  await expect(page.locator('#banner')).toContainText('lesson=no-such-lesson');
});

test('a pinned motion is compared in numbers, at the hoop and in the plots', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  const hash = (): Promise<string> =>
    page.locator('#hoop').evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  const plot = (): Promise<string> =>
    page
      .locator('.chart canvas')
      .first()
      .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await page.locator('#pin').click();
  await expect(page.locator('#pin')).toHaveAttribute('aria-pressed', 'true');
  await field(page, 'mu_s').fill('1');
  await field(page, 'mu_k').fill('0.8');
  await page.locator('#next').click();
  // The numbers of the two motions, as `littlewood simulate` prints them.
  await expect(page.locator('#compared')).toHaveText(
    'Pinned: hops 0.631 R high. Now: hops 0.486 R high. μₛ 0.5 → 1, μₖ 0.4 → 0.8.',
  );
  // The link has both; another page that opens it compares the same.
  await expect.poll(() => page.url()).toContain('#pin=case%3Dfigure-3&mass_ratio=');
  const other = await page.context().newPage();
  await other.goto(page.url());
  await expect(other.locator('#compared')).toContainText('μₛ 0.5 → 1, μₖ 0.4 → 0.8.');
  await other.goto(page.url().replace(/pin=[^&]*/, 'pin=mu_s%3D0.1%26mu_k%3D0.2'));
  await other.reload();
  await expect(other.locator('#banner')).toContainText('pin: mu_k');
  await other.close();
  await page.waitForTimeout(200);
  const [both, curves] = [await hash(), await plot()];
  await page.locator('#pin').click();
  await expect(page.locator('#compared')).toBeHidden();
  await expect.poll(hash).not.toBe(both);
  await expect.poll(plot).not.toBe(curves);
});

test('a lesson of one’s own is a link: its question, its motion, and what it hides', async ({
  page,
}) => {
  await open(page, 'case=slip-then-jump');
  await page.locator('#open-share').click();
  await page.getByText('A lesson of your own').click();
  const link = page.locator('#own-text');
  await page.locator('#own-question').fill('');
  await expect(link).toHaveValue('');
  await expect(page.locator('#own-message')).toContainText('two guesses');
  await page.locator('#own-question').fill('Was passiert zuerst & wann?');
  await page.locator('#own-guesses').fill('es rutscht\nes rollt = ewig\nes springt');
  await page.locator('#own-until').selectOption('at the first slip');
  await page.locator('#own-answer').fill('Es rutscht: 100 % sicher.');
  await page.getByLabel('the sliders').check();
  const address = await link.inputValue();
  expect(address).toContain('&case=slip-then-jump');
  // As somebody who gets it, on a telephone.
  const context = await page
    .context()
    .browser()!
    .newContext({ viewport: { width: 390, height: 800 } });
  const other = await context.newPage();
  watch(other);
  await other.goto(address);
  await ready(other);
  await expect(other.locator('#banner')).toBeHidden();
  await expect(other.locator('#question')).toHaveText('Was passiert zuerst & wann?');
  await expect(other.locator('.words')).toBeHidden();
  await expect(other.locator('.story')).toBeVisible();
  await expect(other.locator('html')).toHaveAttribute('data-secret');
  await other.getByRole('button', { name: 'es rollt = ewig' }).click();
  await other.locator('#last').click();
  await expect(other.locator('#answer')).toHaveText(`${texts.wrong} Es rutscht: 100 % sicher.`);
  // The address keeps it; the list has it, and leaves it.
  await expect(other).toHaveURL(/#ask=question/);
  await other.reload();
  await expect(other.getByRole('combobox', { name: 'Lesson' })).toHaveValue('own');
  await other.getByRole('combobox', { name: 'Lesson' }).selectOption('');
  await expect(other).not.toHaveURL(/ask=/);
  await expect(other.locator('.words')).toBeVisible();
  await other.goto('./#ask=question%3DWhat');
  await other.reload();
  await expect(other.locator('#banner')).toContainText('ask=');
  await context.close();
});

test('the lecture has large letters, metres and degrees, and a code of the link', async ({
  page,
}) => {
  await open(page, 'case=figure-3&at=1.4');
  const button = page.locator('#lecture');
  await button.click();
  await expect(page.locator('#readout')).toHaveText(/^t = 0\.3 s\s+θ = 286°\s+x = −1\.54 m/);
  await expect(page.locator('.plot')).toHaveCount(5);
  await expect(page.locator('.plot:visible')).toHaveCount(1);
  await expect(page.locator('#qr path')).toBeVisible();
  // The squares of the code, a cell each: what a telephone reads is the link, which is short.
  const code = await page.locator('#qr svg').evaluate((svg) => {
    const size = Number(svg.getAttribute('viewBox')!.split(' ')[2]);
    const dark = [...svg.firstElementChild!.getAttribute('d')!.matchAll(/M(\d+) (\d+)/g)];
    return { size, dark: dark.map(([, x, y]) => [Number(x), Number(y)]) };
  });
  const { encode } = await import('uqr');
  const address = page.url().split('#')[0];
  const wanted = encode(`${address}#case=figure-3&at=1.4`, { border: 2 });
  expect(code.size).toBe(wanted.size);
  const squares = wanted.data.flatMap((row, y) => row.flatMap((is, x) => (is ? [[x, y]] : [])));
  expect(code.dark).toEqual(squares);
  expect(
    await page.evaluate(() => document.documentElement.scrollHeight - window.innerHeight),
  ).toBeLessThanOrEqual(1);
  await button.click();
  await expect(page.locator('#readout')).toBeHidden();
  await expect(page.locator('#case')).toHaveValue('figure-3');
});
