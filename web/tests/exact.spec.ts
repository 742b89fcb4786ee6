// What the page shows is one thing, said once, in the units that are shown.

import { readFileSync } from 'node:fs';
import { expect, type Page, test } from '@playwright/test';
import { field, open, type } from './lab';

/** A view as SVG: what is written in it, and its text as a whole. */
async function svg(
  page: Page,
  view: 'hoop' | 'plane' | 'plots',
): Promise<{ texts: string[]; all: string }> {
  await page.locator('#open-share').click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator(`#svg-${view}`).click(),
  ]);
  await page.locator('#close-share').click();
  const all = readFileSync(await download.path(), 'utf8');
  return { texts: [...all.matchAll(/<text[^>]*>([^<]*)</g)].map((it) => it[1]!), all };
}

test('the energy has one zero', async ({ page }) => {
  // U of (2.8) is cos θ in contact, 0 at θ = π/2; T = D θ′²/2 = 8 with D = 4, θ′ = 2 (2.11).
  await open(page, 'case=figure-3-bounces&map=0');
  await expect(page.locator('#energy-sum')).toHaveText('8 m₂gR');
  await expect(page.locator('output[data-part=potential]')).toHaveText('0');
  await expect(page.locator('output[data-part=kinetic]')).toHaveText('8');
  await expect(page.locator('output[data-plot=energy]')).toHaveText('8.000');
  // At θ = 2.5, θ′ = 0 it is cos 2.5 = −0.8011, on the bar and in the plot.
  await open(page, 'case=figure-2-libration&restitution=0.5&map=0');
  await expect(page.locator('#energy-sum')).toHaveText('−0.8011 m₂gR');
  await expect(page.locator('output[data-part=potential]')).toHaveText('−0.8011');
  await expect(page.locator('output[data-plot=energy]')).toHaveText('−0.801');
});

test('the bar of the energy ends each part at its place over the zero', async ({ page }) => {
  await open(page, 'case=figure-3-bounces&map=0');
  const [bar, zero, potential, kinetic] = await Promise.all(
    ['#energy-bar', '.zero', '.part[data-energy=potential]', '.part[data-energy=kinetic]'].map(
      async (it) => (await page.locator(it).boundingBox())!,
    ),
  );
  // From −1 to 8: zero is a ninth from the left, where U = 0 ends at θ = π/2, and T fills the rest.
  const part = (x: number): number => (x - bar!.x) / bar!.width;
  expect(Math.abs(part(zero!.x) - 1 / 9)).toBeLessThan(0.005);
  expect(Math.abs(part(potential!.x + potential!.width) - 1 / 9)).toBeLessThan(0.005);
  expect(Math.abs(part(kinetic!.x + kinetic!.width) - 1)).toBeLessThan(0.005);
});

test('the friction that is needed is that of the instant, and events tell none that changes', async ({
  page,
}) => {
  await open(page, 'case=rolls-forever&map=0');
  const seen = new Set<string>();
  for (let i = 0; i < 6; i++) {
    // The plots are drawn in the next frame.
    const [demand, text] = await page.evaluate(async () => {
      for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
      const said = (it: string): string => document.querySelector(it)!.textContent;
      return [Number(said('output[data-plot=demand]')), said('#friction')] as const;
    });
    if (demand > 0.001) {
      const told = Number(/^Rolling needs \|F\|\/N = ([\d.]+) here; μₛ = 0\.5\.$/.exec(text)![1]);
      expect(Math.abs(told - demand)).toBeLessThan(0.006 * demand + 0.0006);
      seen.add(text);
    }
    for (let k = 0; k < 7; k++) await page.locator('#time').press('ArrowRight');
  }
  expect(seen.size).toBeGreaterThan(3);
  await expect(page.locator('#sentence')).not.toContainText('coefficient');
  // A slide needs none.
  await open(page, 'case=figure-3&map=0&at=0.2');
  await expect(page.locator('#friction')).toBeEmpty();
});

test('ticks of an axis differ', async ({ page }) => {
  // What is written on each canvas since it was cleared: along the axis on its left, and below.
  await page.addInitScript(() => {
    const { fillText, clearRect } = CanvasRenderingContext2D.prototype;
    const written = new WeakMap<HTMLCanvasElement, Record<string, string[]>>();
    CanvasRenderingContext2D.prototype.clearRect = function (...area) {
      written.set(this.canvas, { right: [], center: [] });
      clearRect.apply(this, area);
    };
    CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
      written.get(this.canvas)?.[this.textAlign]?.push(text);
      fillText.call(this, text, ...place);
    };
    Object.assign(window, { written });
  });
  type Written = WeakMap<Element, Record<'right' | 'center', string[]>>;
  const ticks = (align: 'right' | 'center'): Promise<string[][]> =>
    page
      .locator('.chart canvas')
      .evaluateAll(
        (all, align) =>
          all.map((it) => (window as unknown as { written: Written }).written.get(it)![align]),
        align,
      );
  const differ = (axes: string[][]): void => {
    expect(axes).toHaveLength(5);
    for (const labels of axes) {
      expect(labels.length).toBeGreaterThan(1);
      expect(new Set(labels).size, labels.join(', ')).toBe(labels.length);
    }
  };
  // A motion that is shown for 2e-4.
  await open(page, 'case=figure-3&until=0.0002&map=0');
  differ(await ticks('center'));
  // A slip of a hundredth costs some 1e-4 of the energy, which is 4/3.
  await open(page, 'case=rolls-forever&theta=0.8&theta_rate=0.5&slip=0.02&map=0');
  differ(await ticks('center'));
  const axes = await ticks('right');
  differ(axes);
  // A range that four digits do not resolve.
  expect(Number(axes[4]!.at(-1)) - Number(axes[4]![0])).toBeLessThan(1e-3);
});

test('in SI units the axes of the hoop and of the plane are in metres and radians a second', async ({
  page,
}) => {
  await open(page, 'case=figure-3&map=0&follow=0');
  const plain = await svg(page, 'hoop');
  expect(plain.texts).toContain('R');
  // Hoop and particle weigh 1 + 1.
  expect(plain.texts).toContain('weight: 2 m₂g');
  expect((await svg(page, 'plane')).texts).toContain('θ′ [√(g/R)]');
  await page.locator('#si').check();
  const si = await svg(page, 'hoop');
  expect(si.texts).toContain('m');
  // 2 · 0.14 kg · 9.80665 m/s².
  expect(si.texts).toContain('weight: 2.75 N');
  // It lands 7.806 R away, 3.513 m: the ticks reach no further than the view does.
  const least = (texts: string[]): number =>
    Math.min(
      ...texts.map((it) => Number(it.replace('−', '-'))).filter((it) => Number.isFinite(it)),
    );
  expect(least(plain.texts)).toBeLessThan(-6);
  expect(least(si.texts)).toBeGreaterThan(-5);
  const plane = (await svg(page, 'plane')).texts;
  expect(plane).toContain('dθ/dt [rad/s]');
  // 4 √(g/R) is 18.7 rad/s.
  expect(plane).toContain('10');
  expect(plane).not.toContain('4');
});

test('forces have one scale, whatever the motion', async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  /** The lengths of the arrow of the weight, and of the bar that says what it is worth. */
  const lengths = async (state: string): Promise<[number, number, number]> => {
    await page.goto(`./#${state}`);
    await page.reload();
    await expect(page.locator('html[data-ready=true]')).toBeAttached();
    const { all } = await svg(page, 'hoop');
    // The bar: three strokes in one path, at its left end.
    const bar = /d="M6 [\d.]+L6 [\d.]+M6 [\d.]+L([\d.]+) /.exec(all)!;
    const radius = Math.max(...[...all.matchAll(/A([\d.]+) \1 0 0 1/g)].map((it) => Number(it[1])));
    const weight = [
      ...all.matchAll(/d="M([\d.]+) ([\d.]+)L\1 ([\d.]+)"[^>]*stroke-width="3"/g),
    ].map((it) => Number(it[3]) - Number(it[2]));
    return [Number(bar[1]) - 6, radius + 2.5, Math.max(...weight)];
  };
  for (const rate of [1, 2, 3]) {
    const [bar, radius, weight] = await lengths(`case=figure-3&theta_rate=${rate}&map=0`);
    // 0.4 of a radius; the shaft of an arrow ends within its head.
    expect(Math.abs(bar / radius - 0.4)).toBeLessThan(0.01);
    expect(weight).toBeGreaterThan(0.5 * bar);
    expect(weight).toBeLessThanOrEqual(bar + 0.1);
  }
});

test('events of one instant are all told', async ({ page }) => {
  await open(page, 'case=lands-and-rolls&map=0');
  await page.locator('#last').click();
  for (
    let i = 0;
    i < 20 && !(await page.locator('#sentence').textContent())!.includes('Lands');
    i++
  )
    await page.locator('#previous').click();
  await expect(page.locator('#sentence')).toContainText('Lands');
});

test('rounding is not shown as physics', async ({ page }) => {
  await open(page, 'case=bounces-forever&map=0');
  for (let bounce = 0; bounce < 5; bounce++) {
    await page.locator('#next-impact').click();
    await expect(page.locator('#impact-sentence')).toContainText('sticks throughout');
    // It never slips, and its impulse and its energy are what they are, or nothing.
    const numbers = await page.locator('#impact-numbers td[data-value]').allTextContents();
    expect(numbers.filter((it) => /e[-−]/.test(it))).toEqual([]);
  }
  // The smallest bounces have an impulse that is known, and take less than the energy is rounded
  // by, 1e-15 of it.
  await open(page, 'case=figure-3-bounces&map=0');
  await page.locator('#last').click();
  await expect(page.locator('#impact-place')).toContainText('all smaller ones together');
  const number = (name: string) => page.locator(`#impact-numbers [data-quantity=${name}] td`);
  await expect(number('normal_impulse')).toHaveText(/^1\.187\d*e−7$/);
  await expect(number('energy_lost')).toHaveText('0');
});

test('a massless hoop keeps its start in sight', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  await page.locator('#si').check();
  await page.locator('#massless').check();
  // θ′ = 2 lies within the plane.
  const rate = Number(
    /rate=([\d.]+)/.exec(page.url().replaceAll(/theta_rate[a-z_]*=/g, ''))?.[1] ?? 4,
  );
  expect(rate).toBeGreaterThan(2);
  const [handle, plane] = [
    (await page.locator('#start-handle').boundingBox())!,
    (await page.locator('#plane').boundingBox())!,
  ];
  expect(handle.y).toBeGreaterThan(plane.y);
});

test('𝓡 leaves the colours of the map as its legend has them', async ({ page }) => {
  await open(page, 'case=rolls-forever');
  await expect(page.locator('html[data-map=done]')).toBeAttached();
  const swatch = await page
    .locator('#legend [data-class=rolls_forever] .swatch')
    .evaluate((it) => getComputedStyle(it).backgroundColor);
  // Between the strokes of 𝓡, the curves and the levels the map shows through.
  const found = await page.locator('#plane-base').evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    const counts = new Map<string, number>();
    for (let i = 0; i < data.length; i += 4) {
      const colour = `rgb(${data[i]}, ${data[i + 1]}, ${data[i + 2]})`;
      counts.set(colour, (counts.get(colour) ?? 0) + 1);
    }
    return [...counts].sort((a, b) => b[1] - a[1]).slice(0, 4);
  });
  expect(found.map(([colour]) => colour)).toContain(swatch);
});

test('an event that is chosen below the fold brings the hoop into view', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 640 });
  await open(page, 'case=figure-3-bounces&map=0');
  await page.locator('#phases button').last().scrollIntoViewIfNeeded();
  await expect(page.locator('#hoop')).not.toBeInViewport();
  // A link to an instant says what begins there.
  await expect(page.locator('#phases button').last()).toHaveAccessibleName(/^rolling from 6\.92/);
  await page.locator('#phases button').last().click();
  await expect(page.locator('#hoop')).toBeInViewport({ ratio: 0.95 });
});

test('the keys of time: a hundredth, a thousandth, an event; and the space bar anywhere', async ({
  page,
}) => {
  await open(page, 'case=figure-3&map=0');
  await page.locator('#time').focus();
  await page.keyboard.press('ArrowRight');
  // A hundredth of 3.847.
  await expect(page.locator('#now')).toHaveText('τ = 0.038');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(page.locator('#now')).toHaveText('τ = 0.035');
  await page.keyboard.press('PageUp');
  await expect(page.locator('#now')).toHaveText('τ = 0.564');
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  const before = await page.evaluate(() => window.scrollY);
  await page.keyboard.press('Space');
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'playing');
  await page.keyboard.press('Space');
  await expect(page.locator('#play')).toHaveAttribute('data-state', 'paused');
  expect(await page.evaluate(() => window.scrollY)).toBe(before);
});

test('hoop and play button are in sight on a phone on its side, and the hoop has its room on a tablet', async ({
  page,
}) => {
  await page.setViewportSize({ width: 844, height: 390 });
  for (const level of ['simple', 'full']) {
    await open(page, `case=figure-3&map=0&level=${level}`);
    await page.reload();
    for (const id of ['hoop', 'play', 'time'])
      await expect(page.locator(`#${id}`)).toBeInViewport({ ratio: 1 });
  }
  await page.setViewportSize({ width: 820, height: 1180 });
  await expect(page.locator('#play')).toBeInViewport({ ratio: 1 });
});

test('a curve that there is not has no place in the legend, and words can stand for symbols', async ({
  page,
}) => {
  await open(page, 'mass_ratio=1&offset=0&inertia=1&mu_s=0.5&mu_k=0.4&theta=0&theta_rate=2&map=0');
  await expect(page.locator('#curves [data-curve=lift_off]')).toBeHidden();
  await open(page, 'case=figure-3&map=0');
  await expect(page.locator('#curves [data-curve=lift_off]')).toBeVisible();
  const letters = (await svg(page, 'hoop')).texts;
  expect(letters).toContain('N');
  await page.locator('#symbols').uncheck();
  expect((await svg(page, 'hoop')).texts).not.toContain('N');
  await expect(page.locator('label[for=field-mu_s]')).toHaveText('coefficient of static friction', {
    useInnerText: true,
  });
});

test('the tip of a field does not hide the next one', async ({ page }) => {
  await open(page, 'case=figure-3&map=0&level=full');
  for (const width of [1440, 820, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await field(page, 'mu_s').hover();
    const tip = page.locator('#tip-mu_s');
    await expect(tip).toBeVisible();
    const [a, b] = [(await tip.boundingBox())!, (await field(page, 'mu_k').boundingBox())!];
    expect(a.y + a.height <= b.y || a.x >= b.x + b.width, `${width}`).toBe(true);
  }
});

test('a mark measures time and way from an instant', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  // From the lift-off to the landing: 2.329 √(R/g), 4.2 R to the left, as the sentence has it.
  for (let i = 0; i < 3; i++) await page.locator('#next').click();
  await page.locator('#mark').click();
  await page.locator('#next').click();
  await expect(page.locator('#sentence')).toContainText(
    'Lands 4.2 R to the left after 2.33 √(R/g)',
  );
  await expect(page.locator('#since')).toHaveText(
    /^Δτ = 2\.329 √\(R\/g\), Δx = −4\.(19|20)\d* R, Δθ = 4\.654$/,
  );
  await page.locator('#mark').click();
  await expect(page.locator('#since')).toBeHidden();
});

test('the case says what is changed', async ({ page }) => {
  await open(page, 'case=figure-3&map=0');
  const shown = page.locator('#case option:checked');
  await type(page, 'theta', '1');
  await expect(shown).toHaveText('figure-3, another start');
  await type(page, 'mu_s', '0.6');
  await expect(shown).toHaveText('custom hoop');
  await page.locator('#case').selectOption('figure-3');
  await page.locator('#si').check();
  await expect(shown).toHaveText('figure-3, in SI units');
  await expect(field(page, 'radius_m')).toHaveValue('0.45');
});

test('the map of several workers is that of one', { tag: '@thorough' }, async ({
  browser,
  baseURL,
}) => {
  test.slow();
  const pictures: string[] = [];
  for (const cores of [2, 4]) {
    const context = await browser.newContext({
      baseURL: baseURL!,
      viewport: { width: 1440, height: 900 },
    });
    await context.addInitScript(
      (count) => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => count }),
      cores,
    );
    const page = await context.newPage();
    for (const state of [
      'case=figure-3',
      'case=figure-3&slip=0.5',
      'case=figure-3-bounces&shows=hops',
    ]) {
      await open(page, state);
      await page.reload();
      await expect(page.locator('html[data-map=done]')).toBeAttached({ timeout: 60_000 });
      expect(page.workers()).toHaveLength(cores - 1);
      await page.waitForTimeout(300);
      pictures.push(
        await page
          .locator('#plane-base')
          .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL()),
      );
    }
    await context.close();
  }
  expect(pictures.slice(3)).toEqual(pictures.slice(0, 3));
});
