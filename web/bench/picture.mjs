// Writes docs/lab.png, the page with the motion of Figure 3: `npm run build && npm run picture`.

import { spawn } from 'node:child_process';
import { chromium } from '@playwright/test';

import { CHROMIUM } from '../tests/chromium.mjs';
import { PORT } from '../tests/port.mjs';

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
} finally {
  await browser.close();
  server.kill();
}
