// The same bits natively, in WebAssembly, and from the command line.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import * as core from '../src/wasm/first/littlewood_web.js';
import { open } from './lab';

const MASK = (1n << 64n) - 1n;

function hash(content: string | Uint8Array): string {
  let hash = 0xcbf29ce484222325n;
  for (const byte of typeof content === 'string' ? new TextEncoder().encode(content) : content)
    hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & MASK;
  return hash.toString(16).padStart(16, '0');
}

function bitsOf(number: number): bigint {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, number);
  return view.getBigUint64(0);
}

function double(bits: string): number {
  const view = new DataView(new ArrayBuffer(8));
  view.setBigUint64(0, BigInt(`0x${bits}`));
  return view.getFloat64(0);
}

/** The bits of what only the page shows: the ways of the impacts, and where the energy is at the end. */
function pictures(motion: core.Motion): Uint8Array {
  const ways = motion.transitionSentences().flatMap((_, i) => [...(motion.routh(i)?.way() ?? [])]);
  const numbers = [...ways, ...motion.energies(motion.horizon())];
  const view = new DataView(new ArrayBuffer(8 * numbers.length));
  // There is one NaN.
  for (const [i, number] of numbers.entries())
    view.setBigUint64(8 * i, Number.isNaN(number) ? 0x7ff8000000000000n : bitsOf(number));
  return new Uint8Array(view.buffer);
}

test('the named cases and a thousand random starts have the same bits natively and in WebAssembly', {
  tag: '@thorough',
}, () => {
  // Written by `cargo run -p littlewood-web --example bits`.
  const lines = readFileSync(new URL('../bits.txt', import.meta.url), 'utf8')
    .trim()
    .split('\n');
  const cases = lines.map((line) => line.split(' ')[0]).filter((name) => name !== '-');
  expect(lines).toHaveLength(1000 + cases.length);
  expect(cases).toContain('figure-3-bounces');
  core.initSync({
    module: readFileSync(new URL('../src/wasm/first/littlewood_web_bg.wasm', import.meta.url)),
  });
  for (const line of lines) {
    const [name, ...words] = line.split(' ');
    const given = (word = '-'): string | undefined => (word === '-' ? undefined : word);
    const number = (word?: string): number | undefined =>
      given(word) === undefined ? undefined : double(word!);
    const [restitution, law, until, ...hashes] = words.slice(-6);
    const numbers = Float64Array.from(words.slice(0, -6), double);
    const problem = core.Problem.dimensionless(
      numbers,
      number(restitution),
      given(law),
      number(until),
    );
    const motion = new core.Motion(problem, given(name));
    expect([hash(motion.json(20)), hash(motion.csv()), hash(pictures(motion))], line).toEqual(
      hashes,
    );
    motion.free();
    problem.free();
  }
});

const program = process.env.LITTLEWOOD ?? '';

test('what the page saves is what the command line prints', async ({ page }) => {
  test.skip(!existsSync(program), 'LITTLEWOOD names no program');
  const save = async (button: string): Promise<string> => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator(button).click(),
    ]);
    return readFileSync(await download.path(), 'utf8');
  };
  for (const state of [
    'case=figure-3',
    'case=figure-7',
    'case=painleve',
    'case=stick-slip-no-jump',
    'case=figure-3-bounces',
    'case=jam',
    'case=bounces-forever&mass_ratio=1.5&until=20',
    'case=figure-3&gap_rate=0.5&restitution=0.4&restitution_law=newton',
    'mass_ratio=0.3&offset=0.9&inertia=0.2&mu_s=0.45&mu_k=0.31&theta=-1.234567890123456&theta_rate=2.2&slip=0.1&until=5',
    'disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081&mu_s=0.5&mu_k=0.4&theta=1.2&theta_rate_rad_per_s=6',
    'disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081&mu_s=0.5&mu_k=0.4&theta=1.2&theta_rate_rad_per_s=12&gap_rate_m_per_s=0.7&restitution=0.6&restitution_law=poisson',
  ]) {
    await open(page, state);
    await page.reload();
    await page.locator('#open-share').click();
    const line = await page.locator('#shell-text').inputValue();
    const [name, ...flags] = line.split(' ');
    expect(name).toBe('littlewood');
    const run = (...more: string[]): string =>
      execFileSync(program, [...flags, ...more], { encoding: 'utf8', maxBuffer: 1 << 27 });
    expect(await save('#save-json')).toBe(run('--format', 'json', '--samples', '400'));
    expect(await save('#save-csv')).toBe(run('--format', 'csv', '--samples', '400'));
    await page.locator('#samples').fill('');
    expect(await save('#save-json')).toBe(run('--format', 'json'));
    expect(await save('#save-csv')).toBe(run('--format', 'csv'));
  }
});
