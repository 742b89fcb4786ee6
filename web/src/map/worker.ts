// Computes the outcome map, coarse to fine. A new request ends the work on an older one.

import type { Shows } from '../state/state';
import init, { begin, MapSubject, OutcomeMap, Problem } from '../wasm/later/littlewood_web.js';
import {
  BLOCK,
  type EventsRequest,
  type MapAnswer,
  type MapQuestion,
  type MapRequest,
  partOf,
} from './messages';

const SUBJECT: Readonly<Record<Shows, MapSubject>> = {
  outcome: MapSubject.Outcome,
  hops: MapSubject.Hops,
};

const STRIDES = [BLOCK, 8, 4, 2, 1];

/** Milliseconds of work between two looks at the messages. */
const SLICE = 12;

let latest: MapRequest | null = null;
let working = false;

const answer = (it: MapAnswer, transfer: Transferable[] = []): void =>
  self.postMessage(it, { transfer });

/** Lets messages be handled before work goes on. A timer would wait for at least four milliseconds. */
const yieldToMessages = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });

async function work(request: MapRequest): Promise<void> {
  const problem = Problem.dimensionless(request.numbers, request.restitution, request.law);
  const map = new OutcomeMap(problem, request.rate, request.side, SUBJECT[request.shows]);
  problem.free();
  const { id, side, shows, part, of } = request;
  const isFolded = map.rows(1) < side;
  const isOurs =
    (stride: number) =>
    (row: number): boolean =>
      partOf(row * stride, side, isFolded, of) === part;
  try {
    let spent = 0;
    for (const stride of STRIDES) {
      const rows = Array.from({ length: map.rows(stride) }, (_, row) => row).filter(isOurs(stride));
      for (let next = 0; next < rows.length; ) {
        const begin = performance.now();
        do map.compute(stride, rows[next]!, rows[next++]! + 1);
        while (next < rows.length && performance.now() - begin < SLICE);
        spent += performance.now() - begin;
        await yieldToMessages();
        if (latest !== request) return;
      }
      const classes = map.classes(stride);
      const last = stride === STRIDES[STRIDES.length - 1];
      answer(
        { kind: 'level', id, shows, classes, part, isFolded, stride, milliseconds: spent, last },
        [classes.buffer],
      );
    }
  } finally {
    map.free();
  }
}

/** Sends the events of each row as soon as they are known. */
function follow({ numbers, rate, side, part, of }: EventsRequest): void {
  const problem = Problem.dimensionless(numbers);
  const map = new OutcomeMap(problem, rate, side, MapSubject.Outcome);
  problem.free();
  for (let row = part; row < side; row += of) {
    const events = map.events(row, row + 1);
    answer({ kind: 'events', row, events }, [events.buffer]);
  }
  map.free();
}

async function processRequests(): Promise<void> {
  if (working) return;
  working = true;
  try {
    for (let done: MapRequest | null = null; latest !== done; ) {
      done = latest;
      if (done) await work(done);
    }
  } catch (error) {
    answer({ kind: 'failed', message: String(error) });
  } finally {
    working = false;
  }
}

let started = false;
let following: EventsRequest | null = null;

self.onmessage = async ({ data }: MessageEvent<MapQuestion>) => {
  if (data.kind === 'map') latest = data.request;
  else if (data.kind === 'events') following = data.request;
  else {
    try {
      globalThis.littlewoodPanicked = (message) => answer({ kind: 'failed', message });
      await init({ module_or_path: data.module });
      begin();
    } catch (error) {
      answer({ kind: 'failed', message: String(error) });
      return;
    }
    started = true;
    answer({ kind: 'ready' });
  }
  if (!started) return;
  if (following !== null) {
    follow(following);
    following = null;
  }
  void processRequests();
};
