// The part of the core for maps and derivatives. It has a memory of its own, and so problems of its
// own.

import * as core from '../wasm/later/littlewood_web.js';
import { laterModule } from './module';

let loading: Promise<void> | null = null;
let isLoaded = false;

/** It, if it has been loaded. */
export function later(): typeof core | null {
  return isLoaded ? core : null;
}

/** Loads it for the page. */
export function loadLater(): Promise<void> {
  loading ??= load();
  return loading;
}

async function load(): Promise<void> {
  await core.default({ module_or_path: await laterModule() });
  core.begin();
  isLoaded = true;
}
