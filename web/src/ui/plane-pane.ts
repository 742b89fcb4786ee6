// The pane of the phase plane: drawing in layers, and the start that can be dragged.

import { brief, byId, line, make } from '../dom';
import { CURVE_ROWS, CURVES, type Palette } from '../generated/palette';
import { CLASS_LABELS, COLUMN_ROWS } from '../generated/tables';
import { type HopClass, OutcomePicture } from '../map/client';
import type { Lab } from '../state/lab';
import { RATES, SHOWS, type Shows } from '../state/state';
import { Sheet, type Size } from '../views/canvas';
import {
  type Curves,
  curvesOf,
  drawMotion,
  drawPlane,
  drawStart,
  FROM,
  Frame,
  TO,
  wrapped,
} from '../views/plane';

const SIGNS = {
  theta: COLUMN_ROWS.theta.signs.dimensionless,
  rate: COLUMN_ROWS.theta_rate.signs.dimensionless,
};

/** Names of the maps. */
const SHOWN: Readonly<Record<Shows, string>> = { outcome: 'outcomes', hops: 'hops' };

/** What is in contact as far as the map follows it may roll for ever. */
const FOLLOWED = ' as far as it is followed';

/** What an arrow key moves the start by; a tenth of it with Shift. */
const KEY_STEP = 0.05;

export class PlanePane {
  readonly map: OutcomePicture;
  private readonly base: Sheet;
  private readonly top: Sheet;
  private readonly handle = byId('start-handle', HTMLButtonElement);
  private readonly legend = byId('legend', HTMLUListElement);
  private curves: Curves | null = null;
  /** What the map has been asked to show of the hoop; none if it has not been asked. */
  private asked: Shows | null = null;
  private stale = { base: true, top: true };
  private unit = 1;
  private symbols = true;

  constructor(
    private readonly lab: Lab,
    private palette: Palette,
    /** The simple view and a frame have no phase plane, and so no map is computed for them. */
    private readonly isShown: () => boolean,
    draw: () => void,
    failed: (message: string) => void,
  ) {
    const resized = (): void => {
      this.stale = { base: true, top: true };
      draw();
    };
    this.base = new Sheet(byId('plane-base', HTMLCanvasElement), resized);
    this.top = new Sheet(byId('plane-top', HTMLCanvasElement), resized);
    this.map = new OutcomePicture(
      palette,
      () => {
        this.stale.base = true;
        this.showLegend();
        draw();
      },
      failed,
    );
    this.listen();
    this.hoopChanged();
  }

  private get frame(): Frame {
    return this.frameOf(this.base.size);
  }

  private frameOf(size: Size): Frame {
    const { state, units } = this.lab;
    return new Frame(size, state.view.rate, units.theta_rate, state.problem.system);
  }

  private listen(): void {
    const pane = byId('plane', HTMLDivElement);
    const move = (event: PointerEvent): void => {
      const box = this.top.canvas.getBoundingClientRect();
      this.moveTo(
        this.frame.theta(event.clientX - box.left),
        this.frame.rateAt(event.clientY - box.top),
      );
    };
    pane.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      // A finger that begins beside the start may be about to scroll the page: it sets the start
      // where it taps.
      if (event.pointerType === 'touch' && event.target !== this.handle) return;
      event.preventDefault();
      pane.setPointerCapture(event.pointerId);
      this.handle.focus({ preventScroll: true });
      move(event);
    });
    pane.addEventListener('pointermove', (event) => {
      if (pane.hasPointerCapture(event.pointerId)) move(event);
    });
    pane.addEventListener('click', (event) => {
      if (event.pointerType !== 'touch' || event.target === this.handle) return;
      this.handle.focus({ preventScroll: true });
      const box = this.top.canvas.getBoundingClientRect();
      this.moveTo(
        this.frame.theta(event.clientX - box.left),
        this.frame.rateAt(event.clientY - box.top),
      );
    });
    this.handle.addEventListener('keydown', (event) => {
      const [right, up] = {
        ArrowLeft: [-1, 0],
        ArrowRight: [1, 0],
        ArrowUp: [0, 1],
        ArrowDown: [0, -1],
      }[event.key] ?? [0, 0];
      if (!right && !up) return;
      event.preventDefault();
      const step = event.shiftKey ? KEY_STEP / 10 : KEY_STEP;
      const [theta, rate] = this.start;
      const rounded = (value: number): number => Number(value.toFixed(6));
      this.moveTo(
        right ? rounded(theta + right * step) : theta,
        up ? rounded(rate + up * step) : rate,
      );
    });
    byId('zoom-in', HTMLButtonElement).addEventListener('click', () => this.zoom(-1));
    byId('zoom-out', HTMLButtonElement).addEventListener('click', () => this.zoom(1));
    const map = byId('map', HTMLInputElement);
    map.addEventListener('change', () => this.lab.setView({ map: map.checked }));
    const shows = byId('shows', HTMLSelectElement);
    shows.append(...SHOWS.map((value) => make('option', { value }, SHOWN[value])));
    shows.addEventListener('change', () => {
      this.lab.setView({ map: true, shows: SHOWS.find((it) => it === shows.value) ?? 'outcome' });
    });
  }

  private get start(): [number, number] {
    const { plain } = this.lab;
    return [plain.theta, plain.theta_rate];
  }

  private moveTo(theta: number, rate: number): void {
    const most = this.lab.state.view.rate;
    const within = (value: number, least: number, last: number): number =>
      Math.min(Math.max(value, least), last);
    // A pixel is coarser than the third decimal.
    const rounded = (value: number): number => Number(value.toFixed(3));
    this.lab.setPlain({
      theta: within(rounded(theta), FROM, TO),
      theta_rate: within(rounded(rate), -most, most),
    });
  }

  private zoom(way: number): void {
    const at = RATES.indexOf(this.lab.state.view.rate);
    const rate = RATES[at + way];
    if (rate !== undefined) this.lab.setView({ rate });
  }

  hoopChanged(): void {
    const {
      problem,
      state: {
        view: { rate },
      },
    } = this.lab;
    this.curves = curvesOf(problem, rate);
    this.showCurves();
    for (const entry of byId('curves', HTMLUListElement).querySelectorAll<HTMLElement>(
      '[data-curve]',
    )) {
      const curve = CURVES.find((it) => it === entry.dataset.curve);
      entry.hidden =
        curve === undefined
          ? this.curves.region.length === 0
          : this.curves.lines[curve].length === 0;
    }
    this.asked = null;
    this.askMap();
    this.stale = { base: true, top: true };
  }

  private askMap(): void {
    const {
      problem,
      state: {
        view: { map, rate, shows },
      },
    } = this.lab;
    if (!this.isShown() || !map || this.asked === shows) return;
    this.asked = shows;
    const { restitution, restitutionLaw: law } = problem;
    this.map.ask({ numbers: problem.toDimensionless(), restitution, law, rate, shows });
  }

  motionChanged(): void {
    this.stale.top = true;
    // The axis of the rates has the units that are shown.
    if (this.unit !== this.lab.units.theta_rate) {
      this.unit = this.lab.units.theta_rate;
      this.stale.base = true;
    }
  }

  viewChanged(): void {
    const { view } = this.lab.state;
    const rateChanged = this.curves?.rate !== view.rate;
    byId('map', HTMLInputElement).checked = view.map;
    byId('shows', HTMLSelectElement).value = view.shows;
    const place = RATES.indexOf(view.rate);
    byId('zoom-in', HTMLButtonElement).disabled = place <= 0;
    byId('zoom-out', HTMLButtonElement).disabled = place >= RATES.length - 1;
    if (rateChanged) this.hoopChanged();
    else this.askMap();
    if (this.symbols !== view.symbols) {
      this.symbols = view.symbols;
      this.stale.base = true;
    }
    if (this.legend.hidden === view.map) {
      this.legend.hidden = !view.map;
      this.stale.base = true;
    }
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.map.setPalette(palette);
    this.stale = { base: true, top: true };
  }

  private showCurves(): void {
    const curves = CURVES.map((name) => {
      const { label, labelOnSlope, meaning, dash, width } = CURVE_ROWS[name];
      const shown = this.lab.plain.slope === 0 ? label : labelOnSlope;
      return make(
        'li',
        { 'data-curve': name, ...(meaning === null ? {} : { title: meaning }) },
        line(width, dash),
        shown,
      );
    });
    const region = make(
      'li',
      { 'data-curve': 'region' },
      make('span', { class: 'swatch region', 'aria-hidden': 'true' }),
      '𝓡, hatched: it can roll here',
    );
    byId('curves', HTMLUListElement).replaceChildren(...curves, region);
  }

  private showLegend(): void {
    const swatch = (): HTMLElement => make('span', { class: 'swatch', 'aria-hidden': 'true' });
    const computed = this.map.present.filter((name) => name !== 'not_computed');
    const hops = this.map.hops.map((it) =>
      make('li', { 'data-hops': String(it.colour) }, swatch(), labelOfHops(it)),
    );
    this.legend.replaceChildren(
      ...computed.map((name) =>
        make(
          'li',
          { 'data-class': name },
          swatch(),
          CLASS_LABELS[name],
          name === 'in_contact' ? FOLLOWED : '',
        ),
      ),
      ...hops,
    );
    this.legend.setAttribute(
      'aria-label',
      hops.length > 0 ? 'Colours of the map: number of landings' : 'Colours of the outcome map',
    );
  }

  /** Draws what is stale. */
  paint(): void {
    if (!this.curves || this.base.size.width === 0) return;
    const { frame, palette } = this;
    if (this.stale.base) {
      const { map: isMapped, symbols } = this.lab.state.view;
      const map = isMapped ? this.map.picture : null;
      drawPlane(this.base.clear(), frame, {
        curves: this.curves,
        map,
        mapSize: this.map.side,
        palette,
        symbols,
      });
    }
    if (this.stale.top) {
      drawMotion(
        this.top.clear(),
        frame,
        this.lab.motion,
        this.lab.motion.at(this.lab.time),
        palette,
      );
      this.placeHandle(frame);
    }
    this.stale = { base: false, top: false };
  }

  private placeHandle(frame: Frame): void {
    const [theta, rate] = this.start;
    const shown = Math.min(Math.max(rate, -frame.rate), frame.rate);
    this.handle.style.transform = `translate(${frame.x(wrapped(theta))}px, ${frame.y(shown)}px)`;
    this.handle.setAttribute(
      'aria-label',
      `Start: ${SIGNS.theta} = ${brief(theta)}, ${SIGNS.rate} = ${brief(rate)}. The arrow keys move it, with Shift in finer steps.`,
    );
  }

  /** The whole pane on another context, for export. */
  drawOn(c: CanvasRenderingContext2D, width: number, height: number): void {
    if (!this.curves) return;
    const frame = this.frameOf({ width, height });
    const map = this.lab.state.view.map ? this.map.picture : null;
    drawPlane(c, frame, {
      curves: this.curves,
      map,
      mapSize: this.map.side,
      palette: this.palette,
      symbols: this.lab.state.view.symbols,
    });
    drawMotion(c, frame, this.lab.motion, this.lab.motion.at(this.lab.time), this.palette);
    // On the screen the start is a button.
    const [theta, rate] = this.start;
    drawStart(c, frame, theta, rate, this.palette);
  }
}

function labelOfHops({ least, most }: HopClass): string {
  if (most === 0) return 'no landing';
  if (most === 1) return '1 landing';
  return least === most ? String(least) : `${least}–${most}`;
}
