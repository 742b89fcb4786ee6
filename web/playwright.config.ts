import { defineConfig } from '@playwright/test';

import { CHROMIUM } from './tests/chromium.mjs';
import { PORT } from './tests/port.mjs';

export default defineConfig({
  testDir: 'tests',
  testIgnore: 'site/**',
  outputDir: 'test-results',
  workers: 2,
  timeout: 120_000,
  expect: { timeout: 15_000 },
  reporter: [['list']],
  use: {
    // Under a sub-path, as on the pages of a course.
    baseURL: `http://127.0.0.1:${PORT}/courses/mechanics/hoop/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: CHROMIUM,
  },
  webServer: {
    command: `node tests/serve.mjs dist ${PORT}`,
    url: `http://127.0.0.1:${PORT}/courses/mechanics/hoop/`,
    reuseExistingServer: false,
  },
});
