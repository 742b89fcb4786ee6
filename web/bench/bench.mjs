// Measures the page in Chromium against its budgets: `npm run build && npm run bench`. Prints a
// table in Markdown.
//
// Sizes are those of the files that a first visit loads, compressed as hosts compress them. Times
// are medians; a machine that has other things to do shows it in them, which is why its load is
// printed too.

import { spawn } from 'node:child_process';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { chromium } from '@playwright/test';

import { CHROMIUM } from '../tests/chromium.mjs';
import { PORT } from '../tests/port.mjs';

const ADDRESS = `http://127.0.0.1:${PORT}/lab/`;
const RUNS = 7;
const FRAMES = 240;
/** Seconds for which a slider moves. */
const SLIDE = 3;

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const at = (values, part) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];

function files(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? files(`${folder}/${entry.name}`) : [`${folder}/${entry.name}`],
  );
}

function sizes(names) {
  const all = names.map((name) => readFileSync(name));
  const sum = (compress) =>
    all.reduce((total, content) => total + compress(content).length, 0) / 1000;
  return {
    gzip: sum((it) => gzipSync(it, { level: 9 })),
    brotli: sum((it) => brotliCompressSync(it)),
  };
}

async function ready(page) {
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
}

const DESK = { viewport: { width: 1440, height: 900 } };

/** A telephone, whose processor is so many times as slow as this one. */
const PHONE = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true };
const SLOWER = 6;

/** A page of a browser that has never been there. */
async function visitor(browser, device, slower = 1) {
  const page = await (await browser.newContext(device)).newPage();
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: slower });
  return page;
}

/** What is fetched before the first picture. */
async function first(browser) {
  const page = await visitor(browser, DESK);
  await page.goto(ADDRESS);
  await ready(page);
  const names = await page.evaluate(() => {
    const [ready] = performance.getEntriesByName('ready');
    return performance
      .getEntriesByType('resource')
      .filter((it) => it.startTime < ready.startTime)
      .map((it) => it.name);
  });
  await page.context().close();
  return ['dist/index.html', ...names.map((name) => name.replace(ADDRESS, 'dist/'))];
}

/** First paint and ready, from the start of the navigation. */
async function startUp(browser, device, slower) {
  const page = await visitor(browser, device, slower);
  await page.goto(ADDRESS);
  await ready(page);
  await page.waitForTimeout(200);
  const times = await page.evaluate(() => ({
    paint: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
    ready: performance.getEntriesByName('ready')[0].startTime,
  }));
  await page.context().close();
  return times;
}

/** Links to hoops of other regimes, whose maps have a budget of their own. */
const REGIMES = {
  'P ≤ 0 at some angles': 'case=painleve',
  'equal coefficients': 'case=figure-3&mu_s=0.5&mu_k=0.5',
  'nearly equal coefficients': 'case=figure-3&mu_s=0.5&mu_k=0.4999',
  'no kinetic friction': 'case=figure-3&mu_s=0.5&mu_k=0',
  'little friction': 'case=figure-3&mu_s=0.05&mu_k=0.04',
  'next to no friction': 'case=figure-3&mu_s=0.001&mu_k=0.001',
  'no friction': 'case=figure-3&mu_s=0&mu_k=0',
  'no mass': 'case=figure-7',
  light: 'mass_ratio=0&offset=1&inertia=0.01&mu_s=0.5&mu_k=0.4',
};

/** Times of the levels of the outcome map of a hoop, of the worker's own clock, up to one of them. What takes half a minute is left out. */
async function map(browser, hoop, last) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.goto(`${ADDRESS}#${hoop}`);
  await page
    .waitForFunction((name) => performance.getEntriesByName(name).length > 0, last)
    .catch(() => {});
  const levels = await page.evaluate(() =>
    Object.fromEntries(
      performance
        .getEntriesByType('mark')
        .filter((it) => it.name.startsWith('map-'))
        .map((it) => [it.name, it.detail]),
    ),
  );
  await page.close();
  return levels;
}

/**
 * Moves the slider of μs once a frame for a while: maps of 256 × 256 a second meanwhile, those of any level, and how long
 * after the last movement the map of that hoop is there.
 */
async function slide(browser, hoop) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.goto(`${ADDRESS}#${hoop}`);
  await page.waitForFunction(() => performance.getEntriesByName('map-16').length > 0);
  const found = await page.evaluate(async (seconds) => {
    const slider = document.querySelector('#slider-mu_s');
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const marks = (name, from) =>
      performance.getEntriesByName(name).filter((it) => it.startTime > from).length;
    const first = Number(slider.value);
    const begin = await frame();
    let now = begin;
    for (let k = 0; now < begin + 1000 * seconds; k++) {
      slider.value = String(first + 0.01 + 0.2 * Math.abs(Math.sin(k / 40)));
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      now = await frame();
    }
    const fine = marks('map-2', begin);
    const any = ['map-16', 'map-8', 'map-4', 'map-2', 'map-1'].reduce(
      (sum, name) => sum + marks(name, begin),
      0,
    );
    slider.value = String(first + 0.123);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    const last = performance.now();
    const isThere = () => ['2', '1', 'done'].includes(document.documentElement.dataset.map);
    while (!isThere() && performance.now() < last + 30_000) await frame();
    return { fine: fine / seconds, any: any / seconds, last: performance.now() - last };
  }, SLIDE);
  await page.close();
  return found;
}

/**
 * Drags what a selector finds along a circle for a number of frames: the times between frames, and the work of the
 * page for one, in milliseconds of the processor.
 */
async function drag(page, state, selector) {
  await page.goto(`${ADDRESS}#${state}`);
  await ready(page);
  await page.waitForTimeout(3000);
  const client = await page.context().newCDPSession(page);
  await client.send('Performance.enable');
  const busy = async () => {
    const { metrics } = await client.send('Performance.getMetrics');
    return 1000 * metrics.find((it) => it.name === 'ThreadTime').value;
  };
  const begin = await busy();
  const gaps = await page.evaluate(
    async ([count, selector]) => {
      const dragged = document.querySelector(selector);
      const box = document
        .querySelector(selector === '#plane' ? '#plane' : '#hoop')
        .getBoundingClientRect();
      const send = (type, k) => {
        const angle = (2 * Math.PI * k) / 120;
        dragged.dispatchEvent(
          new PointerEvent(type, {
            bubbles: true,
            cancelable: true,
            pointerId: 1,
            isPrimary: true,
            button: 0,
            buttons: 1,
            pointerType: 'mouse',
            clientX: box.x + box.width * (0.5 + 0.25 * Math.cos(angle)),
            clientY: box.y + box.height * (0.5 + 0.35 * Math.sin(angle)),
          }),
        );
      };
      // A pointer that the script makes cannot be captured.
      dragged.setPointerCapture = () => {};
      dragged.hasPointerCapture = () => true;
      send('pointerdown', 0);
      const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
      const gaps = [];
      let before = await frame();
      for (let k = 1; k <= count; k++) {
        send('pointermove', k);
        const now = await frame();
        gaps.push(now - before);
        before = now;
      }
      return gaps;
    },
    [FRAMES, selector],
  );
  const work = ((await busy()) - begin) / FRAMES;
  await page.context().close();
  return { gaps, work };
}

/** Frames a second of the hoops that are let go at once, and how many they are. */
async function release(page) {
  await page.goto(`${ADDRESS}story.html`);
  const picture = page.locator('#picture-release');
  await picture.scrollIntoViewIfNeeded();
  await page.waitForSelector('#picture-release[data-followed]');
  const drawn = async () => Number(await picture.getAttribute('data-drawn'));
  const before = await drawn();
  await page.waitForTimeout(1000 * SLIDE);
  const rate = ((await drawn()) - before) / SLIDE;
  const count = await picture.getAttribute('data-followed');
  await page.context().close();
  return `${rate.toFixed(0)} a second, ${count} hoops`;
}

/** Draws the plotting library's chart of this many points anew, as often as there are runs. */
async function plot(browser, points) {
  const page = await browser.newPage();
  await page.addScriptTag({ path: 'node_modules/uplot/dist/uPlot.iife.min.js' });
  const times = await page.evaluate(
    async ([count, runs]) => {
      const x = Array.from({ length: count }, (_, i) => i / count);
      const data = (k) => [x, x.map((it) => Math.sin(40 * it + k) * Math.cos(300 * it))];
      const chart = new globalThis.uPlot(
        {
          width: 800,
          height: 300,
          series: [{}, { stroke: 'black' }],
          scales: { x: { time: false } },
        },
        data(0),
        document.body,
      );
      const times = [];
      for (let k = 0; k < runs; k++) {
        const next = data(k);
        const begin = performance.now();
        chart.setData(next);
        await Promise.resolve();
        // Reading a pixel waits for the drawing.
        chart.ctx.getImageData(0, 0, 1, 1);
        times.push(performance.now() - begin);
      }
      return times;
    },
    [points, RUNS],
  );
  await page.close();
  return times;
}

const server = spawn(process.execPath, ['tests/serve.mjs', 'dist', String(PORT), '/lab/'], {
  stdio: 'ignore',
});
const browser = await chromium.launch(CHROMIUM);
try {
  await new Promise((resolve) => setTimeout(resolve, 500));
  const before = sizes(await first(browser));
  const size = sizes(files('dist').filter((name) => statSync(name).isFile()));
  const [starts, slow] = [[], []];
  for (let run = 0; run < RUNS; run++) starts.push(await startUp(browser, DESK, 1));
  for (let run = 0; run < RUNS; run++) slow.push(await startUp(browser, PHONE, SLOWER));
  const maps = [];
  for (let run = 0; run < RUNS; run++) maps.push(await map(browser, 'case=figure-3', 'map-1'));
  const regimes = {};
  for (const [name, hoop] of Object.entries(REGIMES))
    regimes[name] = await map(browser, hoop, 'map-2');
  const slides = {};
  for (const [name, hoop] of Object.entries({ 'Figure 2': 'case=figure-3', ...REGIMES }))
    slides[name] = await slide(browser, hoop);
  const desk = await drag(await visitor(browser, DESK), 'case=figure-3', '#plane');
  const phone = await drag(await visitor(browser, PHONE, SLOWER), 'case=figure-3', '.weight');
  const full = await drag(
    await visitor(browser, PHONE, SLOWER),
    'case=figure-3&level=full',
    '#plane',
  );
  const released = await release(await visitor(browser, DESK));
  const few = await release(await visitor(browser, PHONE, SLOWER));
  const frames = ({ gaps }) =>
    `${(1000 / median(gaps)).toFixed(0)} a second; 95 % within ${at(gaps, 0.95).toFixed(1)} ms`;
  const plots = await plot(browser, 100_000);
  const ms = (value) => `${Math.round(value)} ms`;
  const range = (values) =>
    `${ms(median(values))} (${Math.round(Math.min(...values))}–${Math.round(Math.max(...values))})`;
  const levels = (stride) => maps.map((it) => it[`map-${stride}`]);
  console.log(
    `Chromium ${browser.version()}, ${cpus().length} cores of ${cpus()[0].model.trim()}, load ${loadavg()[0].toFixed(1)}`,
  );
  console.log(`
| | budget | measured |
|---|---|---|
| before the first picture, compressed | < 450 kB | ${before.gzip.toFixed(0)} kB gzip, ${before.brotli.toFixed(0)} kB Brotli |
| everything, the story too, compressed | | ${size.gzip.toFixed(0)} kB gzip, ${size.brotli.toFixed(0)} kB Brotli |
| first paint | < 1 s | ${range(starts.map((it) => it.paint))} |
| ready | < 1 s | ${range(starts.map((it) => it.ready))} |
| ready, on a telephone ${SLOWER} times as slow | < 4 s | ${range(slow.map((it) => it.ready))} |
| frames while dragging on the Figure 2 hoop | 60 a second | ${frames(desk)} |
| work of the page for such a frame, time of the processor | < 16.7 ms | ${desk.work.toFixed(1)} ms |
| frames while dragging on that telephone | 20 a second; 95 % within 100 ms | ${frames(phone)} |
| the same in the full view | | ${frames(full)} |
| hoops that are let go at once | 30 a second | ${released} |
| the same on that telephone | | ${few} |
| a plot of 100,000 points drawn anew | | ${range(plots)} |
| outcome map, first picture (32 × 32) | | ${range(levels(16))} |
| outcome map, 256 × 256 | < 200 ms | ${range(levels(2))} |
| outcome map, 512 × 512 | | ${range(levels(1))} |
${Object.entries(regimes)
  .map(
    ([name, levels]) =>
      `| outcome map, 256 × 256, ${name} | < 500 ms | ${levels['map-2'] === undefined ? '> 30 s' : ms(levels['map-2'])} |`,
  )
  .join('\n')}

| while μs moves | maps of 256 × 256 a second | of any level | the last after |
|---|---|---|---|
${Object.entries(slides)
  .map(
    ([name, { fine, any, last }]) =>
      `| ${name} | ${fine.toFixed(1)} | ${any.toFixed(0)} | ${ms(last)} |`,
  )
  .join('\n')}`);
} finally {
  await browser.close();
  server.kill();
}
