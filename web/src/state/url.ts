// The state as the fragment of an address, and back. Numbers are written with as many digits as it takes to read the
// same number again.

import { LIMIT, numbersOf } from '../core/fields';
import { LAWS, QUANTITIES, QUANTITY_ROWS, type Quantity, type System } from '../generated/tables';
import {
  caseOfProblem, lawOf, problemOfCase, problemWith, RATES, SHOWS, SPEEDS, valueOf, VIEW, type NamedCase, type State,
  type Theme,
} from './state';

export interface FieldError {
  /** The field, or the key of the address. */
  field: string;
  /** What was given. */
  given: string;
  message: string;
}

export interface Parsed {
  state: State;
  fieldErrors: FieldError[];
}

/** The key of the law of restitution. */
const LAW = 'restitution_law';

/** The fragment for a state, without `#`. */
export function format(state: State, cases: readonly NamedCase[]): string {
  const { problem, view } = state;
  const parts: string[] = [];
  const named = caseOfProblem(problem, cases);
  if (named) {
    parts.push(`case=${named.name}`);
  } else {
    for (const name of numbersOf(problem.system)) parts.push(`${name}=${written(valueOf(problem, name))}`);
    if (problem.restitution !== null) parts.push(`restitution=${written(problem.restitution)}`, `${LAW}=${lawOf(problem)}`);
    if (problem.until !== null) parts.push(`${LIMIT[problem.system]}=${written(problem.until)}`);
  }
  if (view.time !== null) parts.push(`at=${written(view.time)}`);
  if (view.rate !== VIEW.rate) parts.push(`rate=${view.rate}`);
  if (view.speed !== VIEW.speed) parts.push(`speed=${view.speed}`);
  if (view.loop) parts.push('loop=1');
  if (!view.map) parts.push('map=0');
  if (view.shows !== VIEW.shows) parts.push(`shows=${view.shows}`);
  if (!view.follow) parts.push('follow=0');
  if (view.embed) parts.push('embed=1');
  if (view.theme !== 'auto') parts.push(`theme=${view.theme}`);
  return parts.join('&');
}

/** A number such that the same is read again; the language leaves out the sign of a zero. */
function written(number: number | null): string {
  return Object.is(number, -0) ? '-0' : String(number);
}

/** Reads a fragment. What it does not say stays as in `base`; what cannot be read is reported and stays, too. */
export function parse(fragment: string, base: State, cases: readonly NamedCase[]): Parsed {
  const given = new Map<string, string>();
  const fieldErrors: FieldError[] = [];
  const text = fragment.replace(/^#/, '');
  for (const part of text === '' ? [] : text.split('&')) {
    const [key = '', value = ''] = part.split(/=(.*)/s).map(decode);
    given.set(key, value);
  }
  const take = (key: string): string | undefined => {
    const value = given.get(key);
    given.delete(key);
    return value;
  };
  const report = (field: string, value: string, message: string): void => {
    fieldErrors.push({ field, given: value, message });
  };

  let problem = base.problem;
  const name = take('case');
  if (name !== undefined) {
    const named = cases.find((it) => it.name === name);
    if (named) problem = problemOfCase(named);
    else report('case', name, `there is no case named '${name}'`);
  }
  const system = systemOf(given.keys());
  if (system !== null) {
    const shown = problem;
    // What the link does not say stays, unless that is in the other units.
    const otherwise = (quantity: Quantity): number | null =>
      (system === shown.system ? valueOf(shown, quantity) : QUANTITY_ROWS[quantity].otherwise);
    const read = (quantity: Quantity): number => {
      const text = take(quantity);
      const number = text === undefined ? null : readNumber(text);
      if (text !== undefined && number === null) report(quantity, text, `'${text}' is not a number`);
      if (text === undefined && otherwise(quantity) === null) report(quantity, '', 'the link does not give it');
      return number ?? otherwise(quantity) ?? NaN;
    };
    const option = (quantity: Quantity): number | null => {
      const text = take(quantity);
      const number = text === undefined ? null : readNumber(text);
      if (text !== undefined && number === null) report(quantity, text, `'${text}' is not a number`);
      return number;
    };
    // What may be left out is left out, unless a case has it.
    const ofCase = name === undefined ? null : shown;
    const given = take(LAW);
    const law = LAWS.find((it) => it === given) ?? null;
    if (given !== undefined && law === null) report(LAW, given, `one of ${LAWS.join(', ')}`);
    problem = problemWith(system, read, {
      restitution: option('restitution') ?? ofCase?.restitution ?? null,
      law: law ?? ofCase?.law ?? null,
      until: option(LIMIT[system]),
    });
  }

  const view = { ...VIEW, theme: base.view.theme };
  const number = (key: string, fits: (value: number) => boolean, what: string): number | undefined => {
    const value = take(key);
    if (value === undefined) return undefined;
    const read = readNumber(value);
    if (read !== null && fits(read)) return read;
    report(key, value, what);
    return undefined;
  };
  view.time = number('at', Number.isFinite, 'a time is a number') ?? null;
  view.rate = number('rate', (it) => (RATES as readonly number[]).includes(it), `one of ${RATES.join(', ')}`) ?? view.rate;
  view.speed =
    number('speed', (it) => (SPEEDS as readonly number[]).includes(it), `one of ${SPEEDS.join(', ')}`) ?? view.speed;
  const flag = (key: string, otherwise: boolean): boolean => {
    const value = take(key);
    if (value === undefined) return otherwise;
    if (value === '0' || value === '1') return value === '1';
    report(key, value, '0 or 1');
    return otherwise;
  };
  view.loop = flag('loop', view.loop);
  view.map = flag('map', view.map);
  const shows = take('shows');
  const subject = SHOWS.find((it) => it === shows);
  if (subject !== undefined) view.shows = subject;
  else if (shows !== undefined) report('shows', shows, `one of ${SHOWS.join(', ')}`);
  view.follow = flag('follow', view.follow);
  view.embed = flag('embed', view.embed);
  const theme = take('theme');
  if (theme === 'light' || theme === 'dark' || theme === 'auto') view.theme = theme satisfies Theme;
  else if (theme !== undefined) report('theme', theme, 'light, dark or auto');
  for (const [key, value] of given) report(key, value, 'is not known');
  return { state: { problem, view }, fieldErrors };
}

/** The system that the keys belong to; none if they say nothing of the problem. */
function systemOf(keys: Iterable<string>): System | null {
  const names = new Set(keys);
  if (names.has(LAW)) names.add('restitution');
  const given = QUANTITIES.filter((it) => names.has(it));
  if (given.some((it) => QUANTITY_ROWS[it].system === 'si')) return 'si';
  return given.length > 0 ? 'dimensionless' : null;
}

/** A number as people and programs write it; none for anything else, also for what is not finite. */
export function readNumber(text: string): number | null {
  const plain = text.trim().replace('−', '-');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const number = Number(plain);
  return Number.isFinite(number) ? number : null;
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
