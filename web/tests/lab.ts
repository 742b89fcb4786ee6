// What the tests do with the page.

import { type Browser, expect, type Locator, type Page } from '@playwright/test';

/** Opens the page with a state, watched. */
export async function open(page: Page, state = ''): Promise<void> {
  watch(page);
  await page.goto(`./${state === '' ? '' : `#${state}`}`);
  await ready(page);
}

export async function ready(page: Page): Promise<void> {
  await expect(page.locator('html[data-ready=true]')).toBeAttached();
}

const watched = new WeakSet<Page>();

/** Any error on a page, and any request to another host, fails the test. */
export function watch(page: Page): void {
  if (watched.has(page)) return;
  watched.add(page);
  page.on('pageerror', (error) => {
    if (!error.message.startsWith('ResizeObserver loop')) throw error;
  });
  page.on('console', (message) => {
    if (message.type() === 'error') throw new Error(message.text());
  });
  page.on('request', (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (protocol.startsWith('http') && hostname !== '127.0.0.1')
      throw new Error(`a request to ${request.url()}`);
  });
}

/** A phase as the table shows it. The time is that of the button, with every digit and without dimension. */
export interface PhaseRow {
  mode: string;
  time: number;
  /** In the units that are shown, as the duration, angle, rate and slip. */
  from: number;
  duration: number;
  theta: number;
  rate: number;
  slip: number;
  end: string;
}

/** Half a unit of the last of five decimals, and its rounding. */
export const LAST_DIGIT = 5.1e-6;

/** The phases in the table, without the rows of impacts. */
export async function phases(page: Page): Promise<PhaseRow[]> {
  return page.locator('#phases tr:has(td[data-mode])').evaluateAll((rows) =>
    rows.map((row) => {
      const cells = [...row.querySelectorAll('td')].map((cell) => cell.textContent ?? '');
      const number = (text = ''): number =>
        Number(text.replaceAll('−', '-').replace('∞', 'Infinity'));
      return {
        mode: row.querySelector<HTMLElement>('[data-mode]')!.dataset.mode!,
        time: Number(row.querySelector<HTMLElement>('[data-time]')!.dataset.time),
        from: number(cells[2]),
        duration: number(cells[3]),
        theta: number(cells[4]),
        rate: number(cells[5]),
        slip: number(cells[6]),
        end: cells[8] ?? '',
      };
    }),
  );
}

/** The time of the end of the motion, as the address has it. */
export async function endOf(page: Page): Promise<number> {
  await page.locator('#last').click();
  await expect(page).toHaveURL(/at=/);
  return Number(/at=([^&]*)/.exec(page.url())![1]);
}

export const field = (page: Page, name: string): Locator => page.locator(`#field-${name}`);

/** Types into a field as a person does. */
export async function type(page: Page, name: string, text: string): Promise<void> {
  await field(page, name).fill(text);
}

/** The pixel of the plane where a start lies. */
export async function pixelOf(
  page: Page,
  theta: number,
  rate: number,
  most = 4,
): Promise<{ x: number; y: number }> {
  const box = (await page.locator('#plane').boundingBox())!;
  // The margins of the plane.
  const [left, right, top, bottom] = [46, 14, 12, 40];
  return {
    x: box.x + left + ((theta + Math.PI) / (3 * Math.PI)) * (box.width - left - right),
    y: box.y + top + (0.5 - (0.5 * rate) / most) * (box.height - top - bottom),
  };
}

/** The events of Figure 3 with 40 digits computed independently (evidence/reference/motions.json). */
export const FIGURE_3 = [
  {
    cause: 'stick',
    time: 0.56410755310199675,
    theta: 2.91722565678924913,
    rate: 2.93644326144529653,
    slip: 0,
  },
  {
    cause: 'slip',
    time: 0.973223074772405405,
    theta: 4.06633287423929561,
    rate: 2.46087950463497717,
    slip: 0,
  },
  {
    cause: 'lift-off',
    time: 1.518670213819437,
    theta: 5.23673577087816789,
    rate: 1.99870593711413988,
    slip: 0.607696268534750732,
  },
];
export const FIGURE_3_LANDING = { time: 3.8473955566868942, theta: 9.89117293957551564 };

/** Swipes up on a telephone, from what `place` finds, and expects the page to scroll and the motion to stay that of the case. */
export async function swipe(
  [browser, baseURL]: [Browser, string],
  state: string,
  place: (page: Page) => Promise<{ x: number; y: number }>,
): Promise<void> {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    baseURL,
  });
  const page = await context.newPage();
  await open(page, `case=figure-3&${state}`);
  const { x, y } = await place(page);
  const session = await context.newCDPSession(page);
  const before = await page.evaluate(() => window.scrollY);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', to: number): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x, y: to }],
    });
  await touch('touchStart', y);
  for (let step = 1; step <= 8; step++) await touch('touchMove', y - 15 * step);
  await touch('touchEnd', y);
  await expect.poll(() => page.evaluate(() => window.scrollY)).toBeGreaterThan(before + 50);
  await expect(page.locator('#case')).toHaveValue('figure-3');
  await context.close();
}
