// Compares the digests of all blocks of motions, as the core of the page computes them, with those
// committed. After `web/build.sh wasm`.

import { readFileSync } from 'node:fs';
import { digestLine, initSync } from './src/wasm/later/littlewood_web.js';

const read = (path) => readFileSync(new URL(path, import.meta.url));

initSync({ module: read('src/wasm/later/littlewood_web_bg.wasm') });
const committed = read('../crates/littlewood-digest/digest.txt').toString().trimEnd().split('\n');
let differing = 0;
for (const [block, line] of committed.entries()) {
  const computed = digestLine(block);
  if (computed === line) continue;
  console.log(`committed ${line}\ncomputed  ${computed}`);
  differing += 1;
}
console.log(`${differing} of ${committed.length} blocks differ`);
process.exitCode = differing === 0 ? 0 : 1;
