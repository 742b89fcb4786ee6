// The quantities of a problem in either system of units, and what only the page says of them.

import {
  DIMENSIONLESS,
  type DimensionlessNumber,
  type Group,
  QUANTITIES,
  QUANTITY_ROWS,
  type Quantity,
  SI,
  type SiNumber,
  type System,
} from '../generated/tables';
import { readNumber } from './wasm';

/** The numbers of a problem in each system. */
export interface Numbers {
  dimensionless: DimensionlessNumber;
  si: SiNumber;
}

export type Values<S extends System> = Readonly<Record<Numbers[S], number>>;

const NUMBERS: { readonly [S in System]: readonly Numbers[S][] } = {
  dimensionless: DIMENSIONLESS,
  si: SI,
};

/** The numbers of a system, in the order in which the core takes them. */
export function numbersOf<S extends System>(system: S): readonly Numbers[S][] {
  return NUMBERS[system];
}

/** Values by name, of numbers in the order of the core. */
export function valuesOf<S extends System>(system: S, numbers: Float64Array): Values<S> {
  const names = numbersOf(system);
  if (numbers.length !== names.length)
    throw new Error(`${numbers.length} numbers for ${names.length} quantities`);
  return Object.fromEntries(names.map((name, i) => [name, numbers[i]])) as Values<S>;
}

/** Values in the order of the core. */
export function inOrder<S extends System>(system: S, values: Values<S>): Float64Array {
  return Float64Array.from(numbersOf(system), (name) => values[name]);
}

/** Units of a problem that had none: a hula hoop with a battery on it. */
export const HULA_HOOP = {
  particle_mass_kg: 0.14,
  radius_m: 0.45,
  gravity_m_per_s2: QUANTITY_ROWS.gravity_m_per_s2.otherwise,
};

/** √(R/g) of that hoop, in seconds. */
export const HULA_SECOND = Math.sqrt(HULA_HOOP.radius_m / HULA_HOOP.gravity_m_per_s2);

/** The time limit in each system. */
export const LIMIT: Readonly<Record<System, Quantity>> = { dimensionless: 'until', si: 'until_s' };

/** Whether a quantity may be left out, which has a meaning of its own. */
export function isOptional(quantity: Quantity): boolean {
  return quantity === 'restitution' || quantity === LIMIT.dimensionless || quantity === LIMIT.si;
}

/** The quantity that stands for another in a system: its twin, or itself where both systems have the same number. */
export function inSystem(system: System, quantity: Quantity): Quantity {
  const row = QUANTITY_ROWS[quantity];
  return row.system === system || row.twin === null ? quantity : row.twin;
}

/** The quantity of a name that the core gives. */
export function quantityNamed(name: string): Quantity {
  const quantity = QUANTITIES.find((it) => it === name);
  if (quantity === undefined) throw new Error(`there is no quantity named '${name}'`);
  return quantity;
}

/** What a person at the page may want to know besides the long name, for both systems. */
const REMARKS: Partial<Record<Quantity, string>> = {
  offset: 'The radius for a particle on the rim.',
  inertia: 'A thin hoop has Izz = m₁R², a uniform disc half of that.',
  mu_s: 'The hoop rolls while |F| ≤ μₛN (2.13).',
  mu_k: 'While the contact point slips |F| = μₖN (2.15). Never above μₛ.',
  rolling_resistance: 'The plane resists the rotation with a couple of up to χN.',
  restitution:
    '0: no rebound; 1: nothing is lost in restitution. Empty: the motion ends where the rim lands.',
  theta: 'Positive counterclockwise.',
  theta_rate: 'Negative for a hoop that rolls to the right.',
  slip: '0 lets friction decide what follows.',
  gap_rate: 'Above 0 the hoop is thrown from the plane.',
  x: 'Position at the start; the motion does not depend on it.',
  time: 'Time of the start; the motion does not depend on it.',
  until: 'Time limit. Empty: to the end of the motion.',
};

/** What a quantity is, for its tip. */
export function meaningOf(quantity: Quantity): string {
  const name = QUANTITY_ROWS[quantity].longName;
  const remark = REMARKS[inSystem('dimensionless', quantity)];
  return `${name.charAt(0).toUpperCase()}${name.slice(1)}.${remark === undefined ? '' : ` ${remark}`}`;
}

/** What a person types: a number, with a comma or a point; of an angle also in degrees, or a multiple or a part of π. */
export function readField(quantity: Quantity, text: string): number | null {
  const plain = text.trim().replace(',', '.');
  const isAngle = QUANTITY_ROWS[quantity].unit === 'rad';
  const degrees = isAngle ? /^(.*\S)\s*°$/.exec(plain) : null;
  if (degrees) {
    const value = readNumber(degrees[1]!);
    return value === undefined ? null : (value * Math.PI) / 180;
  }
  const turns = isAngle
    ? /^([-+−]?)([\d.]*)\s*\*?\s*(?:π|pi)(?:\s*\/\s*([\d.]+))?$/i.exec(plain)
    : null;
  if (!turns) return readNumber(plain) ?? null;
  const [, sign, factor, part] = turns;
  const value = (Number(factor || 1) * Math.PI) / Number(part ?? 1);
  return Number.isFinite(value) ? (sign === '' || sign === '+' ? value : -value) : null;
}

/** A message of the core with the signs of quantities instead of the names that flags have. */
export function inSigns(message: string): string {
  return QUANTITIES.reduce(
    // Names of one word are also words: they are names where a value follows.
    (text, name) =>
      text.replaceAll(
        new RegExp(`\\b${name}${name.includes('_') ? '\\b' : '(?= = )'}`, 'g'),
        QUANTITY_ROWS[name].sign,
      ),
    message,
  ).replaceAll('m2 R^2', 'm₂R²');
}

/** The label of a field: a limit of time has the symbol of the time. */
export function labelOf(quantity: Quantity): string {
  const { group, sign } = QUANTITY_ROWS[quantity];
  return group === 'run' ? `until ${sign}` : sign;
}

/** Whether there is a slider. */
const SLIDES: Readonly<Record<Group, boolean>> = {
  hoop: true,
  start: true,
  units: true,
  place: false,
  run: false,
};

/** The slider of a quantity; a number that is typed may lie beyond its range. */
export function sliderOf(quantity: Quantity): { min: number; max: number } | null {
  const {
    group,
    usual: [min, max],
  } = QUANTITY_ROWS[quantity];
  return SLIDES[group] ? { min, max } : null;
}

/** What an arrow key changes a quantity by: a power of ten, at most a hundredth of its usual range. */
export function stepOf(quantity: Quantity): number {
  const {
    usual: [least, most],
  } = QUANTITY_ROWS[quantity];
  return Number(`1e${Math.floor(Math.log10((most - least) / 100) + 1e-9)}`);
}
