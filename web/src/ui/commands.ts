// The same motion as a line for a shell, and as lines of Python.

import { fieldsOf } from '../core/fields';
import { caseOfProblem, type NamedCase, type ProblemState } from '../state/state';

/** `littlewood simulate …` with the very numbers of the page. */
export function shellLine(problem: ProblemState, cases: readonly NamedCase[]): string {
  const named = caseOfProblem(problem, cases);
  if (named) return `littlewood simulate ${named.name}`;
  const flags = fieldsOf(problem.system)
    .map((field, i) => ({ field, value: problem.numbers[i]! }))
    .filter(({ field, value }) => !(ZERO.has(field.name) && Object.is(value, 0)))
    .map(({ field, value }) => `--${field.name.replaceAll('_', '-')} ${value}`);
  if (problem.until !== null) flags.push(`${problem.system === 'si' ? '--until-s' : '--until'} ${problem.until}`);
  return `littlewood simulate ${flags.join(' ')}`;
}

/** The same with the Python package. */
export function pythonLine(problem: ProblemState, cases: readonly NamedCase[]): string {
  const named = caseOfProblem(problem, cases);
  if (named) return `import littlewood as lw; motion = lw.case("${named.name}").simulate()`;
  const si = problem.system === 'si';
  const pairs = fieldsOf(problem.system).map((field, i) => ({ field, value: problem.numbers[i]! }));
  const list = (start: boolean): string[] =>
    pairs
      .filter(({ field }) => (field.group === 'hoop') !== start)
      .filter(({ field, value }) => !(ZERO.has(field.name) && Object.is(value, 0)))
      .map(({ field, value }) => `${si && field.name === 'theta' ? 'theta_rad' : field.name}=${value}`);
  const start = list(true);
  if (problem.until !== null) start.push(`${si ? 'until_s' : 'until'}=${problem.until}`);
  const hoop = `lw.Hoop${si ? '.from_si' : ''}(${list(false).join(', ')})`;
  return `import littlewood as lw; motion = ${hoop}.${si ? 'simulate_si' : 'simulate'}(${start.join(', ')})`;
}

/** What is zero unless it is given. */
const ZERO = new Set(['slip', 'x', 'time', 'slip_m_per_s', 'x_m', 'time_s']);
