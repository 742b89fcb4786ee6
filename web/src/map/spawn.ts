// The worker of the map, in a file of its own. Where the page has to be one file, `spawn-inline.ts`
// stands in for this.

export function spawn(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
}
