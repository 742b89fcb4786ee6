// Loads the core, once in the page and once in the worker.

import init, { begin } from '../wasm/littlewood_web.js';
import address from '../wasm/littlewood_web_bg.wasm?url';

declare global {
  /** The core calls this when it panics. */
  var littlewoodPanicked: (message: string) => void;
}

/** Loads the core. `panicked` is told of a defect, after which the core is not used again. */
export async function load(panicked: (message: string) => void): Promise<void> {
  globalThis.littlewoodPanicked = panicked;
  const url = new URL(address, import.meta.url);
  let module: WebAssembly.Module;
  try {
    module = await WebAssembly.compileStreaming(fetch(url));
  } catch {
    // A host that does not know the media type of WebAssembly.
    const response = await fetch(url);
    if (!response.ok) throw new Error(`the core could not be loaded: ${response.status} ${response.statusText}`);
    module = await WebAssembly.compile(await response.arrayBuffer());
  }
  await init({ module_or_path: module });
  begin();
}

export { boundary, cases, MapSubject, Motion, OutcomeMap, Plane, Problem, provokePanic, Refusal, Ticks } from
  '../wasm/littlewood_web.js';
