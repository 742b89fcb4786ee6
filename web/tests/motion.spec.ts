// The motion that the page shows.

import { expect, test } from '@playwright/test';
import {
  endOf,
  FIGURE_3,
  FIGURE_3_LANDING,
  field,
  LAST_DIGIT,
  open,
  phases,
  pixelOf,
  type,
} from './lab';

test('a start dragged to that of figure 3 slides, rolls, slides and jumps', async ({ page }) => {
  await open(page, 'case=rolls-forever');
  const from = await page.locator('#start-handle').boundingBox();
  const to = await pixelOf(page, Math.PI / 2, 2);
  await page.mouse.move(from!.x + from!.width / 2, from!.y + from!.height / 2);
  await page.mouse.down();
  for (let step = 1; step <= 10; step++) {
    await page.mouse.move(
      from!.x + ((to.x - from!.x) * step) / 10,
      from!.y + ((to.y - from!.y) * step) / 10,
    );
  }
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
  // A pixel is coarser than the start of the paper: the fields take the last digits.
  expect(Math.abs(Number(await field(page, 'theta').inputValue()) - Math.PI / 2)).toBeLessThan(
    0.02,
  );
  expect(Math.abs(Number(await field(page, 'theta_rate').inputValue()) - 2)).toBeLessThan(0.03);
  expect((await phases(page)).map((it) => it.mode)).toEqual([
    'sliding',
    'rolling',
    'sliding',
    'flight',
  ]);
  await type(page, 'theta', '1.5707963267948966');
  await type(page, 'theta_rate', '2');

  const [, ...found] = await phases(page);
  expect((await phases(page)).map((it) => it.end)).toEqual([
    'stick',
    'slip',
    'lift-off',
    'landing',
  ]);
  FIGURE_3.forEach((expected, i) => {
    expect(Math.abs(found[i]!.time - expected.time), `time of ${expected.cause}`).toBeLessThan(
      1e-9,
    );
    for (const key of ['theta', 'rate', 'slip'] as const) {
      expect(Math.abs(found[i]![key] - expected[key]), `${key} of ${expected.cause}`).toBeLessThan(
        LAST_DIGIT,
      );
    }
  });
  await expect(page.locator('#case')).toHaveValue('figure-3');
  await expect(page.locator('#sentence')).toHaveText(
    'Slips: rolling would have needed a friction coefficient of 2; there is 0.5.',
  );
  expect(Math.abs((await endOf(page)) - FIGURE_3_LANDING.time)).toBeLessThan(1e-9);
});

test('figure 7 has the times of its closed form', async ({ page }) => {
  await open(page, 'case=figure-7');
  const found = await phases(page);
  expect([found[0]!.end, found.at(-1)!.end]).toEqual(['slip', 'particle at the plane']);
  const slip = found[1]!;
  expect(Math.abs(slip.time - Math.log(5))).toBeLessThan(1e-9);
  expect(slip.rate).toBe(0.75);
  expect(Math.abs((await endOf(page)) - slip.time - (Math.sqrt(89) - 3) / 5)).toBeLessThan(1e-9);
});

test('every named case is in the menu and shows its motion', { tag: '@thorough' }, async ({
  page,
}) => {
  await open(page, 'level=full');
  const names = await page
    .locator('#case option:not([value=""])')
    .evaluateAll((all) => all.map((it) => (it as HTMLOptionElement).value));
  expect(names).toHaveLength(28);
  // What the titles of the cases say.
  const then: Record<string, string[] | null> = {
    'figure-3': ['sliding', 'rolling', 'sliding', 'flight'],
    'figure-2-libration': ['rolling'],
    'footnote-3': ['flight'],
    'slip-then-jump': ['rolling', 'sliding', 'flight'],
    'slide-then-jump': ['sliding', 'flight'],
    'rolls-forever': ['rolling'],
    'sliding-band': ['sliding', 'flight'],
    'type-1': ['rolling', 'gliding'],
    'type-2': ['rolling', 'gliding'],
    painleve: [],
    'lands-and-rolls': ['sliding', 'flight', 'rolling'],
    jam: ['rolling', 'sliding', 'rolling', 'sliding', 'flight', 'rolling'],
    'uphill-disc': ['rolling'],
    'ramp-jump': ['rolling', 'sliding', 'rolling', 'sliding', 'flight'],
    'ramp-libration': ['rolling'],
    'libration-rests': ['rolling', 'rolling', 'rolling', 'rest'],
    'rests-on-far-side': ['rolling', 'rolling', 'rest'],
    'disc-rests-on-ramp': ['rolling', 'rest'],
    skid: ['skidding', 'rolling', 'rolling', 'rest'],
    'painleve-resisted': [],
  };
  for (const name of names) {
    await page.locator('#case').selectOption(name);
    await expect(page.locator('#sentence')).not.toBeEmpty();
    await expect(page.locator('#outcome')).not.toBeEmpty();
    const found = (await phases(page)).map((it) => it.mode);
    if (then[name]) expect(found, name).toEqual(then[name]);
    if (name === 'figure-7')
      expect(found.filter((it, i) => it !== found[i - 1])).toEqual(['rolling', 'gliding']);
    if (name === 'type-1') expect((await phases(page))[0]!.end).toBe('N = 0');
    if (name === 'type-3') expect((await phases(page))[0]!.end).toBe('slip');
    if (name === 'glide-to-roll')
      expect(found.slice(0, 3)).toEqual(['gliding', 'rolling', 'gliding']);
    if (name === 'two-hops') expect(found.filter((it) => it === 'flight')).toHaveLength(2);
    if (name === 'stick-slip-no-jump') {
      expect(found).not.toContain('flight');
      expect(found.length).toBeGreaterThan(3);
    }
    await expect(page).toHaveURL(new RegExp(`#case=${name}(&|$)`));
    // The time line runs to its end, whatever the motion.
    await page.locator('#last').click();
    await page.locator('#first').click();
  }
});

test('play moves the cursor, the events stop it where they are, and the sentence follows', async ({
  page,
}) => {
  await open(page, 'case=figure-3&speed=1');
  await page.evaluate(() => {
    const mode = document.querySelector('#mode')!;
    const seen = [mode.textContent];
    new MutationObserver(() => seen.push(mode.textContent)).observe(mode, { childList: true });
    Object.assign(window, { seen });
  });
  await page.locator('#play').click();
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'paused', { timeout: 10_000 });
  await expect(page.locator('#sentence')).toContainText('Lands');
  const seen = await page.evaluate(() => (window as unknown as { seen: string[] }).seen);
  expect(seen).toEqual(['sliding', 'rolling', 'sliding', 'flight', 'flight, ends']);
  await page.locator('#first').click();
  for (const [mode, text] of [
    ['rolling', 'Sticks'],
    ['sliding', 'Slips'],
    ['flight', 'Jumps'],
  ] as const) {
    await page.locator('#next').click();
    await expect(page.locator('#mode')).toHaveText(mode);
    await expect(page.locator('#sentence')).toContainText(text);
  }
  // All views have the time of the lift-off: the normal force is zero there, and |F|/N is not there
  // any more.
  await expect(page.locator('output[data-plot=normal]')).toHaveText(/^−?0\.000$/);
  await page.locator('#previous').click();
  await expect(page.locator('#mode')).toHaveText('sliding');
  await page.locator('#phases tr').nth(1).locator('button').click();
  await expect(page.locator('#mode')).toHaveText('rolling');
  await expect(page).toHaveURL(/at=0\.5641075531/);
});

test('a plot is a time line too', async ({ page }) => {
  await open(page, 'case=figure-3');
  const over = page.locator('.u-over').first();
  const box = (await over.boundingBox())!;
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await expect(page.locator('#now')).toHaveText(/τ = 1\.9\d\d/);
});

test('loop starts again', async ({ page }) => {
  await open(page, 'case=footnote-3&speed=4&loop=1');
  await page.locator('#play').click();
  await expect(page.locator('#now')).not.toHaveText('τ = 0.000');
  await page.waitForTimeout(1200);
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
});

test('the massless switch takes mass and inertia away, and gives them back', async ({ page }) => {
  await open(page, 'case=figure-3');
  await type(page, 'mass_ratio', '2');
  await page.locator('#massless').check();
  await expect(field(page, 'mass_ratio')).toHaveValue('0');
  await expect(field(page, 'inertia')).toHaveValue('0');
  expect((await phases(page)).map((it) => it.mode)).toContain('gliding');
  await page.locator('#massless').uncheck();
  await expect(field(page, 'mass_ratio')).toHaveValue('2');
  await expect(field(page, 'inertia')).toHaveValue('1');
});

test('SI units show the same motion in seconds, and come back to the same numbers', async ({
  page,
}) => {
  await open(page, 'case=slip-then-jump');
  const plain = await phases(page);
  await page.locator('#si').check();
  await expect(field(page, 'radius_m')).toHaveValue('0.45');
  const si = await phases(page);
  const unit = Math.sqrt(0.45 / 9.80665);
  expect(si.map((it) => it.end)).toEqual(plain.map((it) => it.end));
  si.forEach((it, i) => {
    expect(Math.abs(it.time - plain[i]!.time)).toBeLessThan(1e-9);
    expect(Math.abs(it.from - plain[i]!.time * unit)).toBeLessThan(LAST_DIGIT);
    expect(Math.abs(it.rate - plain[i]!.rate / unit)).toBeLessThan(LAST_DIGIT * (1 + 1 / unit));
  });
  await page.locator('#si').uncheck();
  for (const [i, it] of (await phases(page)).entries())
    expect(Math.abs(it.time - plain[i]!.time)).toBeLessThan(1e-9);
});

test('with rolling resistance a hoop rolls to and fro, and rests', async ({ page }) => {
  await open(page, 'case=figure-2-libration&rolling_resistance=0.05&map=0');
  const found = await phases(page);
  expect(found.map(({ mode, end }) => [mode, end])).toEqual([
    ['rolling', 'turning point'],
    ['rolling', 'turning point'],
    ['rolling', 'turning point'],
    ['rest', 'never'],
  ]);
  // It rests where the weight of the particle is less than the couple of the resistance, χ(1 + m).
  expect(Math.abs(Math.sin(found.at(-1)!.theta))).toBeLessThan(0.05 * 2);
  await expect(page.locator('#energy-legend [data-energy=lost_in_impacts]')).toBeHidden();
  await expect(page.locator('#moves-sentence')).not.toBeEmpty();
  // Where it rests is a curve, too.
  for (const name of ['band_of_rest', 'separatrix', 'slip_limit', 'lift_off'])
    await expect(page.locator(`#curves [data-curve=${name}]`)).toBeVisible();

  await page.locator('#next').click();
  await expect(page.locator('#sentence')).toContainText('Turns back');
  await page.locator('#last').click();
  await expect(page.locator('#mode')).toHaveText('rest');
  // All that the hoop has lost it has lost by rolling: what the phases say together.
  const lost = async (part: string): Promise<number> =>
    Number(await page.locator(`output[data-part=${part}]`).innerText());
  expect(Math.abs((await lost('lost_to_rolling_resistance')) - 0.1987)).toBeLessThan(1e-4);
  expect(await lost('lost_to_friction')).toBe(0);

  await type(page, 'rolling_resistance', '0');
  await expect(page.locator('#curves [data-curve=separatrix]')).toBeVisible();
  await expect(page.locator('#curves [data-curve=band_of_rest]')).toBeHidden();
  await expect(page.locator('#energy')).toBeHidden();
});

test('a hoop that skids does not turn, and each event has its sentence', async ({ page }) => {
  // Of docs/theory/rolling-resistance.md, computed independently with 34 digits.
  await open(
    page,
    'mass_ratio=1&offset=0.6&inertia=0.5&mu_s=0.4&mu_k=0.3&rolling_resistance=0.1&theta=1.21625&theta_rate=0&slip=0.5&map=0',
  );
  const found = await phases(page);
  expect(found.map(({ mode, end }) => [mode, end])).toEqual([
    ['skidding', 'stick'],
    ['rolling', 'turning point'],
    ['rolling', 'turning point'],
    ['rest', 'never'],
  ]);
  for (const [i, time] of [0, 1.666666667, 9.273748402, 14.997017142].entries())
    expect(Math.abs(found[i]!.time - time)).toBeLessThan(1e-9);
  const sentence = page.locator('#sentence');
  await expect(page.locator('#mode')).toHaveText('skidding');
  await expect(sentence).toHaveText(/^Skids to the right: it slips, and rolling resistance holds/);
  for (const text of [
    /^Sticks and rolls: /,
    /^Turns back: /,
    /^Comes to rest: .* Rests for ever/,
  ]) {
    await page.locator('#next').click();
    await expect(sentence).toHaveText(text);
  }
  // A skid loses its energy by sliding alone: η′²/2 times the mass of hoop and particle.
  const lost = (part: string) => page.locator(`output[data-part=${part}]`);
  await expect(lost('lost_to_friction')).toHaveText('0.25');
  // It is a case by name; another resistance is in the link.
  await expect(page).toHaveURL(/#case=skid&/);
  await type(page, 'rolling_resistance', '0.12');
  await expect(page).toHaveURL(/rolling_resistance=0\.12&/);
});
