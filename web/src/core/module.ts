// Fetches and compiles the two parts of the core, each once for the page and its workers.

import firstAddress from '../wasm/first/littlewood_web_bg.wasm?url';
import laterAddress from '../wasm/later/littlewood_web_bg.wasm?url';

let later: Promise<WebAssembly.Module> | null = null;

/** The part that the first picture needs. */
export function firstModule(): Promise<WebAssembly.Module> {
  return compile(firstAddress);
}

/** The part for maps and derivatives, fetched after the picture that is being drawn. */
export function laterModule(): Promise<WebAssembly.Module> {
  later ??= drawn().then(() => compile(laterAddress));
  return later;
}

/** The next picture is there. A page that is not shown draws none. */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    if (document.hidden) resolve();
    else requestAnimationFrame(() => setTimeout(resolve));
  });
}

async function compile(address: string): Promise<WebAssembly.Module> {
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
