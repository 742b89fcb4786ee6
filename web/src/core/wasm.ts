// The part of the core that the first picture needs.

import init, { begin } from '../wasm/first/littlewood_web.js';
import { firstModule } from './module';

declare global {
  /** Both parts of the core call this when they panic. */
  var littlewoodPanicked: (message: string) => void;
}

/** Starts the core. `panicked` is told of a defect, after which the core is not used again. */
export async function startCore(panicked: (message: string) => void): Promise<void> {
  globalThis.littlewoodPanicked = panicked;
  await init({ module_or_path: await firstModule() });
  begin();
}

export {
  boundary,
  cases,
  classOf,
  hopClasses,
  Motion,
  Plane,
  Problem,
  provokePanic,
  Refusal,
  readLink,
  readNumber,
  Ticks,
  writeLink,
} from '../wasm/first/littlewood_web.js';
