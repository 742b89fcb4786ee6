// The same motion as a line for a shell, and as lines of Python.

import { LIMIT, numbersOf } from '../core/fields';
import { type Group, LAWS, type Law, QUANTITY_ROWS, type Quantity } from '../generated/tables';

import { lawOf, numberOf, type ProblemState } from '../state/state';
import { caseOf } from '../state/url';

/** `littlewood simulate …` with the very numbers of the page. */
export function shellLine(problem: ProblemState): string {
  const named = caseOf(problem);
  if (named) return `littlewood simulate ${named}`;
  const flags = given(problem).map(
    ([quantity, value]) => `--${quantity.replaceAll('_', '-')} ${value}`,
  );
  const law = otherLaw(problem);
  if (law !== null) flags.push(`--restitution-law ${law}`);
  return `littlewood simulate ${flags.join(' ')}`;
}

/** The same with the Python package. */
export function pythonLine(problem: ProblemState): string {
  const named = caseOf(problem);
  if (named) return `import littlewood as lw; motion = lw.case("${named}").simulate()`;
  const si = problem.system === 'si';
  // In Python every number of a start in SI units has its unit in its name, the angle too.
  const nameOf = (quantity: Quantity): string =>
    si && quantity === 'theta' ? 'theta_rad' : quantity;
  const list = (argument: 'hoop' | 'start'): string =>
    given(problem)
      .filter(([quantity]) => ARGUMENT[QUANTITY_ROWS[quantity].group] === argument)
      .map(([quantity, value]) => `${nameOf(quantity)}=${value}`)
      .join(', ');
  const law = otherLaw(problem);
  const hoop = `lw.Hoop${si ? '.from_si' : ''}(${list('hoop')}${law === null ? '' : `, restitution_law="${law}"`})`;
  return `import littlewood as lw; motion = ${hoop}.${si ? 'simulate_si' : 'simulate'}(${list('start')})`;
}

/** Which function of the Python package takes the quantities of a group. */
const ARGUMENT: Readonly<Record<Group, 'hoop' | 'start'>> = {
  hoop: 'hoop',
  units: 'hoop',
  start: 'start',
  place: 'start',
  run: 'start',
};

/** The law of restitution, if it is not that of a coefficient alone. */
function otherLaw(problem: ProblemState): Law | null {
  const law = lawOf(problem);
  return law === LAWS[0] ? null : law;
}

/** The quantities of a problem that are not what they are if nothing is given. */
function given(problem: ProblemState): [Quantity, number][] {
  const { system } = problem;
  return [...numbersOf(system), 'restitution' as const, LIMIT[system]].flatMap(
    (quantity): [Quantity, number][] => {
      const value = numberOf(problem, quantity);
      return value === null || Object.is(value, QUANTITY_ROWS[quantity].otherwise)
        ? []
        : [[quantity, value]];
    },
  );
}
