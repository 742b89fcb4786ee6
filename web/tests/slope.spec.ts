// The plane with a slope: drawn tilted, and tilted by its handle.

import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { field, open, phases, ready } from './lab';

const handle = (page: Page) => page.getByRole('slider', { name: 'Slope of the plane' });

test('the arrow keys tilt the plane, and stop where it is level', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await handle(page).focus();
  for (let i = 0; i < 2; i++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(field(page, 'slope')).toHaveValue('0.095');
  await expect(handle(page)).toHaveAttribute('aria-valuenow', '0.095');
  // 0.095 · 180/π.
  await expect(handle(page)).toHaveAttribute('aria-valuetext', 'α = 0.095 rad, 5.44°');
  await expect(page.locator('#curves')).toContainText('h cos θ θ′² = cos α');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(field(page, 'slope')).toHaveValue('0');
  await expect(page.locator('#curves')).toContainText('h cos θ θ′² = 1');
  await page.keyboard.press('PageDown');
  await expect(field(page, 'slope')).toHaveValue('-0.2');
  await page.keyboard.press('Home');
  await expect(handle(page)).toHaveAttribute(
    'aria-valuenow',
    String(await handle(page).getAttribute('aria-valuemin')),
  );
});

test('the handle is dragged about the point of contact, and the motion and the map follow', async ({
  page,
}) => {
  await open(page, 'case=figure-3');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const level = await phases(page);
  const view = (await page.locator('#hoop').boundingBox())!;
  const centre = async (): Promise<[number, number]> => {
    const box = (await handle(page).boundingBox())!;
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  // The camera follows the hoop: it stands in the middle.
  const [x, y] = await centre();
  const pivot = [view.x + view.width / 2, y] as const;
  const to = async (angle: number): Promise<void> => {
    await page.mouse.move(pivot[0] + 120 * Math.cos(angle), pivot[1] - 120 * Math.sin(angle), {
      steps: 4,
    });
  };
  await page.mouse.move(x, y);
  await page.mouse.down();
  await to(-0.3);
  expect(Math.abs(Number(await field(page, 'slope').inputValue()) + 0.3)).toBeLessThan(0.005);
  await expect(page.locator('html[data-map=done]')).not.toBeAttached();
  await to(0.4);
  expect(Math.abs(Number(await field(page, 'slope').inputValue()) - 0.4)).toBeLessThan(0.005);
  expect((await phases(page))[0]!.duration).not.toBe(level[0]!.duration);
  await to(0.02);
  await expect(field(page, 'slope')).toHaveValue('0');
  await to(0.25);
  await page.mouse.up();
  await expect(page).toHaveURL(/slope=0\.2[45]/);
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const slope = await field(page, 'slope').inputValue();
  await page.reload();
  await ready(page);
  await expect(field(page, 'slope')).toHaveValue(slope);
});

test('in SI units the handle sets the same slope', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await page.locator('#si').check();
  await handle(page).focus();
  await page.keyboard.press('ArrowUp');
  await expect(field(page, 'slope')).toHaveValue('0.05');
  await expect(field(page, 'radius_m')).toHaveValue('0.45');
});

for (const slope of [0, 0.2617993877991494, -0.9, 1.4]) {
  test(`the plane is drawn with a slope of ${slope}, the hoop on it and the handle at its end`, async ({
    page,
  }) => {
    await open(page, `case=ramp-jump&slope=${slope}&follow=1&map=0`);
    const box = (await handle(page).boundingBox())!;
    const view = (await page.locator('#hoop').boundingBox())!;
    const place = [box.x + box.width / 2, box.y + box.height / 2] as const;
    expect(
      place[0] > view.x &&
        place[0] < view.x + view.width &&
        place[1] > view.y &&
        place[1] < view.y + view.height,
    ).toBe(true);
    await page.locator('#open-share').click();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('#svg-hoop').click(),
    ]);
    const svg = readFileSync(await download.path(), 'utf8');
    const paths = [...svg.matchAll(/ d="M([-\d.]+)[ ,]([-\d.]+)L([-\d.]+)[ ,]([-\d.]+)"/g)].map(
      (it) => it.slice(1, 5).map(Number),
    );
    const [x0, y0, x1, y1] = paths[0] as [number, number, number, number];
    expect(Math.abs(Math.atan2(y0 - y1, x1 - x0) - slope)).toBeLessThan(0.002);
    // The rim is the largest circle, and its outer edge touches the plane.
    const circles = [...svg.matchAll(/ d="M([-\d.]+) ([-\d.]+)A([-\d.]+) /g)].map((it) =>
      it.slice(1, 4).map(Number),
    );
    const [right, cy, r] = circles.sort((a, b) => b[2]! - a[2]!)[0] as [number, number, number];
    const cx = right - r;
    const distance = ((x1 - x0) * (cy - y0) - (y1 - y0) * (cx - x0)) / Math.hypot(x1 - x0, y1 - y0);
    expect(Math.abs(-distance - r - 2.5)).toBeLessThan(0.2);
  });
}

test('the plane itself is dragged, too, on either side of the hoop', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  const box = (await handle(page).boundingBox())!;
  const view = (await page.locator('#hoop').boundingBox())!;
  const [x, y] = [view.x + view.width / 2, box.y + box.height / 2];
  for (const side of [1, -1]) {
    await page.mouse.move(x + side * 0.42 * view.width - 20, y);
    await page.mouse.down();
    await page.mouse.move(x + side * 120 * Math.cos(0.2), y - side * 120 * Math.sin(0.2), {
      steps: 4,
    });
    await page.mouse.up();
    expect(Math.abs(Number(await field(page, 'slope').inputValue()) - 0.2)).toBeLessThan(0.01);
    await field(page, 'slope').fill('0');
  }
});
