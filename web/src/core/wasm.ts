// Starts the core, once in the page and once in the worker.

import init, { begin } from '../wasm/littlewood_web.js';

declare global {
  /** The core calls this when it panics. */
  var littlewoodPanicked: (message: string) => void;
}

/** Starts the core. `panicked` is told of a defect, after which the core is not used again. */
export async function startCore(
  module: WebAssembly.Module,
  panicked: (message: string) => void,
): Promise<void> {
  globalThis.littlewoodPanicked = panicked;
  await init({ module_or_path: module });
  begin();
}

export {
  boundary,
  cases,
  classOf,
  MapSubject,
  Motion,
  OutcomeMap,
  Plane,
  Prediction,
  Problem,
  provokePanic,
  Refusal,
  readLink,
  readNumber,
  Ticks,
  writeLink,
} from '../wasm/littlewood_web.js';
