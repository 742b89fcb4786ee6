// θ′, η′, N, |F|/N and the energy against time.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Motion, Samples } from '../core/motion';
import { FONT, type Palette } from './palette';

/** What a dimensionless value is worth in the units that are shown; ones without dimension. */
export interface Scales {
  time: number;
  rate: number;
  velocity: number;
  force: number;
  energy: number;
}

export interface Quantity {
  id: string;
  title: string;
  /** What it is, for the tip and the reader of a screen. */
  meaning: string;
  /** Unit, dimensionless and in SI. */
  units: [string, string];
  values(samples: Samples, scales: Scales): (number | null)[];
}

const scaled = (values: Float64Array, unit: number): (number | null)[] =>
  Array.from(values, (value) => (Number.isFinite(value) ? value * unit : null));

export const QUANTITIES: readonly Quantity[] = [
  { id: 'theta_rate', title: 'θ′', meaning: 'turning rate', units: ['√(g/R)', 'rad/s'],
    values: (s, { rate }) => scaled(s.theta_rate, rate) },
  { id: 'slip', title: 'η′', meaning: 'slip velocity', units: ['√(gR)', 'm/s'],
    values: (s, { velocity }) => scaled(s.slip, velocity) },
  { id: 'normal', title: 'N', meaning: 'normal force', units: ['m₂g', 'N'], values: (s, { force }) => scaled(s.normal, force) },
  { id: 'demand', title: '|F|/N', meaning: 'friction', units: ['', ''], values: demand },
  { id: 'energy', title: 'E', meaning: 'energy', units: ['m₂gR', 'J'], values: (s, { energy }) => scaled(s.energy, energy) },
];

function demand(samples: Samples): (number | null)[] {
  return Array.from(samples.normal, (normal, i) => {
    const ratio = Math.abs(samples.friction[i]!) / normal;
    return normal > 0 && Number.isFinite(ratio) ? ratio : null;
  });
}

interface Plot {
  quantity: Quantity;
  box: HTMLElement;
  value: HTMLElement;
  unit: HTMLElement;
  cursor: HTMLElement;
  chart: uPlot;
}

export class Plots {
  private readonly plots: Plot[];
  private palette: Palette;
  private columns: uPlot.AlignedData[] = [];
  private motion: Motion | null = null;
  private scales: Scales | null = null;

  constructor(holder: HTMLElement, palette: Palette, private readonly scrub: (time: number) => void) {
    this.palette = palette;
    this.plots = QUANTITIES.map((quantity) => this.make(holder, quantity));
    // Not within the observer: the charts change the size of what is observed.
    new ResizeObserver(() => requestAnimationFrame(() => this.resize())).observe(holder);
  }

  private make(holder: HTMLElement, quantity: Quantity): Plot {
    const figure = document.createElement('figure');
    figure.className = 'plot';
    const caption = document.createElement('figcaption');
    caption.innerHTML = `<i>${quantity.title}</i> <span class="meaning">${quantity.meaning}</span>`;
    const unit = document.createElement('span');
    unit.className = 'unit';
    const value = document.createElement('output');
    value.dataset['plot'] = quantity.id;
    caption.append(value, unit);
    const box = document.createElement('div');
    box.className = 'chart';
    const cursor = document.createElement('div');
    cursor.className = 'cursor';
    figure.append(caption, box);
    holder.append(figure);
    const chart = this.chart(box, quantity);
    chart.over.append(cursor);
    this.listen(chart);
    return { quantity, box, value, unit, cursor, chart };
  }

  private chart(box: HTMLElement, quantity: Quantity): uPlot {
    const axis = {
      stroke: () => this.palette.ink, font: `12px ${FONT}`, grid: { stroke: () => this.palette.line, width: 1 },
      ticks: { stroke: () => this.palette.line, width: 1, size: 4 },
    };
    return new uPlot({
      width: Math.max(box.clientWidth, 50),
      height: Math.max(box.clientHeight, 50),
      padding: [8, 10, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false }, y: { range: (_, least, most) => rangeOf(least, most) } },
      axes: [
        { ...axis, size: 26, gap: 2, space: 50 },
        { ...axis, size: 44, gap: 3, space: 28, values: (_, ticks) => ticks.map((it) => String(Number(it.toPrecision(4))).replace('-', '−')) },
      ],
      series: [{}, {
        label: quantity.title, width: 2, stroke: () => this.palette.ink, points: { show: false }, spanGaps: false, pxAlign: 0,
      }],
      hooks: { drawClear: [(chart) => this.bands(chart)] },
    }, [[0, 1], [0, 0]], box);
  }

  /** The modes as bands behind the curve. */
  private bands(chart: uPlot): void {
    if (!this.motion || !this.scales) return;
    const { ctx, bbox } = chart;
    const unit = this.scales.time;
    ctx.save();
    ctx.globalAlpha = 0.16;
    for (const phase of this.motion.phases) {
      const from = chart.valToPos(unit * Math.max(phase.start, this.motion.begin), 'x', true);
      const to = chart.valToPos(unit * Math.min(phase.end, this.motion.end), 'x', true);
      ctx.fillStyle = this.palette.mode[phase.mode];
      ctx.fillRect(from, bbox.top, to - from, bbox.height);
    }
    ctx.restore();
  }

  private listen(chart: uPlot): void {
    const { over } = chart;
    const move = (event: PointerEvent): void => {
      const { left } = over.getBoundingClientRect();
      this.scrub(chart.posToVal(event.clientX - left, 'x') / (this.scales?.time ?? 1));
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
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const { chart } of this.plots) chart.redraw(false, true);
  }

  setMotion(motion: Motion, scales: Scales, si: boolean): void {
    this.motion = motion;
    this.scales = scales;
    const time = Array.from(motion.samples.time, (it) => it * scales.time);
    this.columns = this.plots.map(({ quantity }) => [time, quantity.values(motion.samples, scales)]);
    this.plots.forEach(({ chart, unit, quantity }, i) => {
      unit.textContent = quantity.units[si ? 1 : 0];
      chart.setData(this.columns[i]!);
    });
  }

  /** Puts the cursor of every plot to a time. */
  setTime(time: number): void {
    if (!this.motion || !this.scales) return;
    const { begin, end } = this.motion;
    const shown = time * this.scales.time;
    this.plots.forEach(({ chart, cursor, value }, i) => {
      // Not valToPos: the library takes new scales only after this.
      const width = chart.bbox.width / uPlot.pxRatio;
      cursor.style.transform = `translateX(${((time - begin) / (end - begin || 1)) * width}px)`;
      const [times, values] = this.columns[i] as [number[], (number | null)[]] | undefined ?? [[], []];
      const at = interpolate(times, values, shown);
      value.textContent = at === null ? '–' : at.toFixed(3).replace('-', '−');
    });
  }
}

/** A range with a little air; a constant is shown in the middle. */
export function rangeOf(least: number | null, most: number | null): [number, number] {
  if (least === null || most === null) return [0, 1];
  const span = most - least;
  const air = span > 1e-9 * Math.max(1, Math.abs(most)) ? 0.08 * span : Math.max(0.5, 0.1 * Math.abs(most));
  return [least - air, most + air];
}

function interpolate(times: number[], values: (number | null)[], time: number): number | null {
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
