// The state of the page: everything that a link carries.

import { inOrder, LIMIT, numbersOf, type Values } from '../core/fields';
import {
  LAWS,
  type Law,
  type Quantity,
  type System,
  VIEW_CHOICES,
  VIEW_FIRST,
  type ViewKey,
} from '../generated/tables';

export type Theme = (typeof VIEW_CHOICES.theme)[number];

/** How much of the page is shown; `auto` leaves it to the device, and to what was chosen last. */
export type Level = (typeof VIEW_CHOICES.level)[number];

/** What a problem may be without. */
export interface Options {
  /** Coefficient of restitution; none where the motion ends at the landing. */
  readonly restitution: number | null;
  /** Its law; that of a coefficient alone if there is none. */
  readonly law: Law | null;
  /** Time limit in the units of the system; none to follow the motion to its end. */
  readonly until: number | null;
}

interface ProblemIn<S extends System> extends Options {
  readonly system: S;
  readonly values: Values<S>;
}

export type ProblemState = ProblemIn<'dimensionless'> | ProblemIn<'si'>;

/** What the map shows of each motion. */
export const SHOWS = VIEW_CHOICES.shows;
export type Shows = (typeof SHOWS)[number];

export interface ViewState {
  /** Time of the cursor, τ; none at the start. */
  time: number | null;
  speed: number;
  /** Whether it plays slowly around a lift-off. */
  slow: boolean;
  loop: boolean;
  /** Largest |θ′| of the plane. */
  rate: number;
  map: boolean;
  shows: Shows;
  follow: boolean;
  /** Whether symbols stand at what is drawn, and at the fields. */
  symbols: boolean;
  level: Level;
  /** Whether the page is a frame in another one: the hoop and its time line alone. */
  embed: boolean;
  theme: Theme;
}

export interface State {
  problem: ProblemState;
  view: ViewState;
}

export const SPEEDS: readonly number[] = VIEW_CHOICES.speed.map(Number);
export const RATES: readonly number[] = VIEW_CHOICES.rate.map(Number);

/** The view of the texts of a link. */
export function viewOf(texts: Readonly<Record<ViewKey, string>>): ViewState {
  const { rate, speed, slow, loop, map, shows, follow, symbols, level, embed, theme } = texts;
  return {
    time: null,
    rate: Number(rate),
    speed: Number(speed),
    slow: slow === '1',
    loop: loop === '1',
    map: map === '1',
    shows: shows as Shows,
    follow: follow === '1',
    symbols: symbols === '1',
    level: level as Level,
    embed: embed === '1',
    theme: theme as Theme,
  };
}

/** The texts of a view in a link. */
export function textsOf({
  rate,
  speed,
  slow,
  loop,
  map,
  shows,
  follow,
  symbols,
  level,
  embed,
  theme,
}: ViewState): Record<ViewKey, string> {
  const flag = (it: boolean): string => (it ? '1' : '0');
  return {
    rate: String(rate),
    speed: String(speed),
    slow: flag(slow),
    loop: flag(loop),
    map: flag(map),
    shows,
    follow: flag(follow),
    symbols: flag(symbols),
    level,
    embed: flag(embed),
    theme,
  };
}

export const VIEW: Readonly<ViewState> = viewOf(VIEW_FIRST);

/** A problem with a value for each number of its system. */
export function problemWith(
  system: System,
  value: (quantity: Quantity) => number,
  options: Options,
): ProblemState {
  const values = Object.fromEntries(numbersOf(system).map((name) => [name, value(name)]));
  const { restitution, law, until } = options;
  return { system, values, restitution, law, until } as unknown as ProblemState;
}

/** The value of a quantity of a problem; none for one that is left out, and for a quantity of the other system. */
export function numberOf(
  { system, values, restitution, until }: ProblemState,
  quantity: Quantity,
): number | null {
  if (quantity === LIMIT[system]) return until;
  if (quantity === 'restitution') return restitution;
  const numbers: Readonly<Partial<Record<Quantity, number>>> = values;
  return numbers[quantity] ?? null;
}

/** The numbers of a problem in the order of the core. */
export function numbersOfProblem(problem: ProblemState): Float64Array {
  return problem.system === 'si'
    ? inOrder('si', problem.values)
    : inOrder('dimensionless', problem.values);
}

/** A problem of a part of the core. Throws a refusal of the core. */
export function problemIn<P>(
  core: Record<
    System,
    (numbers: Float64Array, restitution: number | null, law: Law | null, until: number | null) => P
  >,
  problem: ProblemState,
): P {
  const { system, restitution, law, until } = problem;
  return core[system](numbersOfProblem(problem), restitution, law, until);
}

/** The law by which a problem bounces; none where its motion ends at the landing. */
export function lawOf({ restitution, law }: Options): Law | null {
  return restitution === null ? null : (law ?? LAWS[0]);
}

/** A case of the core. */
export interface NamedCase {
  name: string;
  title: string;
  source: string;
}

/** The rate that shows a problem well: massless hoops live below θ′ = 1. */
export function rateFor(massless: boolean, rate: number): number {
  const least = massless ? 1.5 : 4;
  return RATES.find((it) => it >= least && it >= 1.1 * Math.abs(rate)) ?? RATES[RATES.length - 1]!;
}

/** The rate that shows a problem without dimension. */
export function rateOf(problem: ProblemState): number {
  const isMassless = numberOf(problem, 'inertia') === 0 && numberOf(problem, 'mass_ratio') === 0;
  return rateFor(isMassless, numberOf(problem, 'theta_rate') ?? 0);
}
