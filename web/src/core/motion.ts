// A motion as the views read it: columns of samples, phases and events.

import { Motion as CoreMotion, sampleColumns, type Problem } from './wasm';

export const MODES = ['rolling', 'sliding', 'gliding', 'flight'] as const;
export type Mode = (typeof MODES)[number];

const NAMES = [
  'time', 'mode', 'direction', 'theta', 'theta_rate', 'slip', 'x', 'theta_acceleration', 'slip_acceleration', 'normal',
  'friction', 'gap', 'gap_rate', 'energy', 'centre_y', 'mass_centre_x', 'mass_centre_y', 'particle_x', 'particle_y',
] as const;
export type Column = (typeof NAMES)[number];
export type Sample = Record<Column, number>;
export type Samples = Record<Column, Float64Array> & { length: number };

export interface Phase {
  mode: Mode;
  direction: number;
  start: number;
  /** Infinite for a phase that lasts for ever. */
  end: number;
}

export interface Event {
  time: number;
  theta: number;
  theta_rate: number;
  slip: number;
  /** Name of the cause, or `start`, or the kind of an outcome that is no event. */
  cause: string;
  from: Mode | null;
  to: Mode | null;
  sentence: string;
}

interface Document {
  start: { time: number; theta: number; theta_rate: number; slip: number; mode: Mode | null };
  transitions: { time: number; theta: number; theta_rate: number | null; slip: number | null; from: Mode;
    to: Mode | null; cause: string }[];
  outcome: { kind: string; time: number; theta: number; theta_rate: number | null; slip: number | null };
  phases: { mode: Mode; direction: number; start_time: number; duration: number | null }[];
  energy_lost: number;
}

/** Outcomes that are the last transition. */
const EVENTS = new Set(['landing', 'particle_at_plane', 'particle_at_bottom', 'particle_at_top', 'singular']);

/** Samples for the views: for a motion of few phases, and for each phase of one with many. */
const COUNT = 400;
const PER_PHASE = 40;
const MOST = 8000;

export class Motion {
  readonly phases: Phase[];
  readonly events: Event[];
  readonly outcome: string;
  readonly outcomeSentence: string;
  readonly begin: number;
  /** Until when the motion is shown. */
  readonly end: number;
  readonly samples: Samples;

  private constructor(private readonly core: CoreMotion) {
    const document = JSON.parse(core.json()) as Document;
    this.outcome = document.outcome.kind;
    this.outcomeSentence = core.outcomeSentence();
    this.begin = document.start.time;
    this.end = core.horizon();
    this.phases = document.phases.map((phase) => ({
      mode: phase.mode,
      direction: phase.direction,
      start: phase.start_time,
      end: phase.duration === null ? Infinity : phase.start_time + phase.duration,
    }));
    this.events = eventsOf(document, core.startSentence(), core.transitionSentences(), this.outcomeSentence);
    this.samples = this.sample(Math.min(Math.max(COUNT, PER_PHASE * this.phases.length), MOST));
  }

  /** Simulates. Throws a refusal of the core. */
  static of(problem: Problem, name: string | null): Motion {
    return new Motion(new CoreMotion(problem, name));
  }

  /** Samples evenly spaced in time, and every transition twice. */
  sample(count: number): Samples {
    const flat = this.core.samples(count, this.end);
    const length = flat.length / NAMES.length;
    const samples = { length } as Samples;
    NAMES.forEach((name, i) => {
      samples[name] = flat.subarray(i * length, (i + 1) * length);
    });
    return samples;
  }

  /** The state at a time within the motion; none where nothing moves. */
  at(time: number): Sample | null {
    const clamped = Math.min(Math.max(time, this.begin), this.end);
    const row = this.core.at(clamped);
    if (row.length === 0) return null;
    return Object.fromEntries(NAMES.map((name, i) => [name, row[i]])) as Sample;
  }

  /** The event that came last at a time. */
  eventAt(time: number): Event {
    let last = this.events[0]!;
    for (const event of this.events) if (event.time <= time) last = event;
    return last;
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

function eventsOf(document: Document, first: string, others: string[], last: string): Event[] {
  const { start, transitions, outcome } = document;
  const events: Event[] = [
    { time: start.time, theta: start.theta, theta_rate: start.theta_rate, slip: start.slip, cause: 'start', from: null,
      to: start.mode, sentence: first },
  ];
  transitions.forEach((it, i) => {
    events.push({ ...it, theta_rate: it.theta_rate ?? Infinity, slip: it.slip ?? Infinity, sentence: others[i] ?? '' });
  });
  if (!EVENTS.has(outcome.kind)) {
    const mode = document.phases.at(-1)?.mode ?? null;
    const forever = outcome.kind.endsWith('_forever');
    events.push({ ...outcome, theta_rate: outcome.theta_rate ?? Infinity, slip: outcome.slip ?? Infinity,
      cause: outcome.kind, from: mode, to: forever ? mode : null, sentence: last });
  }
  return events;
}

/** Whether the columns of the core are those that are named here. */
export function columnsAgree(): boolean {
  return sampleColumns().join() === NAMES.join();
}
