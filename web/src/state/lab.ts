// The laboratory: the last good state, the motion that it has, and who wants to know of changes.

import { fieldOfQuantity, fieldsOf, indexOf, type System } from '../core/fields';
import { Motion } from '../core/motion';
import { Problem, Refusal } from '../core/wasm';
import { caseOfProblem, type NamedCase, type ProblemState, type State, type ViewState } from './state';
import type { Scales } from '../views/plots';
import type { Complaint } from './url';

/** What has changed: the hoop or the slip (new curves, new map), the motion, the time of the cursor, the view. */
export type Change = 'hoop' | 'motion' | 'time' | 'view' | 'complaints';

type Listener = (changes: ReadonlySet<Change>) => void;

export class Lab {
  state: State;
  motion: Motion;
  problem: Problem;
  complaints: Complaint[] = [];
  private readonly listeners: Listener[] = [];

  constructor(initial: State, readonly cases: readonly NamedCase[]) {
    this.state = initial;
    this.problem = problemOf(initial.problem);
    this.motion = Motion.of(this.problem, this.caseName(initial.problem));
  }

  onChange(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Tells everything, to those who have just come. */
  announce(): void {
    this.tell('motion', 'time', 'view', 'complaints');
  }

  private tell(...changes: Change[]): void {
    const set = new Set(changes);
    for (const listener of this.listeners) listener(set);
  }

  private caseName(problem: ProblemState): string | null {
    return caseOfProblem(problem, this.cases)?.name ?? null;
  }

  /** Name of the case that is shown, if it is one. */
  get named(): string | null {
    return this.caseName(this.state.problem);
  }

  /** The dimensionless numbers of the problem. */
  get plain(): Float64Array {
    return this.problem.toDimensionless();
  }

  /** Time of the cursor. */
  get time(): number {
    return this.state.view.time ?? this.motion.begin;
  }

  /** Takes another problem, or complains and stays. The cursor goes to the start unless it is to stay. */
  take(next: ProblemState, view: Partial<ViewState> = {}, complaints: Complaint[] = []): boolean {
    const before = this.problem;
    try {
      const problem = problemOf(next);
      const motion = Motion.of(problem, this.caseName(next));
      this.motion.free();
      this.motion = motion;
      this.problem = problem;
    } catch (refusal) {
      if (!(refusal instanceof Refusal)) throw refusal;
      this.complaints = [...complaints, complaintOf(refusal, next)];
      if (Object.keys(view).length > 0) this.state = { ...this.state, view: { ...this.state.view, ...view, time: null } };
      this.tell('complaints', 'view');
      return false;
    }
    this.state = { problem: next, view: { ...this.state.view, time: null, ...view } };
    this.complaints = complaints;
    const changes: Change[] = ['motion', 'time', 'view', 'complaints'];
    if (!sameHoop(before, this.problem)) changes.push('hoop');
    before.free();
    this.clampTime();
    this.tell(...changes);
    return true;
  }

  /** Sets some numbers by name. */
  set(values: Record<string, number>, view: Partial<ViewState> = {}): boolean {
    const { system, numbers, until } = this.state.problem;
    const next = [...numbers];
    for (const [name, value] of Object.entries(values)) next[indexOf(system, name)] = value;
    return this.take({ system, numbers: next, until }, view);
  }

  /** Sets θ and θ′ without dimension, in whichever units the problem is. */
  setStart(theta: number, rate: number): boolean {
    if (this.state.problem.system === 'dimensionless') return this.set({ theta, theta_rate: rate });
    const [, m2, radius, , , gravity] = this.state.problem.numbers;
    const plain = this.plain;
    plain[5] = theta;
    plain[6] = rate;
    const moved = Problem.dimensionless(plain);
    const si = moved.toSi(m2!, radius!, gravity!);
    moved.free();
    return this.set({ theta, theta_rate_rad_per_s: si[9]! });
  }

  setUntil(until: number | null): boolean {
    return this.take({ ...this.state.problem, until });
  }

  /** Shows the same problem in the other units. In SI units a new problem has the hula hoop's size. */
  setSystem(system: System): void {
    const { problem } = this.state;
    if (problem.system === system) return;
    const view = { time: this.state.view.time };
    if (system === 'dimensionless') {
      const unit = this.timeUnit;
      const until = problem.until === null ? null : problem.until / unit;
      this.take({ system, numbers: [...this.plain], until }, view);
    } else {
      const numbers = [...this.problem.toSi(0.14, 0.45, 9.80665)];
      const unit = Math.sqrt(0.45 / 9.80665);
      this.take({ system, numbers, until: problem.until === null ? null : problem.until * unit }, view);
    }
  }

  /** √(R/g) in seconds; 1 without dimension. */
  get timeUnit(): number {
    if (this.state.problem.system === 'dimensionless') return 1;
    const [, , radius, , , gravity] = this.state.problem.numbers;
    return Math.sqrt(radius! / gravity!);
  }

  /** What dimensionless values are worth in the units that are shown (2.9). */
  get scales(): Scales {
    if (this.state.problem.system === 'dimensionless') return { time: 1, rate: 1, velocity: 1, force: 1, energy: 1 };
    const [, m2, radius, , , gravity] = this.state.problem.numbers as [number, number, number, number, number, number];
    const time = this.timeUnit;
    return { time, rate: 1 / time, velocity: radius / time, force: m2 * gravity, energy: m2 * gravity * radius };
  }

  setTime(time: number): void {
    this.state = { ...this.state, view: { ...this.state.view, time } };
    this.clampTime();
    this.tell('time');
  }

  setView(view: Partial<ViewState>): void {
    this.state = { ...this.state, view: { ...this.state.view, ...view } };
    this.tell('view');
  }

  /** A message about a field that could not be read. */
  complain(complaint: Complaint): void {
    this.complaints = [complaint];
    this.tell('complaints');
  }

  private clampTime(): void {
    const { time } = this.state.view;
    if (time === null) return;
    const clamped = Math.min(Math.max(time, this.motion.begin), this.motion.end);
    this.state = { ...this.state, view: { ...this.state.view, time: clamped <= this.motion.begin ? null : clamped } };
  }
}

/** Throws a refusal of the core. */
function problemOf({ system, numbers, until }: ProblemState): Problem {
  const values = Float64Array.from(numbers);
  return system === 'si' ? Problem.si(values, until) : Problem.dimensionless(values, until);
}

function complaintOf(refusal: Refusal, { system, numbers, until }: ProblemState): Complaint {
  const field = fieldOfQuantity(system, refusal.quantity);
  const index = indexOf(system, field);
  const given = index >= 0 ? numbers[index] : until;
  const { message, hint } = refusal;
  refusal.free();
  return { field: fieldsOf(system)[index]?.name ?? field, given: String(given ?? ''), message: `${message}: ${hint}` };
}

/** Whether two problems have the same curves and the same map. */
function sameHoop(a: Problem, b: Problem): boolean {
  const [p, q] = [a.toDimensionless(), b.toDimensionless()];
  return [0, 1, 2, 3, 4, 7].every((i) => Object.is(p[i], q[i]));
}
