// Where the energy of the start is at the cursor, as a bar.

import { brief, byId, make } from '../dom';
import { ENERGY_LABELS, ENERGY_PARTS, type EnergyPart } from '../generated/palette';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';

interface Part {
  name: EnergyPart;
  row: HTMLElement;
  bar: HTMLElement;
  text: HTMLElement;
  value: HTMLElement;
}

export class EnergyBar {
  private readonly holder = byId('energy', HTMLElement);
  private readonly start = make('span', { class: 'start' });
  private readonly sum = make('output', { id: 'energy-sum' });
  private readonly zero = make('span', { class: 'zero', title: 'zero of the energy' });
  private readonly parts: Part[] = ENERGY_PARTS.map((name) => {
    const text = make('span', {}, ENERGY_LABELS[name]);
    const value = make('output', { 'data-part': name });
    const swatch = make('span', { class: 'swatch', 'aria-hidden': 'true' });
    const row = make('li', { 'data-energy': name }, swatch, text, ' ', value);
    return { name, row, bar: make('span', { class: 'part', 'data-energy': name }), text, value };
  });
  /** The energies at the ends of the bar. */
  private scale: [number, number] = [0, 1];

  constructor(private readonly lab: Lab) {
    byId('energy-bar', HTMLElement).append(
      ...this.parts.map(({ bar }) => bar),
      this.zero,
      this.start,
    );
    byId('energy-legend', HTMLElement).append(
      ...this.parts.map(({ row }) => row),
      make('li', {}, 'at the start ', this.sum),
    );
  }

  showMotion(): void {
    const { motion, plain, problem } = this.lab;
    const bounces = problem.restitution !== undefined;
    const resists = plain.rolling_resistance > 0;
    this.holder.hidden = !bounces && !resists;
    if (this.holder.hidden) return;
    for (const { name, row } of this.parts) {
      row.hidden =
        (name === 'lost_in_impacts' && !bounces) ||
        (name === 'lost_to_rolling_resistance' && !resists);
    }
    const [low, high] = motion.energyScale;
    this.scale = [low, high > low ? high : low + 1];
    const total = motion.energy ?? 0;
    // A law that gains energy needs more room than the start.
    this.start.hidden = this.place(total) >= 1;
    this.start.style.left = `${100 * this.place(total)}%`;
    const zero = this.place(0);
    this.zero.hidden = zero < 0 || zero > 1;
    this.zero.style.left = `${100 * zero}%`;
    this.showTime();
  }

  /** Where an energy stands on the bar, from 0 to 1. */
  private place(energy: number): number {
    const [low, high] = this.scale;
    return (energy - low) / (high - low);
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
      const energy = energies?.[name] ?? 0;
      // The potential energy reaches up to its own place; the others stand upon it.
      const width = this.place(name === 'potential' ? energy : this.scale[0] + energy);
      bar.style.width = `${Math.max(0, 100 * width)}%`;
      // What is lost below zero is gained.
      const isGained = energy < 0 && name.startsWith('lost');
      text.textContent = isGained
        ? ENERGY_LABELS[name].replace('lost', 'gained')
        : ENERGY_LABELS[name];
      value.textContent =
        energies === null ? '–' : brief((isGained ? -energy : energy) * units.energy, 4);
    }
    const sum =
      energies === null
        ? '–'
        : brief(ENERGY_PARTS.reduce((sum, part) => sum + energies[part], 0) * units.energy, 4);
    this.sum.textContent = `${sum} ${COLUMN_ROWS.energy.units[system]}`;
  }
}
