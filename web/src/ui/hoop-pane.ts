// The pane of the hoop, and the handle that tilts its plane.

import { HULA_SECOND } from '../core/fields';
import type { Motion, Sample } from '../core/motion';
import { brief, byId, STILL } from '../dom';
import type { Palette } from '../generated/palette';
import { COLUMN_ROWS, QUANTITY_ROWS } from '../generated/tables';
import type { Lab, Landing } from '../state/lab';
import { type Camera, drawHoop, type HoopScene, seen } from '../views/hoop';
import { HoopWidget } from '../views/hoop-widget';
import type { Clock } from './clock';
import { sayStart, TEXTS } from './texts';

/** Steepest slope of the handle; that of the field is any below π/2. */
const STEEPEST = 1.5;

/** Closer to level than this the handle stays level. */
const SNAP = 0.03;

/** What an arrow key changes the slope by; a tenth of it with Shift. */
const KEY_STEP = 0.05;

/** Pixels about the line of the plane where a mouse takes it. */
const REACH = 9;

/** Pixels between the handle and the edge of the view. */
const EDGE = 26;

/** The motion that is pinned at an instant; none where it has ended. */
function pinnedAt(motion: Motion, time: number): { sample: Sample } | null {
  const sample = time <= motion.end ? motion.at(time) : null;
  return sample && { sample };
}

export class HoopPane {
  private readonly widget: HoopWidget;
  private readonly handle = byId('slope-handle', HTMLDivElement);
  private readonly ghost = byId('ghost', HTMLParagraphElement);

  constructor(
    private readonly lab: Lab,
    clock: Clock,
    private palette: Palette,
    private readonly isPlain: () => boolean,
    draw: () => void,
  ) {
    this.widget = new HoopWidget(
      byId('hoop', HTMLCanvasElement),
      {
        scene: () => this.scene,
        start: () => lab.plain,
        set: (start) => lab.setPlain(start),
        isFree: () => !lab.state.view.embed,
        grabbed: () => clock.pause(),
        released: () => {
          if (!STILL.matches) clock.play();
        },
        get second() {
          return lab.state.problem.system === 'si' ? lab.units.time : HULA_SECOND;
        },
        say: ({ theta, theta_rate }) => {
          const { system } = lab.state.problem;
          return sayStart(
            theta,
            theta_rate * lab.units.theta_rate,
            COLUMN_ROWS.theta_rate.units[system],
          );
        },
      },
      draw,
      TEXTS.page.weight_handle,
    );
    const follow = byId('follow', HTMLInputElement);
    follow.addEventListener('change', () => lab.setView({ follow: follow.checked }));
    this.listen();
  }

  /** The handle of the weight. */
  get weight(): HTMLElement {
    return this.widget.handle;
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
  }

  viewChanged(): void {
    byId('follow', HTMLInputElement).checked = this.lab.state.view.follow;
  }

  private get scene(): HoopScene {
    return this.sceneAt(this.lab.time);
  }

  private sceneAt(time: number): HoopScene {
    const { motion, plain, problem, state, units, pinned } = this.lab;
    const { landing } = this;
    const { system } = state.problem;
    const isPlain = this.isPlain();
    const force = 1 + plain.mass_ratio;
    const inUnits = `${TEXTS.page.weight}: ${brief(force * units.normal, 3)} ${COLUMN_ROWS.normal.units[system]}`;
    return {
      axis: { radius: units.x, unit: COLUMN_ROWS.x.units[system] },
      weight: { force, text: isPlain ? null : inUnits, name: TEXTS.page.weight },
      contact: state.view.embed || isPlain ? null : { ...plain, words: TEXTS.contact },
      symbols: state.view.symbols && !isPlain,
      isSecret: this.lab.isSecret,
      hidesArrows: this.lab.hidesArrows,
      pinned: pinned === null ? null : pinnedAt(pinned.motion, time),
      motion,
      sample: motion.at(time),
      offset: plain.offset,
      h: problem.h,
      slope: plain.slope,
      follow: state.view.follow,
      landing: landing && {
        predicted: typeof landing.predicted === 'string' ? null : landing.predicted,
        exact: landing.exact && motion.at(landing.exact.time),
      },
      palette: this.palette,
    };
  }

  /** The predicted landing, for who knows what that is. */
  private get landing(): Landing | null {
    return this.isPlain() ? null : this.lab.landing;
  }

  paint(): void {
    this.widget.paint();
    if (this.widget.size.width > 0) this.placeHandle(this.widget.camera);
    this.showGhost();
  }

  /** The predicted landing in words, beside the exact one. */
  private showGhost(): void {
    const {
      motion,
      units,
      state: {
        problem: { system },
      },
    } = this.lab;
    const { landing } = this;
    this.ghost.hidden = landing === null;
    if (landing === null) return;
    const { predicted, exact } = landing;
    const { time: tau, x } = COLUMN_ROWS;
    const say = (it: { x: number; time: number }): string =>
      `${x.signs[system]} = ${brief(it.x * units.x, 4)} ${x.units[system]}, ${tau.signs[system]} = ${brief(it.time * units.time, 4)} ${tau.units[system]}`;
    const now = exact && motion.at(exact.time);
    this.ghost.textContent = [
      typeof predicted === 'string'
        ? `No prediction: ${predicted}.`
        : `Landing to first order: ${say(predicted)}.`,
      now && exact
        ? `Exact: ${say({ x: now.x, time: exact.time })}.`
        : 'The motion no longer lands.',
    ].join(' ');
  }

  drawOn(c: CanvasRenderingContext2D, width: number, height: number, time = this.lab.time): void {
    drawHoop(c, { width, height }, this.sceneAt(time));
  }

  /** On the plane, at the right. */
  private placeHandle(camera: Camera): void {
    const [x, y] = camera.at(seen(camera, this.widget.size, EDGE)[1], 0);
    const { offsetLeft, offsetTop } = this.widget.canvas;
    this.handle.style.transform = `translate(${offsetLeft + x}px, ${offsetTop + y}px)`;
    const { slope } = this.lab.plain;
    for (const [name, value] of [
      ['valuemin', String(-STEEPEST)],
      ['valuemax', String(STEEPEST)],
      ['valuenow', String(slope)],
      [
        'valuetext',
        `${QUANTITY_ROWS.slope.sign} = ${brief(slope)} rad, ${brief((slope * 180) / Math.PI, 3)}°`,
      ],
    ] as const) {
      this.handle.setAttribute(`aria-${name}`, value);
    }
  }

  private listen(): void {
    const { handle } = this;
    const { canvas } = this.widget;
    const begin = (event: PointerEvent, target: HTMLElement): void => {
      event.preventDefault();
      handle.focus({ preventScroll: true });
      const box = canvas.getBoundingClientRect();
      const [x, y] = this.widget.camera.at(this.scene.sample?.x ?? 0, 0);
      /** The point about which the plane is turned: that under the hoop when the drag begins, from the side of the pointer. */
      const pivot = [box.left + x, box.top + y] as const;
      const side = event.clientX < pivot[0] ? -1 : 1;
      const move = (next: PointerEvent): void => {
        const slope = Math.atan2(
          side * (pivot[1] - next.clientY),
          Math.max(side * (next.clientX - pivot[0]), 0),
        );
        this.tilt(Math.abs(slope) < SNAP ? 0 : Number(slope.toFixed(3)));
      };
      const end = (): void => {
        target.removeEventListener('pointermove', move);
        target.removeEventListener('pointerup', end);
        target.removeEventListener('pointercancel', end);
      };
      target.setPointerCapture(event.pointerId);
      target.addEventListener('pointermove', move);
      target.addEventListener('pointerup', end);
      target.addEventListener('pointercancel', end);
    };
    handle.addEventListener('pointerdown', (event) => {
      if (event.button === 0) begin(event, handle);
    });
    canvas.addEventListener('pointerdown', (event) => {
      if (event.button === 0 && !event.defaultPrevented && this.isOnPlane(event))
        begin(event, canvas);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.style.cursor === '' && this.isOnPlane(event)) canvas.style.cursor = 'ns-resize';
    });
    handle.addEventListener('keydown', (event) => {
      const before = this.lab.plain.slope;
      const step = event.shiftKey ? KEY_STEP / 10 : KEY_STEP;
      const by = {
        ArrowLeft: -step,
        ArrowDown: -step,
        ArrowRight: step,
        ArrowUp: step,
        PageDown: -4 * step,
        PageUp: 4 * step,
      }[event.key];
      const to =
        by === undefined
          ? { Home: -STEEPEST, End: STEEPEST }[event.key]
          : Number((before + by).toFixed(6));
      if (to === undefined) return;
      event.preventDefault();
      this.tilt(before * to < 0 && by !== undefined ? 0 : to);
    });
  }

  /** Whether a mouse is on the line of the plane. A finger there may be about to scroll the page: it takes the handle. */
  private isOnPlane({ clientX, clientY, pointerType }: PointerEvent): boolean {
    if (pointerType === 'touch' || this.lab.state.view.embed || this.isPlain()) return false;
    const box = this.widget.canvas.getBoundingClientRect();
    const { at, sin, cos } = this.widget.camera;
    const [x, y] = at(0, 0);
    return Math.abs((clientX - box.left - x) * sin + (clientY - box.top - y) * cos) < REACH;
  }

  private tilt(slope: number): void {
    this.lab.setPlain({ slope: Math.min(Math.max(slope, -STEEPEST), STEEPEST) });
  }
}
