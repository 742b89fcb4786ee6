// The hoop in the hand: its weight is dragged and flung.

import { expect, type Page, test } from '@playwright/test';
import { field, open } from './lab';

const weight = (page: Page) => page.getByRole('slider', { name: 'Weight of the hoop' });

/** The middle of the weight. */
async function placeOf(page: Page): Promise<{ x: number; y: number }> {
  const box = (await weight(page).boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

const numberIn = async (page: Page, name: string): Promise<number> =>
  Number(await field(page, name).inputValue());

test('the weight is dragged to another start and let go, and the motion plays', async ({
  page,
}) => {
  await open(page, 'case=figure-2-libration&map=0');
  // At θ = π/2 the weight is at the left of the centre, by a radius; the view follows the hoop.
  await page.locator('#field-theta').fill('pi/2');
  const from = await placeOf(page);
  const view = (await page.locator('#hoop').boundingBox())!;
  const [middle, radius] = [view.x + view.width / 2, view.x + view.width / 2 - from.x];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const before = await numberIn(page, 'theta_rate');
  for (let angle = 1.5; angle > -1.001; angle -= 0.1) {
    await page.mouse.move(middle - radius * Math.sin(angle), from.y - radius * Math.cos(angle));
  }
  // A pixel is a hundredth of a radian.
  expect(Math.abs((await numberIn(page, 'theta')) + 1)).toBeLessThan(0.03);
  // Held still, it is not flung.
  await page.waitForTimeout(250);
  await page.mouse.up();
  expect(await numberIn(page, 'theta_rate')).toBe(before);
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
});

test('a fling sets the rate: that of the hand, for a hula hoop', async ({ page }) => {
  await open(page, 'case=figure-2-libration&map=0&theta=1.5707963267948966&theta_rate=0');
  const from = await placeOf(page);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  // Times of our own: 0.06 radians in 20 ms are 3 a second, clockwise.
  await page.evaluate(() => {
    const handle = document.querySelector('.weight')!;
    const box = document.querySelector('#hoop')!.getBoundingClientRect();
    const at = handle.getBoundingClientRect();
    const centre = { x: box.x + box.width / 2, y: at.y + at.height / 2 };
    const radius = centre.x - at.x - at.width / 2;
    const begin = performance.now();
    for (let k = 1; k <= 10; k++) {
      const angle = Math.PI / 2 - 0.06 * k;
      const event = new PointerEvent(k < 10 ? 'pointermove' : 'pointerup', {
        pointerId: 1,
        clientX: centre.x - radius * Math.sin(angle),
        clientY: centre.y - radius * Math.cos(angle),
      });
      Object.defineProperty(event, 'timeStamp', { value: begin + 20 * k });
      handle.dispatchEvent(event);
    }
  });
  await page.mouse.up();
  // √(R/g) with R = 0.45 m; the events have whole pixels, and the field two decimals.
  const expected = -3 * Math.sqrt(0.45 / 9.80665);
  expect(Math.abs((await numberIn(page, 'theta_rate')) - expected)).toBeLessThan(0.06);
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
});

test('a finger drags the weight', async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    baseURL: baseURL!,
  });
  const page = await context.newPage();
  await open(page, 'case=figure-2-libration&map=0&theta=0&theta_rate=0');
  const { x, y } = await placeOf(page);
  const session = await context.newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', dx = 0): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: x + dx, y: y + dx / 4 }],
    });
  await touch('touchStart');
  for (let step = 1; step <= 8; step++) await touch('touchMove', 5 * step);
  await page.waitForTimeout(250);
  await touch('touchEnd');
  await expect.poll(() => numberIn(page, 'theta')).toBeLessThan(-0.1);
  await context.close();
});

test('the keys turn the weight and its rate, and say where it is', async ({ page }) => {
  await open(page, 'case=figure-2-libration&map=0&theta=0&theta_rate=0');
  await weight(page).focus();
  await expect(weight(page)).toHaveAttribute('aria-valuetext', 'at the top, at rest');
  await page.keyboard.press('ArrowLeft');
  await expect(field(page, 'theta')).toHaveValue('0.05');
  for (let k = 0; k < 4; k++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowDown');
  await expect(field(page, 'theta_rate')).toHaveValue('0.195');
  // 0.05 · 180/π = 2.9.
  await expect(weight(page)).toHaveAttribute(
    'aria-valuetext',
    '3° to the left of the top, turning counterclockwise at 0.195 √(g/R)',
  );
  await expect(weight(page)).toHaveAttribute('aria-valuenow', '3');
});

test('who wants nothing to move by itself lets go, and nothing plays', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, 'case=figure-2-libration&map=0&theta=0&theta_rate=0');
  const { x, y } = await placeOf(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 5, { steps: 3 });
  await page.mouse.up();
  expect(await numberIn(page, 'theta')).toBeLessThan(0);
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'paused');
});
