// A motion as the views read it: columns of samples, phases and events.

import { ENERGY_PARTS, type EnergyPart } from '../generated/palette';
import {
  BOUNDARY,
  CAUSE_LABELS,
  CAUSES,
  type Cause,
  IMPACT_CASE_LABELS,
  IMPACT_CASES,
  MODES,
  type Mode,
  OUTCOME_ROWS,
  OUTCOMES,
  type OutcomeKind,
  SAMPLE_COLUMNS,
  type SampleColumn,
} from '../generated/tables';
import { boundary, Motion as CoreMotion, type Problem } from './wasm';

export type Sample = Readonly<Record<SampleColumn, number>>;
export type Samples = Record<SampleColumn, Float64Array> & { length: number };

/** What one unit of (2.9) of a column is worth in the units that are shown: 1 without dimension. */
export type ColumnUnits = Readonly<Record<SampleColumn, number>>;

export interface Phase {
  mode: Mode;
  start: number;
  /** Infinite for a phase that lasts for ever. */
  end: number;
}

/** The velocities that an impact changes. */
export const VELOCITIES = [
  'theta_rate',
  'slip',
  'gap_rate',
] as const satisfies readonly SampleColumn[];
export type Velocities = Readonly<Record<(typeof VELOCITIES)[number], number>>;

/** An impact, or all those of bounces that settle, together. */
export interface Impact {
  label: string;
  before: Velocities;
  after: Velocities;
  normal: number;
  friction: number;
  /** Negative where the law has gained energy. */
  lost: number;
}

/** Routh's diagram: points are P and J, in turn. */
export interface Routh {
  way: Float64Array;
  greatestCompression: Float64Array;
  /** Least and largest P, least and largest J. */
  frame: Float64Array;
  sticking: Float64Array;
  compression: Float64Array;
}

/** A flight. */
export interface Hop {
  start: number;
  end: number;
  height: number;
}

/** Where the energy of the start is. What an impact has gained is lost below zero. */
export type Energies = Readonly<Record<EnergyPart, number>>;

export interface Event {
  time: number;
  theta: number;
  theta_rate: number;
  slip: number;
  /** The cause of a transition, an outcome that is no transition, or the start. */
  name: Cause | OutcomeKind | 'start';
  label: string;
  /** The mode that begins, or goes on; none where the motion ends. */
  to: Mode | null;
  sentence: string;
  impact: Impact | null;
  /** Its place among the transitions of the core; none where it is none of them. */
  transition: number | null;
}

/** An event at which the velocities jump. */
export type ImpactEvent = Event & { impact: Impact; transition: number };

/** The table of the phases, as the command line prints it. */
export interface Table {
  head: string[];
  rows: Row[];
  /** The columns of numbers. */
  numbers: number[];
}

export interface Row {
  mode: Mode | null;
  /** Where it begins in time; none for what is left out. */
  time: number | null;
  /** Phases that it stands for together, if they are several. */
  folds: number | null;
  cells: string[];
}

/** What the page reads of the JSON of a motion. */
interface Document {
  start: { time: number; theta: number; theta_rate: number; slip: number; mode: string | null };
  transitions: {
    time: number;
    theta: number;
    theta_rate: number | null;
    slip: number | null;
    to: string | null;
    cause: string;
    impact?: { case: string };
  }[];
  outcome: {
    kind: string;
    time: number;
    theta: number;
    theta_rate: number | null;
    slip: number | null;
  };
  phases: { mode: string; start_time: number; duration: number | null }[];
}

/** Samples for the views: for a motion of few phases, and for each phase of one with many. */
const COUNT = 400;
const PER_PHASE = 40;
const MOST = 8000;

/** Thirds by which the highest point of a flight is found: to a part of 10⁷ of the time between two samples. */
const SEARCH = 40;

/** Events of one instant that are told. */
const MOST_TOGETHER = 3;

export class Motion {
  /** As far as the motion is shown. */
  readonly phases: Phase[];
  readonly events: Event[];
  /** Those of the events that are impacts, as far as the motion is shown. */
  readonly impacts: ImpactEvent[];
  readonly outcomeSentence: string;
  readonly begin: number;
  /** Until when the motion is shown. */
  readonly end: number;
  readonly samples: Samples;
  /** Found when it is first asked for. */
  private firstHop: [Hop | null] | null = null;

  private constructor(
    private readonly core: CoreMotion,
    count: number,
  ) {
    const document = JSON.parse(core.json()) as Document;
    this.outcomeSentence = core.outcomeSentence();
    this.begin = document.start.time;
    this.end = core.horizon();
    this.phases = document.phases
      .filter((phase) => phase.start_time <= this.end)
      .map((phase) => ({
        mode: named(MODES, phase.mode),
        start: phase.start_time,
        end: phase.duration === null ? Infinity : phase.start_time + phase.duration,
      }));
    this.events = eventsOf(
      document,
      core,
      core.startSentence(),
      core.transitionSentences(),
      this.outcomeSentence,
    );
    this.impacts = this.events
      .filter((event) => isImpact(event))
      .filter((event) => event.time <= this.end);
    this.samples = this.sample(Math.min(Math.max(count, PER_PHASE * this.phases.length), MOST));
  }

  /** Simulates, with at least so many samples for the views. Throws a refusal of the core. */
  static of(problem: Problem, name: string | null, count = COUNT): Motion {
    return new Motion(new CoreMotion(problem, name), count);
  }

  /** Samples evenly spaced in time, and every transition twice. */
  sample(count: number): Samples {
    const flat = this.core.samples(count, this.end);
    const length = flat.length / SAMPLE_COLUMNS.length;
    const columns = SAMPLE_COLUMNS.map(
      (name, i) => [name, flat.subarray(i * length, (i + 1) * length)] as const,
    );
    return Object.assign(Object.fromEntries(columns) as Record<SampleColumn, Float64Array>, {
      length,
    });
  }

  /** The state at a time within the motion; none where nothing moves. */
  at(time: number): Sample | null {
    const clamped = Math.min(Math.max(time, this.begin), this.end);
    const row = this.core.at(clamped);
    return row.length === 0 ? null : byColumn(row);
  }

  /** The first flight, as far as it is shown, and how high the rim gets in it; none of a motion that stays on the plane. */
  get hop(): Hop | null {
    this.firstHop ??= [this.findHop()];
    return this.firstHop[0];
  }

  private findHop(): Hop | null {
    const flight = this.phases.find(({ mode }) => mode === 'flight');
    if (flight === undefined) return null;
    const { start, end } = flight;
    const { time, gap, length } = this.samples;
    let highest = 0;
    for (let i = 0; i < length; i++)
      if (time[i]! >= start && time[i]! <= end && gap[i]! > gap[highest]!) highest = i;
    // Between the samples beside the highest one.
    let [low, high] = [
      Math.max(start, time[highest - 1] ?? start),
      Math.min(end, time[highest + 1] ?? end),
    ];
    const at = (instant: number): number => this.at(instant)?.gap ?? 0;
    for (let step = 0; step < SEARCH; step++) {
      const third = (high - low) / 3;
      if (at(low + third) < at(high - third)) low += third;
      else high -= third;
    }
    return { start, end: Math.min(end, this.end), height: at(0.5 * (low + high)) };
  }

  /** Instants at which the rim leaves the plane. */
  get liftOffs(): number[] {
    return this.phases
      .filter(({ mode, start }) => mode === 'flight' && start > this.begin)
      .map(({ start }) => start);
  }

  /** The event that came last at a time. */
  eventAt(time: number): Event {
    let last = this.events[0]!;
    for (const event of this.events) if (event.time <= time) last = event;
    return last;
  }

  /** What there is to say at a time: of the event that came last, and of those at the same instant before it. */
  sentencesAt(time: number): string[] {
    const last = this.eventAt(time);
    // What goes on as it has begun is told once.
    const together = this.events.filter(
      (event) => event.time === last.time && (event === last || event.transition !== null),
    );
    return [...new Set(together.slice(-MOST_TOGETHER).map(({ sentence }) => sentence))];
  }

  /** Where the energy of the start is at a time; none where nothing moves. */
  energies(time: number): Energies | null {
    const parts = this.core.energies(Math.min(Math.max(time, this.begin), this.end));
    if (!parts.every(Number.isFinite) || parts.length === 0) return null;
    return Object.fromEntries(ENERGY_PARTS.map((name, i) => [name, parts[i]])) as Record<
      EnergyPart,
      number
    >;
  }

  /** The energy of the start, of which all parts are; none where nothing moves. */
  get energy(): number | null {
    const first = this.energies(this.begin);
    return first === null ? null : ENERGY_PARTS.reduce((sum, part) => sum + first[part], 0);
  }

  /** The lower and the upper end of the scale on which the parts of the energy have room. */
  get energyScale(): [number, number] {
    const [low = 0, high = 0] = this.core.energyScale();
    return [low, high];
  }

  /** The friction that rolling needs at a time; empty in another mode. */
  friction(time: number): string {
    return this.core.friction(Math.min(Math.max(time, this.begin), this.end)) ?? '';
  }

  /** Routh's diagram of an impact; none for many together. */
  routh({ transition }: ImpactEvent): Routh | null {
    const core = this.core.routh(transition);
    if (core === undefined) return null;
    const routh: Routh = {
      way: core.way(),
      greatestCompression: core.greatestCompression(),
      frame: core.frame(),
      sticking: core.lineOfSticking(),
      compression: core.lineOfCompression(),
    };
    core.free();
    return routh;
  }

  /** The landings, in order, as far as the motion is shown. */
  get landings(): Event[] {
    return this.events.filter(
      ({ name, transition, time }) => name === 'landing' && transition !== null && time <= this.end,
    );
  }

  /** The table of the phases; with `all` nothing is folded or left out. */
  table(all: boolean): Table {
    return JSON.parse(this.core.table(all)) as Table;
  }

  json(samples?: number): string {
    return this.core.json(samples);
  }

  csv(samples?: number): string {
    return this.core.csv(samples);
  }

  free(): void {
    this.core.free();
  }
}

/** The units of the columns in the system of a problem. */
export function unitsOf(problem: Problem): ColumnUnits {
  return byColumn(problem.columnUnits());
}

/** The mode of a number in the column of modes. */
export function modeOf(code: number): Mode {
  const mode = MODES[code];
  if (mode === undefined) throw new Error(`there is no mode with the code ${code}`);
  return mode;
}

/** Whether the core has the names that the page was generated with, in the same order. */
export function namesAgree(): boolean {
  return boundary() === BOUNDARY;
}

function byColumn(row: Float64Array): Record<SampleColumn, number> {
  return Object.fromEntries(SAMPLE_COLUMNS.map((name, i) => [name, row[i]])) as Record<
    SampleColumn,
    number
  >;
}

const NO_TRANSITION = { impact: null, transition: null } as const;

/** A name of the core as one of a list that the page has. */
function named<T extends string>(list: readonly T[], name: string): T {
  const found = list.find((it) => it === name);
  if (found === undefined) throw new Error(`'${name}' is none of ${list.join(', ')}`);
  return found;
}

function isImpact(event: Event): event is ImpactEvent {
  return event.impact !== null && event.transition !== null;
}

/** An impact as it is shown, from its numbers in the order of the core. */
function impactOf(name: string, numbers: Float64Array): Impact {
  const velocities = ([
    theta_rate = NaN,
    slip = NaN,
    gap_rate = NaN,
  ]: Float64Array): Velocities => ({
    theta_rate,
    slip,
    gap_rate,
  });
  const [normal = NaN, friction = NaN, lost = NaN] = numbers.subarray(6);
  return {
    label: IMPACT_CASE_LABELS[named(IMPACT_CASES, name)],
    before: velocities(numbers.subarray(0, 3)),
    after: velocities(numbers.subarray(3, 6)),
    normal,
    friction,
    lost,
  };
}

function eventsOf(
  document: Document,
  core: CoreMotion,
  first: string,
  others: string[],
  last: string,
): Event[] {
  const { start, transitions, outcome } = document;
  const modeNamed = (name: string | null): Mode | null =>
    name === null ? null : named(MODES, name);
  // JSON has no infinite numbers: a rate that is missing is infinite.
  const state = (it: Document['transitions'][number] | Document['outcome']) => ({
    time: it.time,
    theta: it.theta,
    theta_rate: it.theta_rate ?? Infinity,
    slip: it.slip ?? Infinity,
  });
  const { time, theta, theta_rate, slip } = start;
  const events: Event[] = [
    {
      time,
      theta,
      theta_rate,
      slip,
      name: 'start',
      label: 'start',
      to: modeNamed(start.mode),
      sentence: first,
      ...NO_TRANSITION,
    },
  ];
  transitions.forEach((it, i) => {
    const cause = named(CAUSES, it.cause);
    const event: Event = {
      ...state(it),
      name: cause,
      label: CAUSE_LABELS[cause],
      to: modeNamed(it.to),
      sentence: others[i]!,
      impact: null,
      transition: i,
    };
    const numbers = core.impact(i);
    events.push(
      it.impact && numbers ? { ...event, impact: impactOf(it.impact.case, numbers) } : event,
    );
  });
  const kind = named(OUTCOMES, outcome.kind);
  const { label, forever, lastEvent } = OUTCOME_ROWS[kind];
  if (lastEvent === null) {
    const mode = document.phases.at(-1)?.mode ?? null;
    const to = forever ? modeNamed(mode) : null;
    events.push({ ...state(outcome), name: kind, label, to, sentence: last, ...NO_TRANSITION });
  }
  return events;
}
