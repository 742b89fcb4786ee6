// A free port for the server of a test, so that two checkouts can be tested at once. Processes of
// one run share it.

import { createServer } from 'node:net';

/** @returns {Promise<number>} */
const free = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

process.env.LITTLEWOOD_TEST_PORT ??= String(await free());

export const PORT = Number(process.env.LITTLEWOOD_TEST_PORT);
