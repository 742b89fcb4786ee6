// What moves an event, and the landing that is predicted while something is dragged.

import { expect, type Page, test } from '@playwright/test';
import { FIGURE_3_LANDING, field, open, pixelOf, type } from './lab';

/** Opens a motion, and waits for the derivatives. */
async function openWithMoves(page: Page, state: string): Promise<void> {
  await open(page, state);
  await expect(page.locator('#moves-sentence')).not.toBeEmpty();
}

/** The moves that are shown, in their order. */
const shown = (
  page: Page,
): Promise<{ quantity: string; moved: number; width: number; text: string }[]> =>
  page.locator('#moves-rows li').evaluateAll((rows) =>
    rows.map((row) => ({
      quantity: (row as HTMLElement).dataset.quantity!,
      moved: Number((row as HTMLElement).dataset.moved),
      width: row.querySelector<HTMLElement>('.bar > span')!.getBoundingClientRect().width,
      text: row.textContent ?? '',
    })),
  );

test('the bars of a landing are the differences of two motions, the largest first', async ({
  page,
}) => {
  await openWithMoves(page, 'case=figure-3&at=9&map=0');
  await expect(page.locator('#moves-place')).toHaveText('landing, τ = 3.8474');
  const rows = await shown(page);
  expect(rows.map((it) => Math.abs(it.moved))).toEqual(
    rows.map((it) => Math.abs(it.moved)).sort((a, b) => b - a),
  );
  for (const [i, it] of rows.entries()) {
    const part = it.moved / rows[0]!.moved;
    expect(Math.abs(it.width / rows[0]!.width - Math.abs(part)), it.quantity).toBeLessThan(0.02);
    if (i > 0) expect(it.text).toMatch(/moves it by [+−]?[\d.e−]+ √\(R\/g\)/);
  }
  await expect(page.locator('#moves-sentence')).toHaveText(
    /^This event \(landing\) moves most with .*: \+1 % of it moves τ by [+−]0\.\d+ √\(R\/g\)\.$/,
  );
  await expect(page.locator('#moves-reasons')).toHaveText(
    'η′, gap′: on the two sides of this value the motion begins differently.',
  );
  // The lift-off against the motions with a little more and a little less friction; differences of
  // second order are left out by both together.
  await page.locator('#previous').click();
  await expect(page.locator('#moves-place')).toHaveText('lift-off, τ = 1.5187');
  const { moved } = (await shown(page)).find((it) => it.quantity === 'mu_k')!;
  const liftOff = async (friction: number): Promise<number> => {
    await type(page, 'mu_k', String(friction));
    return Number(
      await page.locator('#phases tr').last().locator('[data-time]').getAttribute('data-time'),
    );
  };
  const [less, more] = [await liftOff(0.4 - 8e-5), await liftOff(0.4 + 8e-5)];
  expect(Math.abs(((more - less) / 1.6e-4) * 0.004 - moved)).toBeLessThan(1e-4 * Math.abs(moved));
});

test('what is moved can be chosen with the keys, and has the units that are shown', async ({
  page,
}) => {
  await openWithMoves(page, 'case=figure-3&at=9&map=0');
  await page.getByRole('combobox', { name: 'What is moved' }).focus();
  await page.keyboard.press('End');
  await expect(page.locator('#moves-sentence')).toHaveText(/moves x by [+−][\d.]+ R\.$/);
  await expect(
    page
      .getByRole('list', { name: /By how much 1 %/ })
      .getByRole('listitem')
      .first(),
  ).toHaveText(/moves it by [+−][\d.]+ R$/);
  await page.locator('#si').check();
  await expect(page.locator('#moves-sentence')).toHaveText(/moves x by [+−][\d.]+ m\.$/);
  const names = (await shown(page)).map((it) => it.quantity);
  expect(names).toContain('radius_m');
  expect(names).toContain('gravity_m_per_s2');
});

test('an event without derivatives says why', async ({ page }) => {
  await open(page, 'case=painleve&map=0');
  await expect(page.locator('#moves')).toBeHidden();
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, 'case=figure-3&map=0&level=full');
  await expect(page.locator('#moves')).toBeVisible();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
});

test('while the start is dragged the landing is predicted from before, beside the exact one', async ({
  page,
}, info) => {
  await openWithMoves(page, 'case=figure-3&map=0');
  const ghost = page.locator('#ghost');
  await expect(ghost).toBeHidden();
  const from = await pixelOf(page, Math.PI / 2, 2);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 6, from.y, { steps: 3 });
  await expect(ghost).toHaveText(
    /^Landing to first order: x = −?[\d.]+ R, τ = [\d.]+ √\(R\/g\)\. Exact: x = −?[\d.]+ R, τ = [\d.]+ √\(R\/g\)\.$/,
  );
  const [first, exact] = [...(await ghost.textContent())!.matchAll(/τ = ([\d.]+)/g)].map((it) =>
    Number(it[1]),
  ) as [number, number];
  // The difference of second order is smaller than the move.
  expect(Math.abs(first - exact)).toBeLessThan(
    0.3 * Math.abs(exact - FIGURE_3_LANDING.time) + 1e-3,
  );
  await page.screenshot({ path: info.outputPath('ghost.png') });
  await page.mouse.up();
  await expect(ghost).toBeHidden();
  // With the keys it stays until the start is left.
  await page.locator('#start-handle').focus();
  await page.keyboard.press('Shift+ArrowUp');
  await expect(ghost).toContainText('Exact');
  await field(page, 'mu_k').focus();
  await expect(ghost).toBeHidden();
});

test('a slider of what has no derivative gives the reason', async ({ page }) => {
  await openWithMoves(page, 'case=figure-3&map=0');
  await page.locator('#slider-slip').focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('#ghost')).toContainText(
    'No prediction: on the two sides of this value the motion begins differently.',
  );
});
