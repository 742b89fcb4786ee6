// The workers of a map, each with the compiled core.

import { laterModule } from '../core/module';
import type { MapAnswer, MapQuestion } from './messages';
import { spawn } from './spawn';

/** Workers at most; one processor is left to the page. */
const MOST = 16;
export const WORKERS = Math.min(Math.max(navigator.hardwareConcurrency - 1, 1), MOST);

/** Starts them. Each takes requests at once, and works on them when it has the core. */
export function startCrew(
  answered: (answer: MapAnswer) => void,
  failed: (message: string) => void,
): Worker[] {
  const workers = Array.from({ length: WORKERS }, () => spawn());
  for (const worker of workers) {
    worker.onmessage = ({ data }: MessageEvent<MapAnswer>) => {
      if (data.kind === 'failed') failed(data.message);
      else answered(data);
    };
    worker.onerror = (event) => failed(event.message);
  }
  laterModule().then(
    (module) => {
      for (const worker of workers)
        worker.postMessage({ kind: 'core', module } satisfies MapQuestion);
    },
    (error: unknown) => failed(String(error)),
  );
  return workers;
}
