// The laboratory: the last valid state, its motion, and the listeners to changes.

import { type Ghost, ghostOf, type Prediction, predictionOf } from '../core/derivatives';
import {
  HULA_HOOP,
  inOrder,
  inSigns,
  inSystem,
  LIMIT,
  quantityNamed,
  type Values,
  valuesOf,
} from '../core/fields';
import { type ColumnUnits, type Event, type ImpactEvent, Motion, unitsOf } from '../core/motion';
import { classIn } from '../core/threshold';
import { Problem, Refusal } from '../core/wasm';
import {
  type Class,
  DIMENSIONLESS,
  type DimensionlessNumber,
  type Law,
  QUANTITIES,
  QUANTITY_ROWS,
  type Quantity,
  type System,
} from '../generated/tables';

import {
  lawOf,
  type NamedCase,
  numberOf,
  type ProblemState,
  problemIn,
  problemWith,
  type State,
  type ViewState,
} from './state';
import { caseOf, type FieldError } from './url';

/** What has changed: the hoop, the slip or the rate of the gap (new curves, new map), the motion, the time of the cursor, the view, a drag that has ended. */
export type Change = 'hoop' | 'motion' | 'time' | 'view' | 'errors' | 'drag';

/** Values of quantities; that of a coefficient of restitution may be none. */
export type Given = Partial<Record<Exclude<Quantity, 'restitution'>, number>> & {
  restitution?: number | null;
};

/** The next landing of a motion that is dragged, predicted from before the drag, or why it cannot be; and the exact one, if there is one. */
export interface Landing {
  predicted: Ghost | string;
  exact: Event | null;
}

type Listener = (changes: ReadonlySet<Change>) => void;

export class Lab {
  state: State;
  motion: Motion;
  problem: Problem;
  /** What dimensionless values are worth in the units that are shown. */
  units: ColumnUnits;
  fieldErrors: FieldError[] = [];
  /** A motion to compare with, in the units of its problem. */
  pinned: { problem: ProblemState; motion: Motion } | null = null;
  /** Whether what comes is to be guessed, and is not shown. */
  isSecret = false;
  /** Whether a lesson hides the arrows. */
  hidesArrows = false;
  /** Whether something is being dragged. */
  held = false;
  /** What was known before the drag: of which landing, and what the derivatives say of it. */
  private before: { landing: number; prediction: Prediction } | null = null;
  private readonly listeners: Listener[] = [];

  constructor(
    initial: State,
    readonly cases: readonly NamedCase[],
  ) {
    this.state = initial;
    this.problem = checked(initial.problem);
    this.units = unitsOf(this.problem);
    this.motion = Motion.of(this.problem, caseOf(initial.problem));
  }

  onChange(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Reports everything as changed, for listeners that have just been added. */
  announce(): void {
    this.notify('motion', 'time', 'view', 'errors');
  }

  private notify(...changes: Change[]): void {
    const set = new Set(changes);
    for (const listener of this.listeners) listener(set);
  }

  /** Name of the case that is shown, if it is one. */
  get named(): string | null {
    return caseOf(this.state.problem);
  }

  /** The problem without dimension, in whichever units it is shown. */
  get plain(): Values<'dimensionless'> {
    return valuesOf('dimensionless', this.problem.toDimensionless());
  }

  /** The impact that is shown: the last one up to the cursor, or the first. */
  get impact(): ImpactEvent | null {
    const {
      time,
      motion: { impacts },
    } = this;
    return impacts.findLast((event) => event.time <= time) ?? impacts[0] ?? null;
  }

  /** Pins a problem, to compare others with it; none takes the pin away. Returns what is wrong with it. */
  pin(problem: ProblemState | null): FieldError[] {
    this.pinned?.motion.free();
    this.pinned = null;
    const errors: FieldError[] = [];
    try {
      if (problem !== null) {
        const core = checked(problem);
        this.pinned = { problem, motion: Motion.of(core, caseOf(problem)) };
        core.free();
      }
    } catch (refusal) {
      if (!(refusal instanceof Refusal) || problem === null) throw refusal;
      errors.push(fieldErrorOf(refusal, problem));
    }
    this.notify('motion');
    return errors;
  }

  /** A drag begins: what follows is compared with what was before. */
  hold(): void {
    this.held = true;
  }

  /** A drag ends. */
  release(): void {
    if (!this.held) return;
    this.held = false;
    this.before?.prediction.free();
    this.before = null;
    this.notify('drag');
  }

  private remember(): void {
    if (this.before !== null) return;
    const { landings } = this.motion;
    const next = landings.findIndex((it) => it.time > this.time);
    const landing = Math.max(next, 0);
    const prediction =
      landings[landing] === undefined ? null : predictionOf(this.state.problem, landings[landing]);
    if (prediction !== null) this.before = { landing, prediction };
  }

  /** The landing of a motion that is dragged. */
  get landing(): Landing | null {
    if (this.before === null) return null;
    const { landing, prediction } = this.before;
    const predicted = ghostOf(prediction, this.state.problem);
    if (predicted === null) return null;
    return {
      predicted,
      exact: this.motion.landings[landing] ?? null,
    };
  }

  /** The transition that is shown: the last one up to the cursor, or the first. */
  get transition(): Event | null {
    const transitions = this.motion.events.filter(
      ({ transition, time }) => transition !== null && time <= this.motion.end,
    );
    return transitions.findLast((event) => event.time <= this.time) ?? transitions[0] ?? null;
  }

  /** Time of the cursor. */
  get time(): number {
    return this.state.view.time ?? this.motion.begin;
  }

  /**
   * Replaces the problem, or keeps it and reports what is wrong: the sole entry point for a change of problem. The cursor
   * goes to the start unless `view` has a time.
   */
  take(next: ProblemState, view: Partial<ViewState> = {}, fieldErrors: FieldError[] = []): boolean {
    const before = { problem: this.problem, view: this.state.view };
    try {
      const problem = checked(next);
      const motion = Motion.of(problem, caseOf(next));
      if (this.held) this.remember();
      this.motion.free();
      this.motion = motion;
      this.problem = problem;
      this.units = unitsOf(problem);
    } catch (refusal) {
      if (!(refusal instanceof Refusal)) throw refusal;
      this.fieldErrors = [...fieldErrors, fieldErrorOf(refusal, next)];
      if (Object.keys(view).length > 0)
        this.state = { ...this.state, view: { ...this.state.view, ...view, time: null } };
      this.notify('errors', 'view');
      return false;
    }
    this.state = { problem: next, view: { ...this.state.view, time: null, ...view } };
    this.fieldErrors = fieldErrors;
    const changes: Change[] = ['motion', 'time', 'errors'];
    if (!sameView(before.view, this.state.view)) changes.push('view');
    if (!sameHoop(before.problem, this.problem)) changes.push('hoop');
    before.problem.free();
    this.clampTime();
    this.notify(...changes);
    return true;
  }

  /** Sets some quantities of the system that is shown. Without a coefficient of restitution there is no law. */
  set(values: Given, view: Partial<ViewState> = {}): boolean {
    return this.take(this.changed(values), view);
  }

  /** The class that the motion has with some quantities of the system that is shown; none of what is refused. */
  classWith(values: Given): Class | null {
    return classIn(this.changed(values));
  }

  private changed(values: Given): ProblemState {
    const { problem } = this.state;
    const value = (quantity: Quantity): number =>
      values[quantity] ?? numberOf(problem, quantity) ?? NaN;
    const restitution = values.restitution === undefined ? problem.restitution : values.restitution;
    const law = lawOf({ ...problem, restitution });
    return problemWith(problem.system, value, { ...problem, restitution, law });
  }

  setLaw(law: Law): void {
    this.take({ ...this.state.problem, law });
  }

  /** Sets some quantities without dimension, in whichever units the problem is shown. */
  setPlain(
    values: Partial<Record<DimensionlessNumber, number>>,
    view: Partial<ViewState> = {},
  ): boolean {
    return this.set(this.shownOf(values), view);
  }

  /** Quantities without dimension as those of the system that is shown. */
  shownOf(values: Partial<Record<DimensionlessNumber, number>>): Given {
    const { problem } = this.state;
    if (problem.system === 'dimensionless') return values;
    const { particle_mass_kg, radius_m, gravity_m_per_s2 } = problem.values;
    const plain: Values<'dimensionless'> = { ...this.plain, ...values };
    const changed = Problem.dimensionless(inOrder('dimensionless', plain));
    const si = valuesOf('si', changed.toSi(particle_mass_kg, radius_m, gravity_m_per_s2));
    changed.free();
    const wanted = QUANTITIES.filter((it) => it in values).map((it) => inSystem('si', it));
    const entries = Object.entries(si).filter(([name]) => wanted.some((it) => it === name));
    return Object.fromEntries(entries);
  }

  /** Sets a quantity of the system that is shown; one that may be left out may be none. */
  setQuantity(quantity: Quantity, value: number | null): void {
    const { problem } = this.state;
    if (quantity === LIMIT[problem.system]) this.take({ ...problem, until: value });
    else if (quantity === 'restitution') this.set({ restitution: value });
    else if (value !== null) this.set({ [quantity]: value });
  }

  /** Shows the same problem in the other units. In SI units a new problem has the hula hoop's size. */
  setSystem(system: System): void {
    const { problem } = this.state;
    if (problem.system === system) return;
    const view = { time: this.state.view.time };
    const { restitution, law } = problem;
    if (system === 'dimensionless') {
      const until = problem.until === null ? null : problem.until / this.units.time;
      this.take({ system, values: this.plain, restitution, law, until }, view);
    } else {
      const { particle_mass_kg, radius_m, gravity_m_per_s2 } = HULA_HOOP;
      const values = valuesOf(
        'si',
        this.problem.toSi(particle_mass_kg, radius_m, gravity_m_per_s2),
      );
      const until =
        problem.until === null ? null : problem.until * Math.sqrt(radius_m / gravity_m_per_s2);
      this.take({ system, values, restitution, law, until }, view);
    }
  }

  setTime(time: number): void {
    this.state = { ...this.state, view: { ...this.state.view, time } };
    this.clampTime();
    this.notify('time');
  }

  setView(view: Partial<ViewState>): void {
    this.state = { ...this.state, view: { ...this.state.view, ...view } };
    this.notify('view');
  }

  /** Reports a field that could not be read. */
  report(fieldError: FieldError): void {
    this.fieldErrors = [fieldError];
    this.notify('errors');
  }

  private clampTime(): void {
    const { time } = this.state.view;
    if (time === null) return;
    const clamped = Math.min(Math.max(time, this.motion.begin), this.motion.end);
    this.state = {
      ...this.state,
      view: { ...this.state.view, time: clamped <= this.motion.begin ? null : clamped },
    };
  }
}

/** Throws a refusal of the core. */
function checked(problem: ProblemState): Problem {
  return problemIn(Problem, problem);
}

/** What the core says of a problem, beside the field of the system that is shown. */
function fieldErrorOf(refusal: Refusal, problem: ProblemState): FieldError {
  const field = inSystem(problem.system, quantityNamed(refusal.quantity));
  const { message, hint } = refusal;
  refusal.free();
  return {
    field,
    given: String(numberOf(problem, field) ?? ''),
    message: inSigns(`${message}: ${hint}`),
  };
}

/** Whether two views differ in nothing but the time. */
function sameView(a: ViewState, b: ViewState): boolean {
  return (Object.keys(a) as (keyof ViewState)[]).every(
    (key) => key === 'time' || a[key] === b[key],
  );
}

/** Whether two problems have the same curves and the same map: all is the same but angle, rate, place and time. */
function sameHoop(a: Problem, b: Problem): boolean {
  const [p, q] = [a.toDimensionless(), b.toDimensionless()];
  const varies = (name: DimensionlessNumber): boolean =>
    name === 'theta' || name === 'theta_rate' || QUANTITY_ROWS[name].group === 'place';
  return (
    a.restitution === b.restitution &&
    a.restitutionLaw === b.restitutionLaw &&
    DIMENSIONLESS.every((name, i) => varies(name) || Object.is(p[i], q[i]))
  );
}
