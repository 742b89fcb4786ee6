// Fetches and compiles the core, once for the page and its worker.

import address from '../wasm/littlewood_web_bg.wasm?url';

let compiled: Promise<WebAssembly.Module> | null = null;

/** The compiled core. */
export function coreModule(): Promise<WebAssembly.Module> {
  compiled ??= compile();
  return compiled;
}

async function compile(): Promise<WebAssembly.Module> {
  const url = new URL(address, import.meta.url);
  try {
    return await WebAssembly.compileStreaming(fetch(url));
  } catch {
    // A host that does not know the media type of WebAssembly.
    const response = await fetch(url);
    if (!response.ok)
      throw new Error(`the core could not be loaded: ${response.status} ${response.statusText}`);
    return WebAssembly.compile(await response.arrayBuffer());
  }
}
