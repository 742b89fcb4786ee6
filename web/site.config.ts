import { defineConfig } from '@playwright/test';

import { CHROMIUM } from './tests/chromium.mjs';
import { PORT } from './tests/port.mjs';

const SITE = process.env.LITTLEWOOD_SITE ?? '../target/site';

export default defineConfig({
  testDir: 'tests/site',
  outputDir: 'test-results',
  workers: 2,
  fullyParallel: true,
  timeout: 60_000,
  expect: { timeout: 15_000 },
  reporter: [['list']],
  use: {
    // Under a sub-path, as a host of projects has it.
    baseURL: `http://127.0.0.1:${PORT}/littlewood/`,
    viewport: { width: 1280, height: 900 },
    launchOptions: CHROMIUM,
  },
  webServer: {
    command: `node tests/serve.mjs ${SITE} ${PORT} /littlewood/`,
    url: `http://127.0.0.1:${PORT}/littlewood/index.html`,
    reuseExistingServer: false,
  },
});
