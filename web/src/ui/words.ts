// The simple view's sliders, in words, and what the colours of the hoop mean.

import { thresholdOf } from '../core/threshold';
import { brief, byId, make } from '../dom';
import { CLASS_LABELS, type Class, MODES, QUANTITY_ROWS } from '../generated/tables';
import type { Given, Lab } from '../state/lab';
import type { ProblemState } from '../state/state';
import { filled, TEXTS } from './texts';

interface Slider {
  name: keyof typeof TEXTS.sliders;
  least: number;
  most: number;
  step: number;
  /** Where the slider stands; none for a hoop that has no such thing, and then what there is instead. */
  read(lab: Lab): number | null;
  absent?: string;
  /** The hoop and the start that a value of the slider stands for, with what follows from it rounded, or not. */
  given(lab: Lab, value: number, round: (it: number) => number): Given;
  say(value: number): string;
  /** A value at which the outcome changes, with more digits; none of a slider that has no such place. */
  exact?(value: number): string;
}

/** μk/μs of a ground without any friction that is given some. */
const KINETIC = 0.8;

/** The place of a slider that takes the coefficient of restitution away. */
const OFF = -0.05;

/** Digits of a value at which the outcome changes. */
const DIGITS = 8;

const exactly = (value: number): string => brief(value, DIGITS);

/** With all digits. */
const exact = (value: number): number => value;

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
    given: (lab, theta_rate) => lab.shownOf({ theta_rate }),
    exact: (value) => exactly(value),
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
    given: (lab, mu_s, round) => {
      const { mu_s: before, mu_k } = lab.plain;
      return lab.shownOf({ mu_s, mu_k: round(mu_s * (before > 0 ? mu_k / before : KINETIC)) });
    },
    exact: (value) => exactly(value),
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
    given: (lab, power, round) => {
      const { mass_ratio, inertia } = lab.plain;
      const next = round(10 ** -power);
      return lab.shownOf({ mass_ratio: next, inertia: round((inertia * next) / mass_ratio) });
    },
    exact: (power) => filled(TEXTS.sliders.weight.more, { value: exactly(10 ** power) }),
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
    given: (lab, rolling_resistance) => lab.shownOf({ rolling_resistance }),
    exact: (value) => exactly(value),
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
    given: (_, value) => ({ restitution: value < 0 ? null : value }),
    say: (value) => {
      const { off, none, some } = TEXTS.sliders.bounce;
      return filled(value < 0 ? off : value === 0 ? none : some, { value: brief(value, 2) });
    },
  },
];

/** The library's name of a class, or the language's. */
function classWord(name: Class): string {
  return TEXTS.classes?.[name] ?? CLASS_LABELS[name];
}

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
      this.lab.set(slider.given(this.lab, Number(Number(range.value).toFixed(2)), rounded)),
    );
    const { label } = TEXTS.sliders[slider.name];
    const { find, title } = TEXTS.threshold;
    const button = make(
      'button',
      { type: 'button', class: 'threshold', title, 'aria-label': `${find} ${label}` },
      find,
    );
    button.addEventListener('click', () => void this.find(slider));
    const found = make('output', { class: 'found', for: id });
    return { slider, range, said, button, found };
  });

  /** What was found last, as long as the motion is that one. */
  private last: { slider: Slider; problem: ProblemState; text: string } | null = null;

  /** The modes that are explained. */
  private legend = '';

  constructor(private readonly lab: Lab) {
    byId('words', HTMLDivElement).append(
      ...this.rows.map(({ slider, range, said, button, found }) =>
        make(
          'div',
          { class: 'word' },
          make('label', { for: range.id }, TEXTS.sliders[slider.name].label),
          said,
          range,
          ...(slider.exact === undefined ? [] : [button, found]),
        ),
      ),
    );
  }

  /** Goes to where the outcome changes that is nearest, and says what is on which side. */
  private async find(slider: Slider): Promise<void> {
    const { lab } = this;
    const { problem } = lab.state;
    const now = slider.read(lab);
    if (now === null || slider.exact === undefined) return;
    const { searching, said, none } = TEXTS.threshold;
    this.last = { slider, problem, text: searching };
    this.showFound();
    const range = { min: slider.least, max: slider.most };
    const threshold = await thresholdOf(range, now, (value) =>
      // Of another problem nothing is found.
      lab.state.problem === problem ? lab.classWith(slider.given(lab, value, exact)) : null,
    );
    if (lab.state.problem !== problem) return;
    let text = none;
    if ('above' in threshold) {
      const { above, below } = threshold;
      text = filled(said, {
        value: slider.exact(above.value),
        above: classWord(above.class),
        below: classWord(below.class),
      });
      lab.set(slider.given(lab, above.value, exact));
    }
    this.last = { slider, problem: lab.state.problem, text };
    this.showFound();
  }

  private showFound(): void {
    const { last, lab } = this;
    for (const { slider, found } of this.rows) {
      const isShown = last?.slider === slider && last.problem === lab.state.problem;
      found.textContent = isShown ? last.text : '';
    }
  }

  showMotion(): void {
    const { lab } = this;
    this.showFound();
    for (const { slider, range, said, button } of this.rows) {
      const value = slider.read(lab);
      range.disabled = value === null;
      button.disabled = value === null;
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
