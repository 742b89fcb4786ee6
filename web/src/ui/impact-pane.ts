// The impact that is shown: what happens in it, Routh's diagram, and its numbers.

import { type ImpactEvent, type Routh, VELOCITIES } from '../core/motion';
import { brief, byId, line, make } from '../dom';
import { IMPULSE_LINE_ROWS, type ImpulseLine, type Palette } from '../generated/palette';
import { COLUMN_ROWS, IMPULSE_UNITS } from '../generated/tables';
import type { Lab } from '../state/lab';
import { Sheet } from '../views/canvas';
import { drawRouth } from '../views/routh';

/** The lines of the legend. */
const LINES = ['sticking', 'greatest_compression'] as const satisfies readonly ImpulseLine[];

/** A line in the legend. */
function entry(name: ImpulseLine): HTMLLIElement {
  const { label, dash, width } = IMPULSE_LINE_ROWS[name];
  return make('li', { 'data-impulse': name }, line(width, dash), label);
}

export class ImpactPane {
  private readonly pane = byId('impact', HTMLElement);
  private readonly sheet: Sheet;
  private readonly picture = byId('routh-figure', HTMLElement);
  private readonly rows = byId('impact-numbers', HTMLTableSectionElement);
  private readonly previous = byId('previous-impact', HTMLButtonElement);
  private readonly next = byId('next-impact', HTMLButtonElement);
  private readonly legend = {
    sticking: entry('sticking'),
    greatest_compression: entry('greatest_compression'),
  };
  private shown: ImpactEvent | null = null;
  private routh: Routh | null = null;
  private stale = true;

  constructor(
    private readonly lab: Lab,
    private palette: Palette,
    draw: () => void,
    private readonly go: (time: number) => void,
  ) {
    this.sheet = new Sheet(byId('routh', HTMLCanvasElement), () => {
      this.stale = true;
      draw();
    });
    byId('routh-lines', HTMLUListElement).replaceChildren(
      make('li', { 'data-arrow': 'impulse' }, line(3.5, []), 'the impact'),
      ...LINES.map((name) => this.legend[name]),
    );
    this.previous.addEventListener('click', () => this.step(-1));
    this.next.addEventListener('click', () => this.step(1));
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.stale = true;
  }

  private step(way: 1 | -1): void {
    const {
      time,
      motion: { impacts },
    } = this.lab;
    const found =
      way > 0 ? impacts.find((it) => it.time > time) : impacts.findLast((it) => it.time < time);
    if (found) this.go(found.time);
  }

  showMotion(): void {
    this.pane.hidden = this.lab.problem.restitution === undefined;
    this.shown = null;
    this.showTime();
  }

  showTime(): void {
    const {
      time,
      impact,
      motion: { impacts },
    } = this.lab;
    this.previous.disabled = !impacts.some((it) => it.time < time);
    this.next.disabled = !impacts.some((it) => it.time > time);
    if (impact === this.shown && impact !== null) return;
    this.shown = impact;
    this.routh = impact === null ? null : this.lab.motion.routh(impact);
    this.stale = true;
    this.showWords();
    this.showNumbers();
    this.picture.hidden = this.routh === null;
    // With rolling resistance, whose couple bends the lines, the picture has the way alone.
    for (const name of LINES) {
      const ends = name === 'sticking' ? this.routh?.sticking : this.routh?.compression;
      this.legend[name].hidden = !ends?.length;
    }
    byId('impact-diagram', HTMLElement).hidden = impact === null;
  }

  private showWords(): void {
    const {
      shown,
      lab: {
        motion: { impacts },
        units,
        state: {
          problem: { system },
        },
      },
    } = this;
    const {
      signs,
      units: { si },
    } = COLUMN_ROWS.time;
    const place =
      shown === null
        ? ''
        : `${impacts.indexOf(shown) + 1} of ${impacts.length}${
            shown.name === 'settle' ? ', all smaller ones together' : ''
          }, ${signs[system]} = ${brief(
            shown.time * units.time,
            6,
          )}${system === 'si' ? ` ${si}` : ''}`;
    byId('impact-place', HTMLElement).textContent = place;
    byId('impact-sentence', HTMLElement).textContent =
      shown === null ? 'The rim does not land in this motion.' : shown.sentence;
  }

  private showNumbers(): void {
    const {
      shown,
      lab: {
        units,
        problem,
        state: {
          problem: { system },
        },
      },
    } = this;
    if (shown === null) {
      this.rows.replaceChildren();
      return;
    }
    const { before, after, normal, friction, lost, label } = shown.impact;
    const row = (name: string, sign: string, unit: string, ...values: number[]): HTMLElement =>
      make(
        'tr',
        { 'data-quantity': name },
        make(
          'th',
          { scope: 'row' },
          make('i', {}, sign),
          unit === '' ? '' : make('span', { class: 'unit' }, ` ${unit}`),
        ),
        ...values.map((value) =>
          make(
            'td',
            { ...(values.length === 1 ? { colspan: '2' } : {}), 'data-value': String(value) },
            brief(value, 6),
          ),
        ),
      );
    const unit = IMPULSE_UNITS[system];
    this.rows.replaceChildren(
      make('tr', {}, make('th', { scope: 'row' }, 'course'), make('td', { colspan: '2' }, label)),
      ...VELOCITIES.map((name) =>
        row(
          name,
          COLUMN_ROWS[name].signs[system],
          COLUMN_ROWS[name].units[system],
          ...[before[name], after[name]].map((it) => it * units[name]),
        ),
      ),
      row('normal_impulse', 'P', unit, normal * problem.impulseUnit),
      row('friction_impulse', 'J', unit, friction * problem.impulseUnit),
      row(
        'energy_lost',
        lost < 0 ? 'energy gained' : 'energy lost',
        COLUMN_ROWS.energy.units[system],
        Math.abs(lost) * units.energy,
      ),
    );
  }

  /** Draws the diagram if it is stale. */
  paint(): void {
    if (!this.stale || this.pane.hidden || this.routh === null || this.sheet.size.width === 0)
      return;
    this.stale = false;
    this.drawOn(this.sheet.clear(), this.sheet.size.width, this.sheet.size.height);
    const {
      shown,
      lab: { problem },
    } = this;
    const { normal: p = 0, friction: j = 0 } = shown?.impact ?? {};
    Object.assign(this.sheet.canvas.dataset, { normal: String(p), friction: String(j) });
    this.sheet.canvas.setAttribute(
      'aria-label',
      `Routh's diagram: from the origin the impulse goes to P = ${brief(p * problem.impulseUnit)}, J = ${brief(
        j * problem.impulseUnit,
      )}. The contact ${shown?.impact.label ?? ''}.`,
    );
  }

  /** Routh's diagram on another context, for export. */
  drawOn(c: CanvasRenderingContext2D, width: number, height: number): void {
    const {
      routh,
      palette,
      lab: {
        problem,
        state: {
          problem: { system },
        },
      },
    } = this;
    if (routh)
      drawRouth(
        c,
        { width, height },
        { routh, scale: problem.impulseUnit, unit: IMPULSE_UNITS[system], palette },
      );
  }
}
