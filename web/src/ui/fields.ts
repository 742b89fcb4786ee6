// The fields of the hoop and the start, with tips and messages beside them.

import { fieldsOf, untilName, type Field, type System } from '../core/fields';
import type { Lab } from '../state/lab';
import { readNumber } from '../state/url';
import { brief, make } from './dom';

interface Row {
  field: Field | null;
  name: string;
  input: HTMLInputElement;
  slider: HTMLInputElement | null;
  message: HTMLElement;
}

export class Fields {
  private rows: Row[] = [];
  private system: System | null = null;

  constructor(private readonly holder: HTMLElement, private readonly lab: Lab) {
    this.show();
  }

  /** Shows the state and the complaints. What is being typed stays. */
  show(): void {
    const { system, numbers, until } = this.lab.state.problem;
    if (system !== this.system) this.build(system);
    this.rows.forEach((row) => {
      const value = row.field ? numbers[fieldsOf(system).indexOf(row.field)]! : until;
      const complaint = this.lab.complaints.find((it) => it.field === row.name);
      row.message.textContent = complaint ? complaint.message : '';
      row.input.setAttribute('aria-invalid', String(complaint !== undefined));
      if (complaint) {
        if (document.activeElement !== row.input && complaint.given !== '') row.input.value = complaint.given;
      } else if (document.activeElement !== row.input || readNumber(row.input.value) !== value) {
        row.input.value = value === null ? '' : String(value);
      }
      if (row.slider && value !== null) {
        row.slider.value = String(value);
        row.slider.setAttribute('aria-valuetext', `${brief(value)} ${row.field?.unit ?? ''}`.trim());
      }
    });
  }

  private build(system: System): void {
    this.system = system;
    this.rows = [];
    const group = (title: string, open: boolean, fields: Node[]): HTMLElement => {
      if (open) return make('fieldset', {}, make('legend', {}, title), ...fields);
      return make('details', { class: 'more' }, make('summary', {}, title), ...fields);
    };
    const of = (name: Field['group']): Node[] =>
      fieldsOf(system).filter((field) => field.group === name).map((field) => this.row(field, field.name));
    const [hoop, start, place] = [of('hoop'), of('start'), of('place')];
    const limit: Field = {
      name: untilName(system), label: system === 'si' ? 'until t' : 'until τ', unit: system === 'si' ? 's' : '√(R/g)',
      meaning: 'Stops the motion at this time. Empty: it is followed to its end.', group: 'place', min: 0, max: 0, step: 1,
      slider: false,
    };
    this.holder.replaceChildren(
      group('Hoop', true, hoop), group('Start', true, start),
      group('Place, time and limit', false, [...place, this.row(limit, limit.name)]),
    );
  }

  private row(field: Field, name: string): HTMLElement {
    const tip = make('span', { class: 'tip', role: 'tooltip', id: `tip-${name}` }, field.meaning);
    const message = make('span', { class: 'message', id: `message-${name}`, role: 'alert' });
    const input = make('input', {
      type: 'text', inputmode: 'decimal', id: `field-${name}`, name, autocomplete: 'off', spellcheck: 'false',
      'aria-describedby': `tip-${name} message-${name}`,
    });
    const text = make('label', { for: `field-${name}` }, make('i', {}, field.label));
    const row = make('div', { class: 'row' }, text, input, make('span', { class: 'unit' }, field.unit));
    let slider: HTMLInputElement | null = null;
    if (field.slider) {
      slider = make('input', {
        type: 'range', min: String(field.min), max: String(field.max), step: String(field.step),
        'aria-label': `${field.label}, slider`, id: `slider-${name}`,
      });
      row.append(slider);
    } else {
      row.classList.add('plain');
    }
    row.append(tip, message);
    const known = fieldsOf(this.lab.state.problem.system).includes(field) ? field : null;
    this.rows.push({ field: known, name, input, slider, message });
    input.addEventListener('input', () => this.typed(name, known, input.value));
    input.addEventListener('change', () => this.typed(name, known, input.value));
    input.addEventListener('keydown', (event) => this.stepped(event, field, known, input));
    slider?.addEventListener('input', () => this.lab.set({ [name]: Number(slider.value) }));
    return row;
  }

  private typed(name: string, field: Field | null, text: string): void {
    if (!field && text.trim() === '') {
      this.lab.setUntil(null);
      return;
    }
    const value = readNumber(text);
    if (value === null) {
      this.lab.complain({ field: name, given: text, message: text.trim() === '' ? 'a number is missing' : `'${text}' is not a number` });
    } else if (field) {
      this.lab.set({ [name]: value });
    } else {
      this.lab.setUntil(value);
    }
  }

  /** The arrow keys count as they do in a field for numbers. */
  private stepped(event: KeyboardEvent, field: Field, known: Field | null, input: HTMLInputElement): void {
    const way = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
    const value = readNumber(input.value);
    if (way === 0 || value === null) return;
    event.preventDefault();
    const step = field.step * (event.shiftKey ? 10 : 1);
    const next = Number((value + way * step).toFixed(10));
    input.value = String(next);
    this.typed(field.name, known, input.value);
  }
}
