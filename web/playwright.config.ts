import { defineConfig } from '@playwright/test';

const PORT = 4173;

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  workers: 2,
  timeout: 120_000,
  expect: { timeout: 15_000 },
  reporter: [['list']],
  use: {
    // Under a sub-path, as on the pages of a course.
    baseURL: `http://127.0.0.1:${PORT}/courses/mechanics/hoop/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: {
      executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
      args: [
        '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync',
      ],
    },
  },
  webServer: {
    command: `node tests/serve.mjs dist ${PORT}`,
    url: `http://127.0.0.1:${PORT}/courses/mechanics/hoop/`,
    reuseExistingServer: false,
  },
});
