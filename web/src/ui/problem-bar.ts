// Case, units and the massless hoop: what changes several numbers at once.

import { inSystem } from '../core/fields';
import { byId, make } from '../dom';
import {
  DIMENSIONLESS,
  type DimensionlessNumber,
  QUANTITY_ROWS,
  type Quantity,
} from '../generated/tables';
import type { Given, Lab } from '../state/lab';
import { numberOf, type ProblemState, rateFor, rateOf } from '../state/state';
import { parse } from '../state/url';

/** By what part a number may differ that has gone to SI units and back. */
const ROUNDING = 1e-12;

export class ProblemBar {
  private readonly cases = byId('case', HTMLSelectElement);
  private readonly si = byId('si', HTMLInputElement);
  private readonly massless = byId('massless', HTMLInputElement);
  /** What a massless hoop has not, as it was before the hoop was made massless, in the units of that time. */
  private heavy: Given = {};

  /** What is shown where no case is. */
  private readonly own = make('option', { value: '', disabled: '' });
  /** The case that was shown last, and its numbers. */
  private last: { name: string; problem: Float64Array } | null = null;

  constructor(
    private readonly lab: Lab,
    /** A case is chosen. */
    chosen: (problem: ProblemState) => void,
  ) {
    this.cases.append(this.own);
    for (const named of lab.cases) {
      this.cases.append(make('option', { value: named.name }, `${named.name}: ${named.title}`));
    }
    this.cases.addEventListener('change', () => {
      const named = lab.cases.find((it) => it.name === this.cases.value);
      if (!named) return;
      const { problem } = parse(`case=${named.name}`).state;
      chosen(problem);
      lab.take(problem, { rate: rateOf(problem) });
    });
    this.si.addEventListener('change', () =>
      lab.setSystem(this.si.checked ? 'si' : 'dimensionless'),
    );
    this.massless.addEventListener('change', () => this.switchMass());
  }

  private switchMass(): void {
    const { problem } = this.lab.state;
    // No mass, no inertia, and therefore neither a throw nor an impact.
    const names = (['mass_ratio', 'inertia', 'gap_rate'] as const).map((it) =>
      inSystem(problem.system, it),
    );
    const withValues = (value: (name: Quantity) => number): Partial<Record<Quantity, number>> =>
      Object.fromEntries(names.map((name) => [name, value(name)]));
    if (this.massless.checked) {
      this.heavy = {
        ...withValues((name) => numberOf(problem, name) ?? NaN),
        restitution: problem.restitution,
      };
      this.lab.set(
        { ...withValues(() => 0), restitution: null },
        { rate: rateFor(true, this.lab.plain.theta_rate) },
      );
    } else if (names.every((name) => name in this.heavy)) {
      this.lab.set(this.heavy, { rate: rateFor(false, this.lab.plain.theta_rate) });
    } else {
      // A thin hoop as heavy as its particle.
      this.lab.setPlain(
        { mass_ratio: 1, inertia: 1 },
        { rate: rateFor(false, this.lab.plain.theta_rate) },
      );
    }
    // A refusal leaves things as they were.
    this.show();
  }

  /** What is shown: the last case in SI units, its hoop from another start, or a hoop of one's own. */
  private get title(): string {
    const { last, lab } = this;
    const numbers = lab.problem.toDimensionless();
    const isSame = (of: readonly DimensionlessNumber[]): boolean =>
      last !== null &&
      of.every((name) => {
        const place = DIMENSIONLESS.indexOf(name);
        return (
          Math.abs(last.problem[place]! - numbers[place]!) <=
          ROUNDING * Math.max(1, Math.abs(numbers[place]!))
        );
      });
    if (isSame(DIMENSIONLESS) && lab.state.problem.system === 'si')
      return `${last?.name}, in SI units`;
    return isSame(DIMENSIONLESS.filter((name) => QUANTITY_ROWS[name].group === 'hoop'))
      ? `${last?.name}, another start`
      : 'custom hoop';
  }

  show(): void {
    const { lab } = this;
    this.cases.value = lab.named ?? '';
    // A link alone names a case that there is not: the message stands over the page.
    this.cases.setAttribute(
      'aria-invalid',
      String(lab.fieldErrors.some((it) => it.field === 'case')),
    );
    if (lab.named !== null) this.last = { name: lab.named, problem: lab.problem.toDimensionless() };
    this.own.textContent = this.title;
    this.si.checked = lab.state.problem.system === 'si';
    this.massless.checked = lab.problem.isMassless;
    const named = lab.cases.find((it) => it.name === lab.named);
    byId('source', HTMLSpanElement).textContent = named ? named.source : '';
  }
}
