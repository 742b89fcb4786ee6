// The simple view's sliders, in words, and what the colours of the hoop mean.

import { brief, byId, make } from '../dom';
import { MODES, QUANTITY_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';
import { filled, TEXTS } from './texts';

interface Slider {
  name: keyof typeof TEXTS.sliders;
  least: number;
  most: number;
  step: number;
  /** Where the slider stands; none for a hoop that has no such thing, and then what there is instead. */
  read(lab: Lab): number | null;
  absent?: string;
  write(lab: Lab, value: number): void;
  say(value: number): string;
}

/** μk/μs of a ground without any friction that is given some. */
const KINETIC = 0.8;

/** The place of a slider that takes the coefficient of restitution away. */
const OFF = -0.05;

const rounded = (value: number): number => Number(value.toPrecision(4));

const {
  theta_rate: { usual: spins },
  mu_s: { usual: grips },
  rolling_resistance: { usual: resistances },
} = QUANTITY_ROWS;

const SLIDERS: readonly Slider[] = [
  {
    name: 'spin',
    least: spins[0],
    most: spins[1],
    step: 0.05,
    read: (lab) => lab.plain.theta_rate,
    write: (lab, theta_rate) => lab.setPlain({ theta_rate }),
    say: (value) => {
      const { left, right, none } = TEXTS.sliders.spin;
      return filled(value === 0 ? none : value > 0 ? left : right, {
        value: brief(Math.abs(value), 3),
      });
    },
  },
  {
    name: 'grip',
    least: grips[0],
    most: grips[1],
    step: 0.01,
    read: (lab) => lab.plain.mu_s,
    write: (lab, mu_s) => {
      const { mu_s: before, mu_k } = lab.plain;
      lab.setPlain({ mu_s, mu_k: rounded(mu_s * (before > 0 ? mu_k / before : KINETIC)) });
    },
    say: (value) =>
      filled(value === 0 ? TEXTS.sliders.grip.none : TEXTS.sliders.grip.some, {
        value: brief(value, 3),
      }),
  },
  {
    name: 'weight',
    absent: TEXTS.sliders.weight.absent,
    least: -1,
    most: 1,
    step: 0.05,
    // Powers of ten: half as heavy is as far from the middle as twice.
    read: ({ plain: { mass_ratio } }) => (mass_ratio > 0 ? -Math.log10(mass_ratio) : null),
    write: (lab, power) => {
      const { mass_ratio, inertia } = lab.plain;
      const next = rounded(10 ** -power);
      lab.setPlain({ mass_ratio: next, inertia: rounded((inertia * next) / mass_ratio) });
    },
    say: (power) => {
      const { same, more, less } = TEXTS.sliders.weight;
      const value = 10 ** power;
      return filled(Math.abs(power) < 0.01 ? same : value > 1 ? more : less, {
        value: brief(value, 2),
      });
    },
  },
  {
    name: 'resistance',
    least: resistances[0],
    most: resistances[1],
    step: 0.01,
    read: (lab) => lab.plain.rolling_resistance,
    write: (lab, rolling_resistance) => lab.setPlain({ rolling_resistance }),
    say: (value) => {
      const { none, some } = TEXTS.sliders.resistance;
      return filled(value === 0 ? none : some, { value: brief(value, 3) });
    },
  },
  {
    name: 'bounce',
    absent: TEXTS.sliders.bounce.absent,
    least: OFF,
    most: 1,
    step: 0.05,
    read: (lab) => (lab.problem.isMassless ? null : (lab.state.problem.restitution ?? OFF)),
    write: (lab, value) => lab.set({ restitution: value < 0 ? null : value }),
    say: (value) => {
      const { off, none, some } = TEXTS.sliders.bounce;
      return filled(value < 0 ? off : value === 0 ? none : some, { value: brief(value, 2) });
    },
  },
];

export class Words {
  private readonly rows = SLIDERS.map((slider) => {
    const id = `word-${slider.name}`;
    const range = make('input', {
      type: 'range',
      id,
      min: String(slider.least),
      max: String(slider.most),
      step: String(slider.step),
    });
    const said = make('output', { for: id });
    range.addEventListener('input', () =>
      slider.write(this.lab, Number(Number(range.value).toFixed(2))),
    );
    return { slider, range, said };
  });

  /** The modes that are explained. */
  private legend = '';

  constructor(private readonly lab: Lab) {
    byId('words', HTMLDivElement).append(
      ...this.rows.map(({ slider, range, said }) =>
        make(
          'div',
          { class: 'word' },
          make('label', { for: range.id }, TEXTS.sliders[slider.name].label),
          said,
          range,
        ),
      ),
    );
  }

  showMotion(): void {
    const { lab } = this;
    for (const { slider, range, said } of this.rows) {
      const value = slider.read(lab);
      range.disabled = value === null;
      const text = value === null ? (slider.absent ?? '') : slider.say(value);
      if (value !== null) range.value = String(value);
      said.textContent = text;
      range.setAttribute('aria-valuetext', text);
    }
    const { problem, plain } = lab;
    const modes = MODES.filter((it) => {
      if (it === 'gliding') return problem.isMassless;
      return (it !== 'rest' && it !== 'skidding') || plain.rolling_resistance > 0;
    });
    if (modes.join() === this.legend) return;
    this.legend = modes.join();
    byId('words-legend', HTMLUListElement).replaceChildren(
      ...modes.map((mode) =>
        make(
          'li',
          { 'data-mode': mode },
          make('span', { class: 'swatch', 'aria-hidden': 'true' }),
          TEXTS.modes[mode],
        ),
      ),
    );
  }
}
