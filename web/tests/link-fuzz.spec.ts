// Random links: whatever stands behind the `#`, reading it throws nothing, leaves a state that the page can show, and says
// what it could not read. LITTLEWOOD_FUZZ_SECONDS and LITTLEWOOD_FUZZ_SEED say how long, and which.

import { expect, test } from '@playwright/test';
import { QUANTITIES, QUANTITY_ROWS } from '../src/generated/tables';
import { format, parse } from '../src/state/url';
import { problemOfCase, RATES, SHOWS, SPEEDS, VIEW, type NamedCase, type State } from '../src/state/state';

const SECONDS = Number(process.env.LITTLEWOOD_FUZZ_SECONDS ?? 1);
const SEED = Number(process.env.LITTLEWOOD_FUZZ_SEED ?? 2019);

const FIGURE_3: NamedCase = {
  name: 'figure-3', title: '', source: '', law: null,
  hoop: { mass_ratio: 1, offset: 1, inertia: 1, mu_s: 0.5, mu_k: 0.4 },
  start: { theta: Math.PI / 2, theta_rate: 2, slip: 0 },
};
const BASE: State = { problem: problemOfCase(FIGURE_3), view: { ...VIEW } };

const KEYS = [...QUANTITIES, 'case', 'restitution_law', 'at', 'rate', 'speed', 'loop', 'map', 'shows', 'follow', 'embed', 'theme', ''];
const VALUES = [
  '0', '-0', '1', '0.4', '1e9', '1e-320', '5e-324', '1e400', '-1e400', 'nan', 'Infinity', '', ' 2 ', '−1', '0x10', '1_0', '+.5', '1.',
  '.', 'e5', 'figure-3', 'newton', 'poisson', 'hops', 'light', 'true', '%', '%zz', '%2D1', '%F0%9F', '=', '1=2', '<b>', '💥', '__proto__',
];

/** Mulberry32. */
function random(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 15), z | 1);
    z ^= z + Math.imul(z ^ (z >>> 7), z | 61);
    return ((z ^ (z >>> 14)) >>> 0) / 2 ** 32;
  };
}

function linkOf(share: () => number): string {
  const one = <T>(items: readonly T[]): T => items[Math.floor(share() * items.length)]!;
  const value = (): string => (share() < 0.5 ? one(VALUES) : String((share() - 0.3) * 10 ** Math.floor(share() * 40 - 20)));
  const count = Math.floor(share() * 12);
  let link = Array.from({ length: count }, () => `${one(KEYS)}=${value()}`).join(one(['&', '&', '&', '&&', ';']));
  while (share() < 0.3) {
    const at = Math.floor(share() * (link.length + 1));
    const junk = String.fromCharCode(Math.floor(share() * (share() < 0.8 ? 128 : 0x10000)));
    link = link.slice(0, at) + junk + link.slice(at + Math.floor(share() * 3));
  }
  return share() < 0.5 ? `#${link}` : link;
}

/** Playwright's own expectations take a thousand times as long as what they are about. */
function must(holds: boolean, what: string): void {
  if (!holds) throw new Error(what);
}

function check(link: string): void {
  const { state, fieldErrors } = parse(link, BASE, [FIGURE_3]);
  must(fieldErrors.every(({ message }) => message !== ''), 'an error without a message');
  const { problem, view } = state;
  must((RATES as readonly number[]).includes(view.rate), `rate ${view.rate}`);
  must((SPEEDS as readonly number[]).includes(view.speed), `speed ${view.speed}`);
  must(SHOWS.includes(view.shows), `shows ${view.shows}`);
  must(view.time === null || Number.isFinite(view.time), `time ${view.time}`);
  for (const [name, number] of Object.entries(problem.values)) {
    // What the link does not give and nothing else does is reported.
    const isReported = fieldErrors.some(({ field }) => field === name);
    must(Number.isFinite(number) || isReported, `${name} = ${number}`);
    must(name in QUANTITY_ROWS, name);
  }
  if (fieldErrors.length > 0) return;
  // A link that says it all says the same again.
  const whole = format(state, [FIGURE_3]);
  const again = parse(whole, BASE, [FIGURE_3]);
  must(again.fieldErrors.length === 0, `refused again: ${whole}`);
  must(format(again.state, [FIGURE_3]) === whole, `says something else again: ${whole}`);
}

test('no link is too strange', () => {
  test.setTimeout(1000 * (SECONDS + 30));
  const share = random(SEED);
  const end = Date.now() + 1000 * SECONDS;
  let links = 0;
  while (Date.now() < end) {
    const link = linkOf(share);
    try {
      check(link);
    } catch (error) {
      throw new Error(`the link ${JSON.stringify(link)}`, { cause: error });
    }
    links += 1;
  }
  console.log(`${links} links, seed ${SEED}`);
  expect(links).toBeGreaterThan(0);
});
