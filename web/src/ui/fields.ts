// The fields of the hoop and the start, with tips and messages beside them.

import {
  isOptional,
  LIMIT,
  labelOf,
  meaningOf,
  numbersOf,
  readField,
  sliderOf,
  stepOf,
} from '../core/fields';
import { type NoThreshold, type Threshold, thresholdOf } from '../core/threshold';
import { brief, make } from '../dom';
import {
  CLASS_LABELS,
  type Group,
  QUANTITY_ROWS,
  type Quantity,
  type System,
} from '../generated/tables';
import type { Lab } from '../state/lab';
import { numberOf, type ProblemState } from '../state/state';
import { ImpactFields } from './impact-fields';

interface Row {
  quantity: Quantity;
  input: HTMLInputElement;
  slider: HTMLInputElement | null;
  message: HTMLElement;
  /** What was found of a threshold. */
  found: HTMLElement;
}

/** The parts of the form, and which of them can be folded away. */
const PARTS = [
  { title: 'Hoop', folds: false },
  { title: 'Impact', folds: false },
  { title: 'Start', folds: false },
  { title: 'Place, time and limit', folds: true },
] as const;

/** The part that a group of quantities is in; the coefficient of restitution has one of its own. */
const PART: Readonly<Record<Group, (typeof PARTS)[number]['title']>> = {
  hoop: 'Hoop',
  units: 'Hoop',
  start: 'Start',
  place: 'Place, time and limit',
  run: 'Place, time and limit',
};

function partOf(quantity: Quantity): (typeof PARTS)[number]['title'] {
  return quantity === 'restitution' ? 'Impact' : PART[QUANTITY_ROWS[quantity].group];
}

/** As many digits as a field has room for. */
function short(value: number): string {
  return String(Number(value.toPrecision(7)));
}

/** What a threshold divides, with all digits. */
function said(quantity: Quantity, { below, above }: Threshold): string {
  const at = `${labelOf(quantity)} = ${minus(above.value)}`;
  return `Below ${at}: ${CLASS_LABELS[below.class]}. From there on: ${CLASS_LABELS[above.class]}.`;
}

function none(quantity: Quantity, { from, to, step }: NoThreshold): string {
  return `The outcome does not change with ${labelOf(quantity)} from ${brief(from)} to ${brief(to)}, in steps of ${brief(step)}.`;
}

function minus(value: number): string {
  return String(value).replaceAll('-', '−');
}

export class Fields {
  private rows: Row[] = [];
  private system: System | null = null;
  /** The threshold that was looked for last, as long as the problem is that one. */
  private last: { quantity: Quantity; problem: ProblemState; text: string } | null = null;
  private readonly impact: ImpactFields;

  constructor(
    private readonly holder: HTMLElement,
    private readonly lab: Lab,
  ) {
    this.impact = new ImpactFields(lab);
    this.show();
  }

  /** Shows the state and the fieldErrors. What is being typed stays. */
  show(): void {
    const { problem } = this.lab.state;
    if (problem.system !== this.system) this.build(problem.system);
    for (const row of this.rows) {
      const value = numberOf(problem, row.quantity);
      const fieldError = this.lab.fieldErrors.find((it) => it.field === row.quantity);
      row.message.textContent = fieldError ? fieldError.message : '';
      row.found.textContent =
        this.last?.quantity === row.quantity && this.last.problem === problem ? this.last.text : '';
      row.input.setAttribute('aria-invalid', String(fieldError !== undefined));
      if (fieldError) {
        if (document.activeElement !== row.input && fieldError.given !== '')
          row.input.value = fieldError.given;
      } else if (
        document.activeElement !== row.input ||
        readField(row.quantity, row.input.value) !== value
      ) {
        row.input.value =
          value === null ? '' : document.activeElement === row.input ? String(value) : short(value);
      }
      if (row.slider && value !== null) {
        row.slider.value = String(value);
        row.slider.setAttribute(
          'aria-valuetext',
          `${brief(value)} ${QUANTITY_ROWS[row.quantity].unit}`.trim(),
        );
      }
      if (row.quantity === 'restitution') this.showRestitution(row, value);
    }
    this.impact.show();
  }

  /** Without a coefficient the slider is off; a massless hoop cannot have one. */
  private showRestitution({ input, slider }: Row, value: number | null): void {
    input.disabled = this.lab.problem.isMassless;
    if (!slider) return;
    slider.disabled = value === null;
    if (value !== null) return;
    slider.value = slider.min;
    slider.setAttribute('aria-valuetext', 'off: the motion ends at the landing');
  }

  private build(system: System): void {
    this.system = system;
    this.rows = [];
    const quantities = [...numbersOf(system), 'restitution' as const, LIMIT[system]];
    this.holder.replaceChildren(
      ...PARTS.map(({ title, folds }) => {
        const rows = quantities.filter((it) => partOf(it) === title).map((it) => this.row(it));
        if (title === 'Impact') {
          const { before, after } = this.impact;
          return make('fieldset', {}, make('legend', {}, title), ...before, ...rows, ...after);
        }
        if (folds) return make('details', { class: 'more' }, make('summary', {}, title), ...rows);
        return make('fieldset', {}, make('legend', {}, title), ...rows);
      }),
    );
  }

  private row(quantity: Quantity): HTMLElement {
    const label = labelOf(quantity);
    const tip = make(
      'span',
      { class: 'tip', role: 'tooltip', id: `tip-${quantity}` },
      meaningOf(quantity),
    );
    const message = make('span', { class: 'message', id: `message-${quantity}`, role: 'alert' });
    const found = make('output', { class: 'found', id: `found-${quantity}` });
    const input = make('input', {
      type: 'text',
      inputmode: 'decimal',
      id: `field-${quantity}`,
      name: quantity,
      autocomplete: 'off',
      spellcheck: 'false',
      'aria-describedby': `tip-${quantity} message-${quantity}`,
    });
    const words = make('span', { class: 'in-words' }, QUANTITY_ROWS[quantity].longName);
    const text = make('label', { for: `field-${quantity}` }, make('i', {}, label), words);
    if (quantity === 'restitution') input.placeholder = 'off';
    const row = make(
      'div',
      { class: 'row' },
      text,
      input,
      make('span', { class: 'unit' }, QUANTITY_ROWS[quantity].unit),
    );
    const range = sliderOf(quantity);
    let slider: HTMLInputElement | null = null;
    if (range) {
      slider = make('input', {
        type: 'range',
        min: String(range.min),
        max: String(range.max),
        step: String(stepOf(quantity)),
        'aria-label': `${label}, slider`,
        id: `slider-${quantity}`,
      });
      const find = make(
        'button',
        { type: 'button', class: 'threshold', 'aria-label': `Find the threshold of ${label}` },
        'threshold',
      );
      find.title = `The value nearest to this at which the outcome changes`;
      find.addEventListener('click', () => void this.find(quantity, range));
      // The class of a motion is decided before it bounces.
      if (quantity !== 'restitution') row.append(find);
      row.append(slider);
    } else {
      row.classList.add('plain');
    }
    row.append(found, tip, message);
    this.rows.push({ quantity, input, slider, message, found });
    // The last digits are there for who wants to change them.
    input.addEventListener('focus', () => {
      const value = numberOf(this.lab.state.problem, quantity);
      if (
        value === null ||
        input.value === String(value) ||
        input.getAttribute('aria-invalid') === 'true'
      )
        return;
      input.value = String(value);
      // As a field is entered with the tabulator: what is typed replaces it.
      input.select();
    });
    input.addEventListener('blur', () => this.show());
    input.addEventListener('input', () => this.typed(quantity, input.value));
    input.addEventListener('change', () => this.typed(quantity, input.value));
    input.addEventListener('keydown', (event) => this.stepped(event, quantity, input));
    slider?.addEventListener('input', () => this.lab.setQuantity(quantity, Number(slider.value)));
    return row;
  }

  /** Goes to the first number beyond the nearest threshold, and says what changes there. */
  private async find(quantity: Quantity, range: { min: number; max: number }): Promise<void> {
    const { lab } = this;
    const { problem } = lab.state;
    const now = numberOf(problem, quantity);
    if (now === null) return;
    this.last = { quantity, problem, text: 'Searching…' };
    this.show();
    const threshold = await thresholdOf(range, now, (value) =>
      // Of another problem nothing is found.
      lab.state.problem === problem ? lab.classWith({ [quantity]: value }) : null,
    );
    if (lab.state.problem !== problem) return;
    const isFound = 'above' in threshold;
    if (isFound) lab.setQuantity(quantity, threshold.above.value);
    const text = isFound ? said(quantity, threshold) : none(quantity, threshold);
    this.last = { quantity, problem: lab.state.problem, text };
    this.show();
  }

  private typed(quantity: Quantity, text: string): void {
    const isEmpty = text.trim() === '';
    const value = readField(quantity, text);
    if (value !== null || (isEmpty && isOptional(quantity))) {
      this.lab.setQuantity(quantity, value);
    } else {
      const message = isEmpty ? 'a number is missing' : `'${text}' is not a number`;
      this.lab.report({ field: quantity, given: text, message });
    }
  }

  /** The arrow keys count as they do in a field for numbers. */
  private stepped(event: KeyboardEvent, quantity: Quantity, input: HTMLInputElement): void {
    const way = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
    const value = readField(quantity, input.value);
    if (way === 0 || value === null) return;
    event.preventDefault();
    const step = stepOf(quantity) * (event.shiftKey ? 10 : 1);
    const next = Number((value + way * step).toFixed(10));
    input.value = String(next);
    this.typed(quantity, input.value);
  }
}
