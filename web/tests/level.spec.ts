// Two levels: a page that asks, and the full one.

import { expect, type Page, test } from '@playwright/test';
import { open, phases, ready, swipe } from './lab';

const question = (page: Page) => page.getByRole('heading', { name: 'Does it hop? Guess.' });

test('a first visit is asked a question, and the motion answers it', async ({ page }) => {
  await open(page);
  await expect(question(page)).toBeVisible();
  for (const id of ['plane', 'fields', 'phases', 'plots'])
    await expect(page.locator(`#${id}`)).toBeHidden();
  // The colours of the time line would give it away.
  const flight = page.locator('#track [data-mode=flight]');
  await expect(flight).toBeHidden();
  await page.getByRole('button', { name: 'It hops' }).click();
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
  await expect(page.locator('#hop')).toBeVisible({ timeout: 30_000 });
  // The rim gets 0.631 R high (evidence/reference), told as soon as it hops: it is still in the air.
  await expect(page.locator('#answer')).toHaveText(
    /^HOP: 0\.63 R high\. You were right\. Drag the weight/,
    { timeout: 30_000 },
  );
  await expect(page.locator('#hop')).toBeVisible();
  await expect(flight).toBeVisible();
  await page.locator('#first').click();
  await expect(page.locator('#answer')).toBeEmpty();
});

test('where nothing may move by itself a guess does not play: the answer is there', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  await page.getByRole('button', { name: 'It stays down' }).click();
  await expect(page.locator('#answer')).toHaveText(/^HOP: 0\.63 R high\. You guessed otherwise\./);
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'paused');
});

test('while the weight is dragged on a phone, the simple view shows nothing but the hoop', async ({
  browser,
  baseURL,
}) => {
  const context = await browser.newContext({
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    baseURL: baseURL!,
  });
  const page = await context.newPage();
  // What is written on the hoop, and where the inset of the forces is filled.
  await page.addInitScript(() => {
    const written: string[] = [];
    Object.assign(window, { written });
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      if (this.canvas.id === 'hoop') written.push(text);
      fillText.call(this, text, ...rest);
    };
  });
  /** What is written on the hoop while it is dragged, with the finger or with the keys. */
  const written = (): Promise<string[]> =>
    page.evaluate(() => [
      ...new Set((window as unknown as { written: string[] }).written.splice(0)),
    ]);
  const isNumber = (text: string): boolean => /^[−\d.]+$/.test(text);
  for (const { state, letters } of [
    { state: 'level=full', letters: true },
    { state: 'level=simple', letters: false },
  ]) {
    await page.goto('about:blank');
    await open(page, `case=figure-3&map=0&${state}`);
    if (letters) await expect(page.locator('#moves-sentence')).not.toBeEmpty();
    await written();
    const weight = page.locator('.weight');
    await weight.focus();
    for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowUp');
    await expect(page).toHaveURL(/theta_rate=2\.15/);
    const texts = (await written()).filter((it) => !isNumber(it));
    if (letters) expect(texts).toEqual(expect.arrayContaining(['C', 'N', 'weight']));
    else expect(texts.sort()).toEqual(['R', 'weight']);
    await expect(page.locator('#ghost')).toBeVisible({ visible: letters });
    await expect(page.locator('.slope')).toBeVisible({ visible: letters });
  }
  await context.close();
});

test('it plays at a quarter of the speed around the lift-off', async ({ page }) => {
  await open(page, 'case=figure-3&map=0&slow=1&speed=1');
  /** How fast the time goes from an instant, by the median of frames: on a busy machine some are late. */
  const pace = async (from: number): Promise<number> => {
    await page.evaluate(
      (at) => (location.hash = `case=figure-3&map=0&slow=1&speed=1&at=${at}`),
      from,
    );
    await expect(page.locator('#now')).toHaveText(`τ = ${from.toFixed(3)}`);
    return page.evaluate(async () => {
      const now = (): number => Number(document.querySelector('#now')!.textContent!.slice(4));
      const frame = (): Promise<number> => new Promise((resolve) => requestAnimationFrame(resolve));
      document.querySelector<HTMLElement>('#play')!.click();
      await frame();
      let [at, shown] = [await frame(), now()];
      const paces: number[] = [];
      while (paces.length < 15) {
        const [later, moved] = [await frame(), now()];
        if (later > at) paces.push((1000 * (moved - shown)) / (later - at));
        [at, shown] = [later, moved];
      }
      document.querySelector<HTMLElement>('#play')!.click();
      return paces.sort((a, b) => a - b)[7]!;
    });
  };
  // The lift-off is at 1.519: a second is a unit of time long before it, and a quarter of one
  // beside it.
  const [far, near] = [await pace(0.2), await pace(1.4)];
  expect(near / far).toBeGreaterThan(0.15);
  expect(near / far).toBeLessThan(0.4);
});

test('the full view is one click away, and is remembered; links keep their meaning', async ({
  page,
  context,
}) => {
  await open(page);
  await page.getByRole('button', { name: 'Full view' }).click();
  await expect(page.locator('#plane')).toBeVisible();
  await expect(question(page)).toBeHidden();
  const again = await context.newPage();
  await again.goto('./');
  await ready(again);
  await expect(again.locator('#plane')).toBeVisible();
});

test('a link without a level is full on a desk and simple on a phone, with the same motion', async ({
  page,
  browser,
  baseURL,
}) => {
  await open(page, 'case=slip-then-jump');
  await expect(page.locator('#plane')).toBeVisible();
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    baseURL: baseURL!,
  });
  const phone = await context.newPage();
  await open(phone, 'case=slip-then-jump');
  await expect(question(phone)).toBeVisible();
  await expect(phone.locator('#plane')).toBeHidden();
  expect((await phases(phone)).map((it) => it.time)).toEqual(
    (await phases(page)).map((it) => it.time),
  );
  await phone.getByRole('button', { name: 'Full view' }).click();
  await expect(phone.locator('#plane')).toBeVisible();
  await context.close();
});

for (const level of ['simple', 'full'] as const) {
  test(`on a phone the hoop and the play button stay in sight while a slider moves, ${level}`, async ({
    browser,
    baseURL,
  }) => {
    const context = await browser.newContext({
      viewport: { width: 390, height: 844 },
      hasTouch: true,
      isMobile: true,
      baseURL: baseURL!,
    });
    const page = await context.newPage();
    await open(page, `case=figure-3&map=0&level=${level}`);
    const last = page.locator(level === 'simple' ? '#word-bounce' : '#slider-theta_rate');
    await last.evaluate((it) => it.scrollIntoView({ block: 'end' }));
    for (const it of [page.locator('#hoop'), page.locator('#play'), last])
      await expect(it).toBeInViewport({ ratio: 0.9 });
    await context.close();
  });
}

test('a swipe that begins on a slider scrolls the page, and leaves the value', ({
  browser,
  baseURL,
}) =>
  swipe([browser, baseURL!], 'map=0&level=full', async (page) => {
    const slider = page.locator('#slider-mu_s');
    await slider.evaluate((it) => it.scrollIntoView({ block: 'end' }));
    const box = (await slider.boundingBox())!;
    return { x: box.x + 0.8 * box.width, y: box.y + box.height / 2 };
  }));

test('the sliders in words change the motion, and say how', async ({ page }) => {
  await open(page, 'case=figure-3&map=0&level=simple');
  const slider = (name: string) => page.getByRole('slider', { name });
  await expect(slider('Weight').last()).toHaveAttribute('aria-valuetext', 'as heavy as the hoop');
  await expect(slider('Spin')).toHaveAttribute('aria-valuetext', '2, to the left');
  await slider('Grip').fill('1');
  // μk keeps its part of μs.
  await expect(page).toHaveURL(/mu_s=1&mu_k=0\.8&/);
  // Ten times the hoop: m1/m2 = 0.1, and the inertia with it.
  await page.locator('#word-weight').fill('1');
  await expect(page).toHaveURL(/mass_ratio=0\.1&offset=1&inertia=0\.1&/);
  await page.locator('#word-bounce').fill('0.5');
  await expect(page).toHaveURL(/restitution=0\.5/);
  await page.locator('#word-bounce').fill('-0.05');
  await expect(page).not.toHaveURL(/restitution/);
  await page.locator('#word-spin').fill('0');
  await expect(slider('Spin')).toHaveAttribute('aria-valuetext', 'none');
});

test('of a hoop without mass the sliders say what there is', async ({ page }) => {
  await open(page, 'case=figure-7&map=0&level=simple');
  await expect(page.locator('#word-weight')).toBeDisabled();
  await expect(page.locator('#word-weight')).toHaveAttribute(
    'aria-valuetext',
    'all there is: the hoop weighs nothing',
  );
  await expect(page.locator('#words-legend')).toContainText('glides');
});

test('without a mouse: the first stop leads to the weight, and a guess is a button', async ({
  page,
}) => {
  await open(page, 'case=figure-3&map=0&level=simple');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(page.locator('.weight')).toBeFocused();
  await page.keyboard.press('ArrowLeft');
  await expect(page).toHaveURL(/theta=1\.62/);
  // The question is asked anew.
  await expect(page.locator('#answer')).toBeEmpty();
  await page.getByRole('button', { name: 'It stays down' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
});

test('undo takes back one change, and reset all of them', async ({ page }) => {
  await open(page, 'case=slip-then-jump&map=0&level=simple');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await page.locator('#word-grip').fill('1');
  await page.locator('#word-spin').focus();
  await page.locator('#word-spin').fill('1');
  await expect(page).toHaveURL(/theta_rate=1&/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page).toHaveURL(/theta_rate=3&/);
  await expect(page).toHaveURL(/mu_s=1&/);
  await page.getByRole('button', { name: 'Reset' }).click();
  await expect(page).toHaveURL(/case=slip-then-jump/);
});

/** Contrast of what is written or drawn on a control with what is behind it, as it is now. */
function contrast(control: Element): number {
  /** Red, green, blue and opacity, each from 0 to 1. */
  const channels = (colour: string): number[] => {
    const [red = 0, green = 0, blue = 0, alpha = 1] = colour.match(/[\d.]+/g)!.map(Number);
    const most = colour.startsWith('rgb') ? 255 : 1;
    return [red / most, green / most, blue / most, alpha];
  };
  const luminance = (colour: number[]): number => {
    const [red, green, blue] = colour.map((it) =>
      it <= 0.04045 ? it / 12.92 : ((it + 0.055) / 1.055) ** 2.4,
    );
    return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
  };
  const over = (top: number[], below: number[]): number[] =>
    below.map((it, i) => top[3]! * top[i]! + (1 - top[3]!) * it);
  const behind = (element: Element | null): number[] => {
    if (element === null) return [1, 1, 1];
    const own = channels(getComputedStyle(element).backgroundColor);
    return own[3] === 1 ? own.slice(0, 3) : over(own, behind(element.parentElement));
  };
  const ground = behind(control);
  const [light = 0, dark = 0] = [ground, over(channels(getComputedStyle(control).color), ground)]
    .map(luminance)
    .sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}

for (const theme of ['light', 'dark'] as const) {
  test(`what is written on a control is read while it is hovered, focused or pressed, ${theme}`, async ({
    page,
  }) => {
    for (const state of ['level=simple', 'level=full', 'lesson=hop', 'case=figure-3-bounces']) {
      await open(page, `${state}&map=0&theme=${theme}`);
      await page.reload();
      await ready(page);
      if (state !== 'level=full' && !state.startsWith('case')) {
        await page.locator('#guesses button').first().click();
        await page.locator('#play').click();
      }
      const controls = page.locator(
        'button:visible:not(:disabled):not(.weight):not(.handle), select:visible, a:visible',
      );
      const count = await controls.count();
      expect(count).toBeGreaterThan(5);
      // Of controls without a name of their own, one of each kind.
      const kinds = await controls.evaluateAll((all) =>
        all.map((it) => it.id || `${it.tagName} ${it.className}`),
      );
      for (let i = 0; i < count; i++) {
        if (kinds.indexOf(kinds[i]!) < i) continue;
        const control = controls.nth(i);
        const name = await control.evaluate((it) => it.outerHTML.slice(0, 120));
        // What is off the screen until it is focused, and what a motion lays over another.
        if (name.includes('"skip"') || name.includes('start-handle')) continue;
        await control.hover({ force: true });
        expect(await control.evaluate(contrast), `${name} hovered`).toBeGreaterThan(4.5);
        await control.focus();
        expect(await control.evaluate(contrast), `${name} focused`).toBeGreaterThan(4.5);
      }
    }
  });
}

test('the sliders in words find where the outcome changes, once it is known', async ({ page }) => {
  await open(page, 'case=figure-3&level=simple');
  const find = page.getByRole('button', { name: 'Where does it change? Spin' });
  await expect(find).toBeHidden();
  await page.locator('#last').click();
  await find.press('Enter');
  const found = page.locator('output.found').first();
  await expect(found).toHaveText(/^Below [\d.]+: .*\. From there on: .*\.$/);
  const value = Number(/[\d.]+/.exec((await found.textContent())!)![0]);
  // The motion is the first of the upper side. The same by bisection of `littlewood simulate`.
  await expect(page).toHaveURL(new RegExp(`theta_rate=${String(value).slice(0, 6)}`));
  expect(Math.abs(value - 1.6448)).toBeLessThan(2e-4);
  // Another motion has another place.
  await page.getByRole('slider', { name: 'Spin at the start' }).press('End');
  await expect(found).toBeEmpty();
});
