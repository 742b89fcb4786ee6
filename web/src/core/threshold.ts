// The value of a quantity at which the class of the motion changes, to the last digit.

import { CLASSES, CLASSES_IN_CONTACT, type Class } from '../generated/tables';
import type { ProblemState } from '../state/state';
import { problemIn } from '../state/state';
import { classOf, Problem, Refusal } from './wasm';

/** Neighbouring numbers with motions of two classes. */
export interface Threshold {
  below: { value: number; class: Class };
  above: { value: number; class: Class };
}

/** Steps in which the range of a slider is searched. */
const STEPS = 200;

/** The class of the motion of a problem; none of one that is refused. */
export function classIn(problem: ProblemState): Class | null {
  try {
    const core = problemIn(Problem, problem);
    const found = CLASSES[classOf(core)]!;
    core.free();
    return found;
  } catch (refusal) {
    if (!(refusal instanceof Refusal)) throw refusal;
    refusal.free();
    return null;
  }
}

/** What is in contact as far as it is followed may be any motion that stays in contact. */
function isSame(a: Class, b: Class): boolean {
  const isOpen = a === 'in_contact' || b === 'in_contact';
  return a === b || (isOpen && [a, b].every((it) => CLASSES_IN_CONTACT.includes(it)));
}

/** The numbers between which a search has found no threshold, and its steps. */
export interface NoThreshold {
  from: number;
  to: number;
  step: number;
}

/** Milliseconds of work between two looks at what else there is to do. */
const SLICE = 12;

/** The change of class in a range that is nearest to a value, or how far there is none. What is refused ends the search. */
export async function thresholdOf(
  { min, max }: { min: number; max: number },
  now: number,
  classOfMotion: (value: number) => Class | null,
): Promise<Threshold | NoThreshold> {
  let begin = performance.now();
  const classAt = async (value: number): Promise<Class | null> => {
    if (performance.now() - begin > SLICE) {
      await new Promise((resolve) => setTimeout(resolve));
      begin = performance.now();
    }
    return classOfMotion(value);
  };
  const here = await classAt(now);
  const step = (max - min) / STEPS;
  if (here === null) return { from: now, to: now, step };
  /** The last number of the class that this way is searched, and the first of another one, a step away. */
  const search = async (way: 1 | -1): Promise<{ inside: number; outside: number | null }> => {
    const end = way > 0 ? max : min;
    let inside = now;
    while (way * (end - inside) > 0) {
      const outside = way > 0 ? Math.min(inside + step, max) : Math.max(inside - step, min);
      const there = await classAt(outside);
      if (there === null) break;
      if (!isSame(here, there)) return { inside, outside };
      inside = outside;
    }
    return { inside, outside: null };
  };
  /** Down to neighbours, or to what a number next to 0 need not resolve. */
  const bisect = async (from: number, to: number): Promise<Threshold | null> => {
    let [inside, outside] = [from, to];
    const least = Number.EPSILON * step;
    for (;;) {
      const middle = inside + 0.5 * (outside - inside);
      if (middle === inside || middle === outside || Math.abs(outside - inside) < least) break;
      const there = await classAt(middle);
      if (there !== null && isSame(here, there)) inside = middle;
      else outside = middle;
    }
    const there = await classAt(outside);
    if (there === null) return null;
    const near = { value: inside, class: here };
    const far = { value: outside, class: there };
    return outside > inside ? { below: near, above: far } : { below: far, above: near };
  };
  const ways = [await search(-1), await search(1)] as const;
  const distance = ({ below }: Threshold): number => Math.abs(below.value - now);
  const found: Threshold[] = [];
  for (const { inside, outside } of ways) {
    const threshold = outside === null ? null : await bisect(inside, outside);
    if (threshold !== null) found.push(threshold);
  }
  return (
    found.sort((a, b) => distance(a) - distance(b))[0] ?? {
      from: ways[0].inside,
      to: ways[1].inside,
      step,
    }
  );
}
