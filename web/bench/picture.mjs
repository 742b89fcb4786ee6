// Writes docs/lab.png, the page with the motion of Figure 3, and docs/ten-thousand.gif, the first
// picture of the story: `npm run build && npm run picture`.

import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { chromium } from '@playwright/test';
import gifenc from 'gifenc';

import { CHROMIUM } from '../tests/chromium.mjs';
import { PORT } from '../tests/port.mjs';

/** Frames of the film, their time in parts of that of the picture, milliseconds of one, and colours. */
const FRAMES = 44;
const UNTIL = 0.72;
const DELAY = 90;
const COLOURS = 48;

const server = spawn(process.execPath, ['tests/serve.mjs', 'dist', String(PORT), '/lab/'], {
  stdio: 'ignore',
});
const browser = await chromium.launch(CHROMIUM);
try {
  await new Promise((resolve) => setTimeout(resolve, 500));
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.goto(`http://127.0.0.1:${PORT}/lab/#case=figure-3&at=1.2&theme=light`);
  await page.waitForFunction(() => document.documentElement.dataset.map === 'done');
  await page.screenshot({ path: '../docs/lab.png' });
  await film();
} finally {
  await browser.close();
  server.kill();
}

async function film() {
  // Nothing plays by itself: each frame is set.
  const page = await browser.newPage({
    viewport: { width: 720, height: 900 },
    reducedMotion: 'reduce',
    colorScheme: 'light',
  });
  await page.goto(`http://127.0.0.1:${PORT}/lab/story.html`);
  await page.waitForSelector('#picture-release[data-followed="10000"]');
  /** What the picture shows at a part of its time. */
  const shot = async (at) => {
    const { width, height, pixels } = await page.evaluate(async (part) => {
      const slider = document.querySelector('#picture-release-time');
      slider.value = String(part);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const canvas = document.querySelector('#picture-release canvas');
      const sheet = document.createElement('canvas');
      const { width, height } = canvas;
      [sheet.width, sheet.height] = [width, height];
      const context = sheet.getContext('2d');
      context.fillStyle = '#ffffff';
      context.fillRect(0, 0, width, height);
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      let bytes = '';
      for (let i = 0; i < data.length; i += 8192)
        bytes += String.fromCharCode(...data.subarray(i, i + 8192));
      return { width, height, pixels: btoa(bytes) };
    }, at);
    return { width, height, data: new Uint8Array(Buffer.from(pixels, 'base64')) };
  };
  // The colours of four frames serve all.
  const some = [];
  for (const part of [0, 0.15, 0.3, 1]) some.push((await shot(UNTIL * part)).data);
  const palette = gifenc.quantize(Buffer.concat(some), COLOURS);
  const encoder = gifenc.GIFEncoder();
  for (let frame = 0; frame < FRAMES; frame++) {
    const { width, height, data } = await shot((UNTIL * frame) / (FRAMES - 1));
    const index = gifenc.applyPalette(data, palette);
    encoder.writeFrame(index, width, height, {
      ...(frame === 0 ? { palette, repeat: 0 } : {}),
      delay: frame === FRAMES - 1 ? 2000 : DELAY,
    });
  }
  encoder.finish();
  writeFileSync('../docs/ten-thousand.gif', encoder.bytes());
}
