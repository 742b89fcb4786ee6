// Where the energy of the start is at the cursor, as a bar.

import { ROUNDING } from '../core/motion';
import { brief, byId, make } from '../dom';
import { ENERGY_LABELS, ENERGY_PARTS, type EnergyPart } from '../generated/palette';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';

interface Part {
  name: EnergyPart;
  bar: HTMLElement;
  text: HTMLElement;
  value: HTMLElement;
}

export class EnergyBar {
  private readonly holder = byId('energy', HTMLElement);
  private readonly start = make('span', { class: 'start' });
  private readonly sum = make('output', { id: 'energy-sum' });
  private readonly parts: Part[] = ENERGY_PARTS.map((name) => ({
    name,
    bar: make('span', { class: 'part', 'data-energy': name }),
    text: make('span', {}, ENERGY_LABELS[name]),
    value: make('output', { 'data-part': name }),
  }));
  /** What the whole bar stands for. */
  private most = 1;

  constructor(private readonly lab: Lab) {
    byId('energy-bar', HTMLElement).append(...this.parts.map(({ bar }) => bar), this.start);
    byId('energy-legend', HTMLElement).append(
      ...this.parts.map(({ name, text, value }) =>
        make(
          'li',
          { 'data-energy': name },
          make('span', { class: 'swatch', 'aria-hidden': 'true' }),
          text,
          ' ',
          value,
        ),
      ),
      make('li', {}, 'at the start ', this.sum),
    );
  }

  showMotion(): void {
    const { motion, problem } = this.lab;
    this.holder.hidden = problem.restitution === undefined;
    if (this.holder.hidden) return;
    const total = motion.energy ?? 0;
    // A law that gains energy needs more room than the start.
    const gained = Math.max(
      0,
      ...motion.impacts.map(({ time }) => -(motion.energies(time)?.lost_in_impacts ?? 0)),
    );
    this.most = total + gained || 1;
    this.start.hidden = gained < ROUNDING * total;
    this.start.style.left = `${(100 * total) / this.most}%`;
    this.showTime();
  }

  showTime(): void {
    if (this.holder.hidden) return;
    const {
      motion,
      time,
      units,
      state: {
        problem: { system },
      },
    } = this.lab;
    const energies = motion.energies(time);
    for (const { name, bar, text, value } of this.parts) {
      const part = (energies?.[name] ?? 0) / this.most;
      const energy = Math.abs(part) < ROUNDING ? 0 : part * this.most;
      bar.style.width = `${Math.max(0, 100 * part)}%`;
      text.textContent =
        energy < 0 ? ENERGY_LABELS[name].replace('lost', 'gained') : ENERGY_LABELS[name];
      value.textContent = energies === null ? '–' : brief(Math.abs(energy) * units.energy, 4);
    }
    const sum =
      energies === null
        ? '–'
        : brief(ENERGY_PARTS.reduce((sum, part) => sum + energies[part], 0) * units.energy, 4);
    this.sum.textContent = `${sum} ${COLUMN_ROWS.energy.units[system]}`;
  }
}
