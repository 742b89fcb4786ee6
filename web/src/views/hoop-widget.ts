// A hoop to take hold of: its weight is dragged round the rim and flung, with a mouse, a finger or
// the keys. It knows a scene and a start, and nothing of the page around it.

import { make } from '../dom';
import { Sheet } from './canvas';
import { type Camera, cameraOf, drawHoop, type HoopScene } from './hoop';

/** What the hand sets of a start, without dimension. */
export interface HandStart {
  theta: number;
  theta_rate: number;
}

/** What the widget asks of the page, and tells it. */
export interface HoopHost {
  scene(): HoopScene;
  start(): HandStart;
  /** Another start: at each step of a drag. */
  set(start: Partial<HandStart>): void;
  /** The hand has taken the weight; what plays is to stop. */
  grabbed?(): void;
  /** The hand has moved the weight and let it go; whether it has flung it. */
  released?(flung: boolean): void;
  /** θ′ of a hand that turns the hoop by a radian in a second: √(R/g) in seconds. */
  second: number;
  /** Whether the hand may take the hoop; it may where there is no such function. */
  isFree?(): boolean;
  /** A start in words. */
  say(start: HandStart): string;
}

/** What a left or right arrow turns the weight by, and an up or down arrow adds to its rate; a tenth of it with Shift. */
const KEY_STEP = 0.05;

/** Milliseconds before it lets go over which the speed of the hand counts, and radians in a second that are a fling. */
const LAST = 120;
const FLING = 1.5;

/** The fastest fling. */
const FASTEST = 6;

/** Pixels about the rim where a mouse takes hold of it. */
const REACH = 8;

export class HoopWidget {
  private readonly sheet: Sheet;
  readonly handle: HTMLElement;
  /** The view while the hand holds the hoop, so that it stays under the hand. */
  private held: Camera | null = null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly host: HoopHost,
    draw: () => void,
    /** What the handle is called. */
    name: string,
  ) {
    this.sheet = new Sheet(canvas, draw);
    this.handle = make('div', {
      class: 'handle weight',
      role: 'slider',
      tabindex: '0',
      'aria-label': name,
      'aria-valuemin': '-180',
      'aria-valuemax': '180',
      'aria-valuenow': '0',
    });
    canvas.after(this.handle);
    this.listen();
  }

  get size(): { width: number; height: number } {
    return this.sheet.size;
  }

  /** The view that is drawn. */
  get camera(): Camera {
    return this.held ?? cameraOf(this.sheet.size, this.host.scene());
  }

  paint(): void {
    if (this.sheet.size.width === 0) return;
    const scene = this.host.scene();
    const { camera } = this;
    drawHoop(this.sheet.clear(), this.sheet.size, scene, camera);
    const { sample, offset, motion } = scene;
    const theta = sample?.theta ?? motion.events[0]!.theta;
    const place =
      sample === null
        ? camera.at(-offset * Math.sin(theta), 1 + offset * Math.cos(theta))
        : camera.at(sample.particle_x, sample.particle_y);
    const { offsetLeft, offsetTop } = this.canvas;
    this.handle.hidden = this.host.isFree?.() === false;
    this.handle.style.transform = `translate(${offsetLeft + place[0]}px, ${offsetTop + place[1]}px)`;
    const start = this.host.start();
    const text = this.host.say(start);
    if (this.handle.getAttribute('aria-valuetext') === text) return;
    this.handle.setAttribute(
      'aria-valuenow',
      String(Math.round((wrappedTurn(start.theta) * 180) / Math.PI)),
    );
    this.handle.setAttribute('aria-valuetext', text);
  }

  private centre(scene: HoopScene): readonly [number, number] {
    return this.camera.at(scene.sample?.x ?? 0, scene.sample?.centre_y ?? 1);
  }

  private listen(): void {
    const { handle, canvas } = this;
    for (const target of [handle, canvas]) {
      target.addEventListener('pointerdown', (event) => {
        if (event.button !== 0 || (target === canvas && !this.isOnHoop(event))) return;
        event.preventDefault();
        handle.focus({ preventScroll: true });
        this.grab(event, target);
      });
    }
    canvas.addEventListener('pointermove', (event) => {
      if (this.held === null) canvas.style.cursor = this.isOnHoop(event) ? 'grab' : '';
    });
    handle.addEventListener('keydown', (event) => {
      const [turn = 0, spin = 0] = {
        ArrowLeft: [1, 0],
        ArrowRight: [-1, 0],
        ArrowUp: [0, 1],
        ArrowDown: [0, -1],
      }[event.key] ?? [0, 0];
      if (!turn && !spin) return;
      event.preventDefault();
      this.host.grabbed?.();
      const step = event.shiftKey ? KEY_STEP / 10 : KEY_STEP;
      const { theta, theta_rate } = this.host.start();
      const rounded = (value: number): number => Number(value.toFixed(6));
      this.host.set(
        turn
          ? { theta: rounded(wrappedTurn(theta + turn * step)) }
          : { theta_rate: rounded(theta_rate + spin * step) },
      );
    });
  }

  /** Whether a mouse is on the hoop. A finger there may be about to scroll the page: it takes the weight itself. */
  private isOnHoop(event: PointerEvent): boolean {
    if (event.pointerType === 'touch' || this.host.isFree?.() === false) return false;
    const [x, y] = this.centre(this.host.scene());
    const box = this.canvas.getBoundingClientRect();
    return (
      Math.hypot(event.clientX - box.left - x, event.clientY - box.top - y) <
      this.camera.scale + REACH
    );
  }

  private grab(event: PointerEvent, target: HTMLElement): void {
    const { host, canvas } = this;
    host.grabbed?.();
    const scene = host.scene();
    const camera = cameraOf(this.sheet.size, scene);
    const centre = this.centre(scene);
    // The hoop at the start is shown where the hand has taken it.
    const [x, y] = camera.at(scene.motion.samples.x[0] ?? 0, 1);
    const [across, down] = [centre[0] - x, centre[1] - y];
    this.held = {
      ...camera,
      at: (along, up) => {
        const [px, py] = camera.at(along, up);
        return [px + across, py + down];
      },
    };
    const angleOf = ({ clientX, clientY }: PointerEvent): number => {
      const box = canvas.getBoundingClientRect();
      return Math.atan2(centre[0] - (clientX - box.left), centre[1] - (clientY - box.top));
    };
    let angle = angleOf(event);
    let theta = scene.sample?.theta ?? scene.motion.events[0]!.theta;
    let moved = false;
    /** Where the hand was lately. */
    let track: [number, number][] = [[event.timeStamp, theta]];
    const move = (next: PointerEvent): void => {
      const now = angleOf(next);
      theta += wrappedTurn(now - angle);
      angle = now;
      moved = true;
      track = [...track.filter(([time]) => time > next.timeStamp - LAST), [next.timeStamp, theta]];
      host.set({ theta: Number(wrappedTurn(theta).toFixed(3)) });
    };
    const release = (last: PointerEvent): void => {
      for (const [kind, listener] of [
        ['pointermove', move],
        ['pointerup', release],
        ['pointercancel', release],
      ] as const) {
        target.removeEventListener(kind, listener);
      }
      this.held = null;
      if (!moved) return;
      track = track.filter(([time]) => time > last.timeStamp - LAST);
      const [from, to] = [track[0], track.at(-1)];
      const rate =
        from && to && to[0] > from[0] ? (1000 * (to[1] - from[1])) / (to[0] - from[0]) : 0;
      const flung = last.type === 'pointerup' && Math.abs(rate) > FLING;
      if (flung) {
        const most = Math.min(Math.abs(rate * host.second), FASTEST);
        host.set({ theta_rate: Number((Math.sign(rate) * most).toFixed(2)) });
      }
      host.released?.(flung);
    };
    target.setPointerCapture(event.pointerId);
    target.addEventListener('pointermove', move);
    target.addEventListener('pointerup', release);
    target.addEventListener('pointercancel', release);
  }
}

/** An angle within half a turn of the top. */
function wrappedTurn(theta: number): number {
  return theta - 2 * Math.PI * Math.round(theta / (2 * Math.PI));
}
