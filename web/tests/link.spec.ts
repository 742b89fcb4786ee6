// The state in the address, and the messages for a wrong one.

import { expect, test } from '@playwright/test';
import { field, open, phases, ready, type } from './lab';

test('a link shows the same motion', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, 'case=figure-3');
  await type(page, 'mu_k', '0.37');
  await type(page, 'theta', '1.234567890123456');
  await type(page, 'slip', '-0.25');
  await page.locator('#zoom-out').click();
  await page.locator('#loop').check();
  await page.locator('#speed').selectOption('0.25');
  await page.locator('#follow').uncheck();
  await page.locator('#next').click();
  const shown = { phases: await phases(page), time: await page.locator('#now').textContent() };
  await page.locator('#copy-link').click();
  await expect(page.locator('#toast')).toHaveText('Copied.');
  const link = await page.evaluate(() => navigator.clipboard.readText());

  const other = await context.newPage();
  await other.goto(link);
  await ready(other);
  expect(await phases(other)).toEqual(shown.phases);
  await expect(other.locator('#now')).toHaveText(shown.time!);
  await expect(other.locator('#loop')).toBeChecked();
  await expect(other.locator('#follow')).not.toBeChecked();
  await expect(other.locator('#speed')).toHaveValue('0.25');
  // A field has room for seven digits; who wants to change it sees them all.
  await expect(field(other, 'theta')).toHaveValue('1.234568');
  await field(other, 'theta').focus();
  await expect(field(other, 'theta')).toHaveValue('1.234567890123456');
  await field(other, 'mu_k').focus();
  expect(await phases(other)).toEqual(shown.phases);
  expect(new URL(other.url()).hash).toBe(new URL(link).hash);
});

test('a link in SI units shows the same motion', async ({ page, context }) => {
  await open(
    page,
    'disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081&mu_s=0.5&mu_k=0.4&theta=1.2&theta_rate_rad_per_s=6',
  );
  await expect(page.locator('#si')).toBeChecked();
  await expect(field(page, 'gravity_m_per_s2')).toHaveValue('9.80665');
  const shown = await phases(page);
  await page.locator('#open-share').click();
  const link = await page.locator('#link-text').inputValue();
  const other = await context.newPage();
  await other.goto(link);
  await ready(other);
  expect(await phases(other)).toEqual(shown);
});

test('the address changes with the page, and back brings nothing strange', async ({ page }) => {
  await open(page, 'case=figure-3');
  await page.evaluate(() => (location.hash = 'case=rolls-forever'));
  await expect(page.locator('#case')).toHaveValue('rolls-forever');
  // From within the page, in order behind the new address; from outside the browser may not know
  // yet that there is one.
  await page.evaluate(() => history.back());
  await expect(page).toHaveURL(/#case=figure-3$/);
  await expect(page.locator('#case')).toHaveValue('figure-3');
});

test('going back undoes a change, one at a time, and forward does it again', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await page.locator('#case').selectOption('rolls-forever');
  await expect(page).toHaveURL(/case=rolls-forever/);
  await page.locator('#si').check();
  await expect(page).toHaveURL(/radius_m=/);
  await field(page, 'mu_s').focus();
  for (const text of ['0.6', '0.65', '0.7']) {
    await type(page, 'mu_s', text);
    await expect(page).toHaveURL(new RegExp(`mu_s=${text}&`));
  }
  await page.evaluate(() => history.back());
  await expect(page.locator('#si')).toBeChecked();
  await expect(field(page, 'mu_s')).not.toHaveValue('0.7');
  await expect(page).not.toHaveURL(/mu_s=0\.6/);
  await page.evaluate(() => history.back());
  await expect(page.locator('#si')).not.toBeChecked();
  await expect(page.locator('#case')).toHaveValue('rolls-forever');
  await page.evaluate(() => history.back());
  await expect(page.locator('#case')).toHaveValue('figure-3');
  await page.evaluate(() => history.forward());
  await expect(page.locator('#case')).toHaveValue('rolls-forever');
});

test('a drag is one entry of the history', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  const length = await page.evaluate(() => history.length);
  const box = (await page.locator('#start-handle').boundingBox())!;
  await page.mouse.move(box.x + 15, box.y + 15);
  await page.mouse.down();
  for (const by of [10, 20, 30]) {
    await page.mouse.move(box.x + 15 + by, box.y + 15);
    // Longer than the address waits.
    await page.waitForTimeout(400);
  }
  await page.mouse.up();
  await expect.poll(() => page.evaluate(() => history.length)).toBe(length + 1);
  await page.evaluate(() => history.back());
  await expect(page.locator('#case')).toHaveValue('figure-3');
});

test('a field takes a comma, and one of an angle degrees and parts of π', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await type(page, 'mu_k', '0,3');
  await expect(page).toHaveURL(/mu_k=0\.3&/);
  for (const [text, value] of [
    ['pi/2', Math.PI / 2],
    ['90°', Math.PI / 2],
    ['-3π/4', (-3 * Math.PI) / 4],
    ['−45 °', -Math.PI / 4],
    ['0,5 pi', Math.PI / 2],
  ] as const) {
    await type(page, 'theta', text);
    await expect(page.locator('#message-theta')).toBeEmpty();
    await expect
      .poll(() => Number(/theta=([^&]*)/.exec(page.url())?.[1] ?? Math.PI / 2))
      .toBeCloseTo(value, 14);
  }
  await type(page, 'theta', 'π/0');
  await expect(page.locator('#message-theta')).toHaveText(/not a number/);
});

const BAD: [string, string, RegExp][] = [
  ['mu_k=7', 'mu_k', /μₖ = 7 must not exceed μₛ = 0.5/],
  ['theta=nonsense', 'theta', /'nonsense' is not a number/],
  ['offset=1.5', 'offset', /ℓ\/R = 1.5 must not exceed 1/],
  ['theta_rate=1e9', 'theta_rate', /must lie between -1e6 and 1e6/],
  ['mass_ratio=-1', 'mass_ratio', /must not be negative/],
  ['theta=NaN', 'theta', /'NaN' is not a number/],
  ['mu_s=%', 'mu_s', /'%' is not a number/],
  ['mass_ratio=0&offset=0&inertia=0', 'offset', /no equation of motion/],
  ['restitution=1.5', 'restitution', /e = 1.5 must not exceed 1/],
  ['restitution=NaN', 'restitution', /'NaN' is not a number/],
  ['restitution_law=newton', 'restitution', /restitution_law = newton without restitution/],
  ['mass_ratio=0&inertia=0&restitution=0.5', 'restitution', /massless/],
  ['mass_ratio=0&inertia=0&gap_rate=0.5', 'gap_rate', /massless/],
  ['gap_rate=-1', 'gap_rate', /must not be negative/],
];
for (const [state, name, message] of BAD) {
  test(`a bad link, ${state}, is reported beside the field`, async ({ page }) => {
    await open(page, state);
    await expect(page.locator(`#message-${name}`)).toHaveText(message);
    await expect(field(page, name)).toHaveAttribute('aria-invalid', 'true');
    await expect(page.locator('#banner')).toContainText(message);
    // The last good state is there: figure 3.
    expect((await phases(page)).map((it) => it.end)).toEqual([
      'stick',
      'slip',
      'lift-off',
      'landing',
    ]);
  });
}

test('a link with keys or values that are not known says so', async ({ page }) => {
  await open(page, 'case=no-such-case&colour=red&at=soon');
  // Once.
  await expect(page.getByText("there is no case named 'no-such-case'")).toHaveCount(1);
  await expect(page.locator('#case')).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('#banner')).toContainText('colour=red');
  await expect(page.locator('#banner')).toContainText('at=soon');
  await expect(page.locator('#phases tr')).toHaveCount(4);
});

test('a bad number in a field leaves the last good motion and its address', async ({ page }) => {
  await open(page, 'case=figure-3');
  const before = await phases(page);
  for (const [text, message] of [
    ['0.6', /must not exceed μₛ/],
    ['', /missing/],
    ['0,4,', /not a number/],
    ['pi/2', /not a number/],
  ] as const) {
    await type(page, 'mu_k', text);
    await expect(page.locator('#message-mu_k')).toHaveText(message);
    expect(await phases(page)).toEqual(before);
    expect(page.url()).toContain('#case=figure-3');
  }
  await type(page, 'mu_k', '0.4');
  await expect(page.locator('#message-mu_k')).toBeEmpty();
  await page.locator('#fields summary').click();
  await type(page, 'until', '-1');
  await expect(page.locator('#message-until')).toHaveText(/τ = -1/);
  await type(page, 'until', '1');
  expect((await phases(page)).at(-1)!.end).toBe('time limit');
});
