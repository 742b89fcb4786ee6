// What comes after the landing.

import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { MATERIALS } from '../src/core/materials';
import { ENERGY_PARTS } from '../src/generated/palette';
import { FIGURE_3, FIGURE_3_LANDING, field, LAST_DIGIT, open, phases, ready, type } from './lab';

/** Figure 3 with e = 0.5, energetic law, computed with 40 digits (shared notes): after the first impact, and where it settles. */
const FIRST = {
  rate: 1.803947379026181191,
  slip: 0,
  gap_rate: 0.978517419970790811,
  lost: 3.36244341922728,
};
const SETTLES = {
  time: 6.92468208301851365,
  theta: 15.4568461360609139,
  rate: 2.20041054290320475,
};
/** A, B, C, slip and rate of the gap before the first impact. */
const [A, B, C] = [0.704169493845475073, -0.0829493464295526, 0.533700402266253778];
const BEFORE = { slip: -0.785244687128996169, gap_rate: -1.913012569038374656 };

const near = (a: number, b: number, bound = 1e-9): void =>
  expect(Math.abs(a - b), `${a} and ${b}`).toBeLessThan(bound);

/** The number in a cell of the table of the impact. */
async function cell(page: Page, quantity: string, place = 0): Promise<number> {
  const cells = page.locator(`#impact-numbers tr[data-quantity=${quantity}] td`);
  return Number(await cells.nth(place).getAttribute('data-value'));
}

test('figure 3 bounces, each impact has its mark and its sentence, and it settles where the notes say', async ({
  page,
}) => {
  await open(page, 'case=figure-3-bounces');
  await expect(page.locator('#impact')).toBeVisible();
  const marks = await page.locator('#marks .mark').count();
  expect(marks).toBeGreaterThan(20);
  await expect(page.locator('#impact-place')).toContainText(`1 of ${marks}`);
  await page.locator('#next-impact').click();
  await expect(page.locator('#impact-sentence')).toContainText(
    'slips, then sticks while it springs back',
  );
  await expect(page.locator('#sentence')).toHaveText(
    await page.locator('#impact-sentence').innerText(),
  );
  near(await cell(page, 'slip', 0), BEFORE.slip);
  near(await cell(page, 'gap_rate', 0), BEFORE.gap_rate);
  near(await cell(page, 'theta_rate', 1), FIRST.rate);
  near(await cell(page, 'gap_rate', 1), FIRST.gap_rate);
  expect(await cell(page, 'slip', 1)).toBe(FIRST.slip);
  near(await cell(page, 'energy_lost'), FIRST.lost);
  await page.locator('#next-impact').click();
  await expect(page.locator('#impact-place')).toContainText(`2 of ${marks}`);
  await expect(page.locator('#impact-sentence')).toContainText('Lands: slips throughout');
  await page.locator('#previous-impact').click();
  await expect(page.locator('#previous-impact')).toBeDisabled();

  // The table folds the bounces, and shows all that are wanted.
  await expect(page.locator('#phases tr')).toHaveCount(13);
  await page.locator('#phases tr.fold td[data-mode] button').click();
  const found = await phases(page);
  expect(found.filter((it) => it.end === 'landing')).toHaveLength(marks - 1);
  for (const [i, expected] of FIGURE_3.entries()) near(found[i + 1]!.time, expected.time);
  near(found[4]!.time, FIGURE_3_LANDING.time);
  const [bounces, rolls] = found.slice(-2);
  expect([bounces!.end, rolls!.mode, rolls!.slip]).toEqual(['settles', 'rolling', 0]);
  near(rolls!.time, SETTLES.time);
  for (const key of ['theta', 'rate'] as const) near(rolls![key], SETTLES[key], LAST_DIGIT);
  await page.locator('#phases tr').last().locator('button').click();
  await expect(page.locator('#impact-sentence')).toContainText('Settles');
  // Many impacts together have no diagram.
  await expect(page.locator('#routh')).toBeHidden();
});

test('the end of the way in Routh’s diagram is the impulse', async ({ page }) => {
  await open(page, `case=figure-3-bounces&at=${FIGURE_3_LANDING.time}`);
  await page.locator('#open-share').click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('#save-json').click(),
  ]);
  await page.locator('#close-share').click();
  const { impact } = JSON.parse(readFileSync(await download.path(), 'utf8')).transitions[3];
  const canvas = page.locator('#routh');
  await expect(canvas).toHaveAttribute('data-normal', String(impact.normal_impulse));
  await expect(canvas).toHaveAttribute('data-friction', String(impact.friction_impulse));
  const [p, j] = [await cell(page, 'normal_impulse'), await cell(page, 'friction_impulse')];
  expect([p, j]).toEqual([impact.normal_impulse, impact.friction_impulse]);
  // By the compliances of the notes it makes the velocities after of those before.
  near(BEFORE.slip + A * j + B * p, FIRST.slip, 1e-12);
  near(BEFORE.gap_rate + B * j + C * p, FIRST.gap_rate, 1e-12);
  await expect(canvas).toHaveAttribute('aria-label', /sticks in restitution/);
});

test('restitution is off, on, changed and off again', async ({ page }) => {
  await open(page, 'case=figure-3');
  const before = await phases(page);
  await expect(page.locator('#bounces')).not.toBeChecked();
  await expect(page.locator('#slider-restitution')).toBeDisabled();
  await expect(page.locator('#law')).toBeDisabled();
  await expect(page.locator('#impact')).toBeHidden();
  await expect(page.locator('#energy')).toBeHidden();
  expect(await page.locator('#marks .mark').count()).toBe(0);

  await page.locator('#bounces').check();
  await expect(field(page, 'restitution')).toHaveValue('0.5');
  await expect(page.locator('#case')).toHaveValue('figure-3-bounces');
  await page.locator('#slider-restitution').focus();
  await page.keyboard.press('Home');
  await expect(field(page, 'restitution')).toHaveValue('0');
  // The table of the notes: with e = 0 it slides throughout, and goes on sliding.
  const landed = (await phases(page))[4]!;
  expect(landed.mode).toBe('sliding');
  near(landed.rate, 1.989854986135947259, LAST_DIGIT);
  near(landed.slip, -0.02573379727941587, LAST_DIGIT);
  await page.keyboard.press('ArrowRight');
  await expect(field(page, 'restitution')).toHaveValue('0.01');
  await expect(page).toHaveURL(/restitution=0\.01&restitution_law=energetic/);
  await page.locator('#law').selectOption('newton');
  await expect(page).toHaveURL(/restitution_law=newton/);

  await page.locator('#bounces').uncheck();
  expect(await phases(page)).toEqual(before);
  await expect(page.locator('#case')).toHaveValue('figure-3');
  await expect(page).toHaveURL(/#case=figure-3(&|$)/);
  await page.locator('#bounces').check();
  await expect(field(page, 'restitution')).toHaveValue('0.01');
  // An empty field is off, too.
  await type(page, 'restitution', '');
  await expect(page.locator('#bounces')).not.toBeChecked();
  expect(await phases(page)).toEqual(before);
  await type(page, 'restitution', '1.5');
  await expect(page.locator('#message-restitution')).toHaveText(/must not exceed 1/);
  expect(await phases(page)).toEqual(before);
});

test('a link carries restitution, law, the rate of the gap and what the map shows', async ({
  page,
  context,
}) => {
  await open(
    page,
    'mass_ratio=1&offset=1&inertia=1&mu_s=0.5&mu_k=0.4&theta=1&theta_rate=2&gap_rate=0.5&restitution=0.3&restitution_law=poisson&shows=hops&map=0',
  );
  await expect(page.locator('#sentence')).toHaveText(/^Is thrown/);
  await expect(field(page, 'gap_rate')).toHaveValue('0.5');
  await expect(page.locator('#law')).toHaveValue('poisson');
  await expect(page.locator('#shows')).toHaveValue('hops');
  await expect(page.locator('#map')).not.toBeChecked();
  const shown = await phases(page);
  await page.locator('#open-share').click();
  const link = await page.locator('#link-text').inputValue();
  const other = await context.newPage();
  await other.goto(link);
  await ready(other);
  expect(await phases(other)).toEqual(shown);
  expect(new URL(other.url()).hash).toBe(new URL(link).hash);
  // A link without restitution ends at the landing, wherever it is opened.
  await other.evaluate(
    () =>
      (location.hash =
        'mass_ratio=1&offset=1&inertia=1&mu_s=0.5&mu_k=0.4&theta=1.5707963267948966&theta_rate=2&slip=0&gap_rate=0&x=0&time=0'),
  );
  await expect(other.locator('#case')).toHaveValue('figure-3');
});

test('an unknown law in a link says which there are', async ({ page }) => {
  await open(page, 'case=figure-3-bounces&restitution_law=hooke');
  await expect(page.locator('#banner')).toContainText('one of energetic, poisson, newton');
  await expect(page.locator('#message-restitution_law')).not.toBeEmpty();
});

test('a massless hoop cannot bounce, and the page says why', async ({ page }) => {
  await open(page, 'case=figure-3-bounces');
  await type(page, 'gap_rate', '0.5');
  await page.locator('#massless').check();
  await expect(page.locator('#no-impact')).toHaveText(/massless hoop has no impact/);
  for (const id of ['bounces', 'field-restitution', 'slider-restitution', 'law', 'material']) {
    await expect(page.locator(`#${id}`)).toBeDisabled();
  }
  await expect(field(page, 'restitution')).toHaveValue('');
  await expect(field(page, 'gap_rate')).toHaveValue('0');
  await expect(page.locator('#impact')).toBeHidden();
  await page.locator('#massless').uncheck();
  await expect(field(page, 'restitution')).toHaveValue('0.5');
  await expect(field(page, 'gap_rate')).toHaveValue('0.5');
  await expect(page.locator('#no-impact')).toBeEmpty();
});

test('each material sets its three numbers and says where they are from', {
  tag: '@thorough',
}, async ({ page }) => {
  await open(page, 'case=figure-3');
  for (const { name, mu_s, mu_k, restitution, isIndicative, friction, impact } of MATERIALS) {
    await page.locator('#material').selectOption(name);
    await expect(field(page, 'mu_s')).toHaveValue(String(mu_s));
    await expect(field(page, 'mu_k')).toHaveValue(String(mu_k));
    await expect(field(page, 'restitution')).toHaveValue(String(restitution));
    const source = page.locator('#material-source');
    await expect(source).toContainText(friction.cite);
    await expect(source).toContainText(impact.cite);
    expect((await source.innerText()).startsWith('Indicative only')).toBe(isIndicative);
  }
  await expect(page).toHaveURL(new RegExp(`restitution=${MATERIALS.at(-1)!.restitution}`));
  await page.reload();
  await ready(page);
  await expect(page.locator('#material')).toHaveValue(MATERIALS.at(-1)!.name);
  await type(page, 'mu_k', '0.01');
  await expect(page.locator('#material')).toHaveValue('');
  await expect(page.locator('#material-source')).toBeEmpty();
});

test('the parts of the energy add up to that of the start at every time', async ({ page }) => {
  for (const state of [
    'case=figure-3-bounces',
    'case=jam&map=0',
    'case=figure-3-bounces&restitution=0.9&restitution_law=newton&map=0',
  ]) {
    await open(page, state);
    await page.reload();
    await ready(page);
    const number = async (selector: string): Promise<number> =>
      parseFloat((await page.locator(selector).innerText()).replaceAll('−', '-'));
    const start = await number('#energy-sum');
    for (let i = 0; i < 8; i++) {
      let sum = 0;
      for (const part of ENERGY_PARTS) {
        const row = page.locator(`#energy-legend [data-energy=${part}]`);
        const sign = (await row.innerText()).includes('gained') ? -1 : 1;
        sum += sign * (await number(`output[data-part=${part}]`));
      }
      // Each is rounded to four digits.
      near(sum, start, 3e-3 * start);
      near(await number('#energy-sum'), start, 1e-12);
      await page.locator('#next').click();
    }
  }
});

test('the map shows the number of hops', { tag: '@thorough' }, async ({ page }) => {
  await open(page, 'case=two-hops');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  await expect(page.locator('#legend li').first()).not.toHaveText('no landing');
  await page.locator('#shows').selectOption('hops');
  await expect(page.locator('#legend li').first()).toHaveText('no landing');
  await expect(page.locator('html[data-map=done]')).toBeAttached({ timeout: 60_000 });
  const shown = await page.locator('#legend li').allInnerTexts();
  expect(shown.slice(0, 3)).toEqual(['no landing', '1 landing', '2']);
  await expect(page).toHaveURL(/shows=hops/);
  await page.reload();
  await ready(page);
  await expect(page.locator('#shows')).toHaveValue('hops');
  await page.locator('#bounces').uncheck();
  // Without restitution no motion lands twice.
  await expect(page.locator('#legend li')).toHaveText(['no landing', '1 landing']);
});

test('bounces without end are shown for a while', async ({ page }) => {
  await open(page, 'case=bounces-forever&map=0');
  await page.locator('#last').click();
  await expect(page.locator('#mode')).toHaveText('flight');
  // Each of the two flights has its own duration; a turn takes as long each time.
  const times = await page
    .locator('#marks .mark')
    .evaluateAll((all) => all.map((it) => parseFloat((it as HTMLElement).style.left)));
  expect(times.length).toBeGreaterThan(10);
  for (let i = 4; i < times.length; i++)
    near(times[i]! - times[i - 2]!, times[2]! - times[0]!, 1e-3);
  await expect(page.locator('#case')).toHaveValue('bounces-forever');
});
