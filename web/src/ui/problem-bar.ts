// Case, units and the massless hoop: what changes several numbers at once.

import { inSystem } from '../core/fields';
import { byId, make } from '../dom';
import type { Quantity } from '../generated/tables';
import type { Given, Lab } from '../state/lab';

import { numberOf, rateFor } from '../state/state';
import { parse } from '../state/url';

export class ProblemBar {
  private readonly cases = byId('case', HTMLSelectElement);
  private readonly si = byId('si', HTMLInputElement);
  private readonly massless = byId('massless', HTMLInputElement);
  /** What a massless hoop has not, as it was before the hoop was made massless, in the units of that time. */
  private heavy: Given = {};

  constructor(
    private readonly lab: Lab,
    before: () => void,
  ) {
    this.cases.append(make('option', { value: '', disabled: '' }, 'custom hoop'));
    for (const named of lab.cases) {
      this.cases.append(make('option', { value: named.name }, `${named.name}: ${named.title}`));
    }
    this.cases.addEventListener('change', () => {
      const named = lab.cases.find((it) => it.name === this.cases.value);
      if (!named) return;
      before();
      const { problem } = parse(`case=${named.name}`).state;
      const massless = numberOf(problem, 'inertia') === 0 && numberOf(problem, 'mass_ratio') === 0;
      lab.take(problem, { rate: rateFor(massless, numberOf(problem, 'theta_rate') ?? 0) });
    });
    this.si.addEventListener('change', () => lab.setSystem(this.si.checked ? 'si' : 'dimensionless'));
    this.massless.addEventListener('change', () => this.switchMass());
  }

  private switchMass(): void {
    const { problem } = this.lab.state;
    // No mass, no inertia, and therefore neither a throw nor an impact.
    const names = (['mass_ratio', 'inertia', 'gap_rate'] as const).map((it) => inSystem(problem.system, it));
    const withValues = (value: (name: Quantity) => number): Partial<Record<Quantity, number>> =>
      Object.fromEntries(names.map((name) => [name, value(name)]));
    if (this.massless.checked) {
      this.heavy = { ...withValues((name) => numberOf(problem, name) ?? NaN), restitution: problem.restitution };
      this.lab.set({ ...withValues(() => 0), restitution: null }, { rate: rateFor(true, 0) });
    } else if (names.every((name) => name in this.heavy)) {
      this.lab.set(this.heavy, { rate: rateFor(false, 0) });
    } else {
      // A thin hoop as heavy as its particle.
      this.lab.setPlain({ mass_ratio: 1, inertia: 1 }, { rate: rateFor(false, 0) });
    }
    // A refusal leaves things as they were.
    this.show();
  }

  show(): void {
    const { lab } = this;
    this.cases.value = lab.named ?? '';
    const fieldError = lab.fieldErrors.find((it) => it.field === 'case');
    byId('case-message', HTMLSpanElement).textContent = fieldError?.message ?? '';
    this.cases.setAttribute('aria-invalid', String(fieldError !== undefined));
    this.si.checked = lab.state.problem.system === 'si';
    this.massless.checked = lab.problem.isMassless;
    const named = lab.cases.find((it) => it.name === lab.named);
    byId('source', HTMLSpanElement).textContent = named ? named.source : '';
  }
}
