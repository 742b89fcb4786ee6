// Case, units and the massless hoop: what changes several numbers at once.

import { indexOf } from '../core/fields';
import type { Lab } from '../state/lab';
import { problemOfCase, rateFor } from '../state/state';
import { byId, make } from './dom';

export class ProblemBar {
  private readonly cases = byId('case', HTMLSelectElement);
  private readonly si = byId('si', HTMLInputElement);
  private readonly massless = byId('massless', HTMLInputElement);
  /** Mass and inertia before the hoop was made massless. */
  private heavy: [number, number] | null = null;

  constructor(private readonly lab: Lab, before: () => void) {
    this.cases.append(make('option', { value: '', disabled: '' }, 'a hoop of your own'));
    for (const named of lab.cases) {
      this.cases.append(make('option', { value: named.name }, `${named.name}: ${named.title}`));
    }
    this.cases.addEventListener('change', () => {
      const named = lab.cases.find((it) => it.name === this.cases.value);
      if (!named) return;
      before();
      const massless = named.hoop['inertia'] === 0 && named.hoop['mass_ratio'] === 0;
      lab.take(problemOfCase(named), { rate: rateFor(massless, named.start['theta_rate'] ?? 0) });
    });
    this.si.addEventListener('change', () => lab.setSystem(this.si.checked ? 'si' : 'dimensionless'));
    this.massless.addEventListener('change', () => this.switchMass());
  }

  private switchMass(): void {
    const { system, numbers } = this.lab.state.problem;
    const names = system === 'si' ? ['disc_mass_kg', 'inertia_kg_m2'] : ['mass_ratio', 'inertia'];
    const [mass, inertia] = names as [string, string];
    const values = names.map((name) => numbers[indexOf(system, name)]!) as [number, number];
    if (this.massless.checked) {
      this.heavy = values;
      this.lab.set({ [mass]: 0, [inertia]: 0 }, { rate: rateFor(true, 0) });
    } else {
      const [, m2, radius] = numbers as [number, number, number];
      const thin: [number, number] = system === 'si' ? [m2, m2 * radius * radius] : [1, 1];
      const [m, i] = this.heavy ?? thin;
      this.lab.set({ [mass]: m, [inertia]: i }, { rate: rateFor(false, 0) });
    }
    // A refusal leaves things as they were.
    this.show();
  }

  show(): void {
    const { lab } = this;
    this.cases.value = lab.named ?? '';
    const complaint = lab.complaints.find((it) => it.field === 'case');
    byId('case-message', HTMLSpanElement).textContent = complaint?.message ?? '';
    this.cases.setAttribute('aria-invalid', String(complaint !== undefined));
    this.si.checked = lab.state.problem.system === 'si';
    this.massless.checked = lab.problem.isMassless;
    const named = lab.cases.find((it) => it.name === lab.named);
    byId('source', HTMLSpanElement).textContent = named ? named.source : '';
  }
}
