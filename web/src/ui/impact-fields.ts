// What belongs to an impact besides its coefficient: whether there is one, its law, and materials
// that have both that and friction.

import { MATERIALS, type Material, sourceOf } from '../core/materials';
import { make } from '../dom';
import { LAW_LABELS, LAWS } from '../generated/tables';
import type { Lab } from '../state/lab';
import { lawOf } from '../state/state';

/** The coefficient that the switch sets if there has been none. */
const FIRST = 0.5;

/** Why a massless hoop has no impact. */
const MASSLESS =
  'A massless hoop has no impact: an impulse would accelerate its rim without bound.';

export class ImpactFields {
  private readonly bounces = make('input', {
    type: 'checkbox',
    id: 'bounces',
    'aria-describedby': 'no-impact',
  });
  private readonly law = make('select', {
    id: 'law',
    'aria-describedby': 'message-restitution_law',
  });
  private readonly message = make('span', {
    class: 'message',
    id: 'message-restitution_law',
    role: 'alert',
  });
  private readonly material = make('select', {
    id: 'material',
    'aria-describedby': 'material-source',
  });
  private readonly source = make('p', { id: 'material-source', class: 'soft' });
  private readonly reason = make('p', { id: 'no-impact', class: 'soft' });
  /** What stands before the field of the coefficient, and after it. */
  readonly before: readonly HTMLElement[];
  readonly after: readonly HTMLElement[];
  /** The coefficient before it was taken away. */
  private last = FIRST;

  constructor(private readonly lab: Lab) {
    this.law.append(...LAWS.map((law) => make('option', { value: law }, LAW_LABELS[law])));
    this.material.append(
      make('option', { value: '', disabled: '' }, 'custom'),
      ...MATERIALS.map(({ name, label }) => make('option', { value: name }, label)),
    );
    this.before = [
      make(
        'label',
        { class: 'switch' },
        this.bounces,
        ' Let it bounce (otherwise it stops at the landing)',
      ),
      this.reason,
      make(
        'div',
        { class: 'row choice' },
        make('label', { for: 'material' }, 'Material'),
        this.material,
      ),
      this.source,
    ];
    this.after = [
      make(
        'div',
        { class: 'row choice' },
        make('label', { for: 'law' }, 'Law'),
        this.law,
        this.message,
      ),
    ];
    this.bounces.addEventListener('change', () => {
      lab.set({ restitution: this.bounces.checked ? this.last : null });
      this.show();
    });
    this.law.addEventListener('change', () => {
      const law = LAWS.find((it) => it === this.law.value);
      if (law !== undefined) lab.setLaw(law);
    });
    this.material.addEventListener('change', () => {
      const chosen = MATERIALS.find((it) => it.name === this.material.value);
      if (chosen)
        lab.set({ mu_s: chosen.mu_s, mu_k: chosen.mu_k, restitution: chosen.restitution });
    });
  }

  show(): void {
    const { problem } = this.lab.state;
    const { isMassless } = this.lab.problem;
    const law = lawOf(problem);
    if (problem.restitution !== null) this.last = problem.restitution;
    this.bounces.checked = problem.restitution !== null;
    this.bounces.disabled = isMassless;
    this.reason.textContent = isMassless ? MASSLESS : '';
    this.law.disabled = law === null;
    this.law.value = law ?? LAWS[0];
    const error = this.lab.fieldErrors.find((it) => it.field === 'restitution_law');
    this.message.textContent = error?.message ?? '';
    this.law.setAttribute('aria-invalid', String(error !== undefined));
    this.material.disabled = isMassless;
    const material = this.shown;
    this.material.value = material?.name ?? '';
    this.source.textContent = material ? sourceOf(material) : '';
  }

  /** The material that has the numbers of the problem. */
  private get shown(): Material | null {
    const { restitution, values } = this.lab.state.problem;
    const same = (it: Material): boolean =>
      it.restitution === restitution && it.mu_s === values.mu_s && it.mu_k === values.mu_k;
    return MATERIALS.find(same) ?? null;
  }
}
