// The rates, the normal force, the friction and the energy against time.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { ColumnUnits, Motion, Samples } from '../core/motion';
import { roundTicks, type Tick } from '../core/ticks';
import { make as element } from '../dom';
import type { Palette } from '../generated/palette';
import { COLUMN_ROWS, type SampleColumn, type System } from '../generated/tables';
import { FONT } from './font';

/** A curve against time: a column, or what is computed from some. */
export interface Subject {
  id: string;
  signs: Readonly<Record<System, string>>;
  meaning: string;
  units: Readonly<Record<System, string>>;
  values(samples: Samples, units: ColumnUnits, motion: Motion): (number | null)[];
  /** What it must not exceed, if there is such a thing. */
  bound?: (shown: Pick<Shown, 'available'>) => number;
}

/** Pixels of an axis beside its numbers, and of one of their digits. */
const AXIS = 12;
const DIGIT = 8;

/** Pixels between two ticks of that axis at least, and of the axis of the time without its digits. */
const SPACE = 28;
const SPACE_OF_TIME = 18;

/** Its ticks, with as many digits as tell them apart. */
function ticksOf(least: number, most: number, { height }: uPlot.BBox): Tick[] {
  return roundTicks(least, most, Math.max(2, Math.floor(height / uPlot.pxRatio / SPACE)));
}

/** The ticks of the time, as many as stand beside each other. */
function ticksOfTime(least: number, most: number, width: number): Tick[] {
  for (let count = 9; count > 2; count--) {
    const ticks = roundTicks(least, most, count);
    const digits = Math.max(...ticks.map(({ label }) => label.length), 0);
    if (ticks.length * (SPACE_OF_TIME + DIGIT * digits) <= width) return ticks;
  }
  return roundTicks(least, most, 2);
}

/** The line of a bound, in pixels. */
export const BOUND_DASH = [3, 3] as const;

/** What a motion is shown as. */
export interface Shown {
  motion: Motion;
  units: ColumnUnits;
  system: System;
  /** A motion to compare with. */
  pinned: Motion | null;
  /** The coefficient of static friction of the ground. */
  available: number;
}

function column(name: SampleColumn): Subject {
  const { signs, units, longName } = COLUMN_ROWS[name];
  const values: Subject['values'] = (samples, scale) =>
    Array.from(samples[name], (value) => (Number.isFinite(value) ? value * scale[name] : null));
  return { id: name, signs, meaning: longName, units, values };
}

/** The coefficient of friction that the forces need. */
const demand: Subject = {
  id: 'demand',
  signs: { dimensionless: '|F|/N', si: '|F|/N' },
  meaning: 'friction force over normal force; dashed, what the ground can give',
  bound: ({ available }) => available,
  units: { dimensionless: '', si: '' },
  values: ({ normal, friction }) =>
    Array.from(normal, (force, i) => {
      const ratio = Math.abs(friction[i]!) / force;
      return force > 0 && Number.isFinite(ratio) ? ratio : null;
    }),
};

export const SUBJECTS: readonly Subject[] = [
  column('theta_rate'),
  column('slip'),
  column('normal'),
  demand,
  column('energy'),
];

/** What a subject of the pinned motion is at the times of another one; none after its end. */
export function valuesOfPinned(
  pinned: Motion,
  subject: Subject,
  times: Float64Array,
  units: ColumnUnits,
): (number | null)[] {
  const values = subject.values(pinned.samples, units, pinned);
  return Array.from(times, (time) =>
    time > pinned.end ? null : interpolate(pinned.samples.time, values, time),
  );
}

interface Plot {
  subject: Subject;
  box: HTMLElement;
  sign: HTMLElement;
  value: HTMLElement;
  unit: HTMLElement;
  cursor: HTMLElement;
  chart: uPlot;
}

export class Plots {
  private readonly plots: Plot[];
  private palette: Palette;
  private columns: uPlot.AlignedData[] = [];
  private shown: Shown | null = null;
  private time = 0;

  constructor(
    holder: HTMLElement,
    palette: Palette,
    private readonly scrub: (time: number) => void,
  ) {
    this.palette = palette;
    this.plots = SUBJECTS.map((subject) => this.make(holder, subject));
    // Not within the observer: the charts change the size of what is observed.
    new ResizeObserver(() => requestAnimationFrame(() => this.resize())).observe(holder);
  }

  private make(holder: HTMLElement, subject: Subject): Plot {
    const sign = element('i');
    const value = element('output', { 'data-plot': subject.id });
    const unit = element('span', { class: 'unit' });
    const caption = element(
      'figcaption',
      {},
      sign,
      ' ',
      element('span', { class: 'meaning' }, subject.meaning),
      value,
      unit,
    );
    const box = element('div', { class: 'chart' });
    const cursor = element('div', { class: 'cursor' });
    holder.append(element('figure', { class: 'plot', 'data-subject': subject.id }, caption, box));
    const chart = this.chart(box, subject);
    chart.over.append(cursor);
    this.listen(chart);
    return { subject, box, sign, value, unit, cursor, chart };
  }

  private chart(box: HTMLElement, subject: Subject): uPlot {
    const axis = {
      stroke: () => this.palette.ink.ink,
      font: `12px ${FONT}`,
      grid: { stroke: () => this.palette.ink.line, width: 1 },
      ticks: { stroke: () => this.palette.ink.line, width: 1, size: 4 },
    };
    return new uPlot(
      {
        width: Math.max(box.clientWidth, 50),
        height: Math.max(box.clientHeight, 50),
        padding: [8, 10, 0, 0],
        legend: { show: false },
        cursor: { show: false },
        scales: { x: { time: false }, y: { range: (_, least, most) => rangeOf(least, most) } },
        axes: [
          {
            ...axis,
            size: 26,
            gap: 2,
            splits: ({ bbox }, _, least, most) =>
              ticksOfTime(least, most, bbox.width / uPlot.pxRatio).map(({ value }) => value),
            values: ({ bbox, scales: { x } }) =>
              ticksOfTime(x?.min ?? 0, x?.max ?? 0, bbox.width / uPlot.pxRatio).map(
                ({ label }) => label,
              ),
          },
          {
            ...axis,
            splits: ({ bbox }, _, least, most) =>
              ticksOf(least, most, bbox).map(({ value }) => value),
            size: (_, texts) => AXIS + DIGIT * Math.max(0, ...(texts ?? []).map((it) => it.length)),
            gap: 3,
            values: ({ bbox, scales: { y } }) =>
              ticksOf(y?.min ?? 0, y?.max ?? 0, bbox).map(({ label }) => label),
          },
        ],
        series: [
          {},
          {
            label: subject.id,
            width: 2,
            stroke: () => this.palette.ink.ink,
            points: { show: false },
            spanGaps: false,
            pxAlign: 0,
          },
          {
            label: 'pinned',
            width: 2,
            dash: [6, 4],
            stroke: () => this.palette.accent.teal,
            points: { show: false },
            spanGaps: false,
            pxAlign: 0,
          },
          {
            label: 'bound',
            width: 1.5,
            dash: [...BOUND_DASH],
            stroke: () => this.palette.arrow.friction_force,
            points: { show: false },
            pxAlign: 0,
          },
        ],
        hooks: { drawClear: [(chart) => this.bands(chart)] },
      },
      [
        [0, 1],
        [0, 0],
        [null, null],
        [null, null],
      ],
      box,
    );
  }

  /** The modes as bands behind the curve. */
  private bands(chart: uPlot): void {
    if (!this.shown) return;
    const { ctx, bbox } = chart;
    const {
      motion,
      units: { time: unit },
    } = this.shown;
    ctx.save();
    ctx.globalAlpha = 0.16;
    for (const phase of motion.phases) {
      const from = chart.valToPos(unit * Math.max(phase.start, motion.begin), 'x', true);
      const to = chart.valToPos(unit * Math.min(phase.end, motion.end), 'x', true);
      ctx.fillStyle = this.palette.mode[phase.mode];
      ctx.fillRect(from, bbox.top, to - from, bbox.height);
    }
    ctx.restore();
  }

  private listen(chart: uPlot): void {
    const { over } = chart;
    const move = (event: PointerEvent): void => {
      const { left } = over.getBoundingClientRect();
      if (this.shown) this.scrub(chart.posToVal(event.clientX - left, 'x') / this.shown.units.time);
    };
    over.addEventListener('pointerdown', (event) => {
      over.setPointerCapture(event.pointerId);
      move(event);
    });
    over.addEventListener('pointermove', (event) => {
      if (over.hasPointerCapture(event.pointerId)) move(event);
    });
  }

  private resize(): void {
    for (const { chart, box } of this.plots) {
      if (box.clientWidth > 0) chart.setSize({ width: box.clientWidth, height: box.clientHeight });
    }
    this.setTime(this.time);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const { chart } of this.plots) chart.redraw(false, true);
  }

  setMotion(shown: Shown): void {
    this.shown = shown;
    const {
      motion,
      motion: { samples },
      pinned,
      units,
      system,
    } = shown;
    const time = Array.from(samples.time, (it) => it * units.time);
    this.columns = this.plots.map(({ subject }) => [
      time,
      subject.values(samples, units, motion),
      pinned === null ? time.map(() => null) : valuesOfPinned(pinned, subject, samples.time, units),
      time.map(() => subject.bound?.(shown) ?? null),
    ]);
    this.plots.forEach(({ chart, sign, unit, subject }, i) => {
      sign.textContent = subject.signs[system];
      unit.textContent = subject.units[system];
      chart.setData(this.columns[i]!);
    });
  }

  /** Puts the cursor of every plot to a time. */
  setTime(time: number): void {
    this.time = time;
    if (!this.shown) return;
    const {
      motion: { begin, end },
      units,
    } = this.shown;
    const shown = time * units.time;
    this.plots.forEach(({ chart, cursor, value }, i) => {
      // Not valToPos: the library takes new scales only after this.
      const width = chart.bbox.width / uPlot.pxRatio;
      cursor.style.transform = `translateX(${((time - begin) / (end - begin || 1)) * width}px)`;
      const [times, values] = (this.columns[i] as [number[], (number | null)[]] | undefined) ?? [
        [],
        [],
      ];
      const at = interpolate(times, values, shown);
      value.textContent = at === null ? '–' : at.toFixed(3).replace('-', '−');
    });
  }
}

/** A range with a little air; a constant is shown in the middle. */
export function rangeOf(least: number | null, most: number | null): [number, number] {
  if (least === null || most === null) return [0, 1];
  const span = most - least;
  const air =
    span > 1e-9 * Math.max(1, Math.abs(most)) ? 0.08 * span : Math.max(0.5, 0.1 * Math.abs(most));
  return [least - air, most + air];
}

function interpolate(
  times: ArrayLike<number>,
  values: (number | null)[],
  time: number,
): number | null {
  let [low, high] = [0, times.length - 1];
  if (high < 0) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle;
    else high = middle;
  }
  const [a, b] = [values[low] ?? null, values[high] ?? null];
  const span = times[high]! - times[low]!;
  if (a === null || b === null || span === 0) return time >= times[high]! ? b : a;
  return a + ((b - a) * (time - times[low]!)) / span;
}
