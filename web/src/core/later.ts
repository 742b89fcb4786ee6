// The part of the core for maps and derivatives. It has a memory of its own, and so problems of its
// own.

import { laterModule } from './module';

type Later = typeof import('../wasm/later/littlewood_web.js');

let core: Later | null = null;
let loading: Promise<Later> | null = null;

/** It, if it has been loaded. */
export function later(): Later | null {
  return core;
}

/** Loads it for the page. */
export function loadLater(): Promise<Later> {
  loading ??= load();
  return loading;
}

async function load(): Promise<Later> {
  const [module, loaded] = await Promise.all([
    laterModule(),
    import('../wasm/later/littlewood_web.js'),
  ]);
  await loaded.default({ module_or_path: module });
  loaded.begin();
  core = loaded;
  return loaded;
}
