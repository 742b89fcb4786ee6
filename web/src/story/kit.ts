// A live picture: a canvas, controls, and a sentence that says what the canvas shows.
//
// Each thing that can be dragged on a canvas is also a slider, which keyboard and screen reader
// reach; the drag sets the slider.

import { make, STILL } from '../dom';
import type { Palette } from '../generated/palette';
import { CAUSE_LABELS, CLASS_LABELS, QUANTITY_ROWS } from '../generated/tables';
import { Sheet, type Size } from '../views/canvas';
import { type HoopHost, HoopWidget } from '../views/hoop-widget';
import { rich } from './rich';
import { LIBRARY } from './text';

/** What a text file says of a picture. */
export interface Words {
  /** Under the picture. */
  title: string;
  /** What the canvas shows, spoken. */
  shows: string;
  /** Names of the controls. */
  controls: Readonly<Record<string, string>>;
}

/** Words that all pictures share. */
export interface Common {
  play: string;
  pause: string;
  time: string;
  laboratory: string;
  /** What is taken hold of. */
  weight: string;
}

export type Draw = (c: CanvasRenderingContext2D, size: Size, palette: Palette) => void;

/** Names of the library, by theirs. */
const OF_THE_LIBRARY: Readonly<Record<string, string>> = {
  ...CLASS_LABELS,
  ...CAUSE_LABELS,
  restitution: QUANTITY_ROWS.restitution.longName,
};

/** Milliseconds for which an event is shown where nothing may move by itself. */
const STEP = 900;

export interface SliderOptions {
  min: number;
  max: number;
  step: number;
  first: number;
  /** The value in words. */
  text: (value: number) => string;
}

export class Slider {
  readonly input: HTMLInputElement;
  readonly row: HTMLDivElement;
  private readonly output: HTMLOutputElement;

  constructor(
    id: string,
    name: string,
    private readonly options: SliderOptions,
    changed: () => void,
  ) {
    const { min, max, step, first } = options;
    this.input = make('input', {
      id,
      type: 'range',
      min: String(min),
      max: String(max),
      step: String(step),
      value: String(first),
    });
    this.output = make('output', { for: id });
    this.row = make(
      'div',
      { class: 'slider' },
      make('label', { for: id }, name),
      this.output,
      this.input,
    );
    this.input.addEventListener('input', () => {
      this.tell();
      changed();
    });
    this.tell();
  }

  get value(): number {
    return this.input.valueAsNumber;
  }

  /** Sets the slider as a person would. */
  set(value: number): void {
    const { min, max } = this.options;
    const before = this.input.value;
    this.input.value = String(Math.min(Math.max(value, min), max));
    if (this.input.value !== before)
      this.input.dispatchEvent(new Event('input', { bubbles: true }));
  }

  /** Shows a value that has come in another way. */
  show(value: number): void {
    this.input.value = String(value);
    this.tell();
  }

  /** Says the value again: it may mean something else now. */
  tell(): void {
    const text = this.options.text(this.value);
    this.output.textContent = text;
    this.input.setAttribute('aria-valuetext', text);
  }
}

/** A time that runs while it is played. */
export interface Course {
  /** From when to when. */
  readonly from: number;
  readonly to: number;
  /** Instants worth a stop, for those who want no motion. */
  readonly stops: readonly number[];
  /** Time for a second of the screen. */
  readonly speed: number;
}

export class Player {
  readonly button: HTMLButtonElement;
  readonly slider: Slider;
  private frame = 0;
  private timer = 0;
  private last = 0;
  private now: number;

  constructor(
    id: string,
    private readonly common: Common,
    private readonly course: () => Course,
    text: (time: number) => string,
    private readonly changed: () => void,
    /** It has moved by itself, in a frame of the screen. */
    private readonly moved: () => void,
    private readonly silence: (playing: boolean) => void,
    first: number | null,
  ) {
    const { from } = course();
    this.now = first ?? from;
    this.button = make('button', { type: 'button', class: 'play' }, common.play);
    // The slider has the part of the course that has passed, so that its steps are the same for
    // short and long ones.
    this.slider = new Slider(
      id,
      common.time,
      { min: 0, max: 1, step: 0.001, first: this.part, text: () => text(this.time) },
      () => {
        this.pause();
        const { from, to } = this.course();
        this.now = from + this.slider.value * (to - from);
        this.slider.tell();
        changed();
      },
    );
    this.button.addEventListener('click', () => (this.playing ? this.pause() : this.play()));
  }

  get playing(): boolean {
    return this.frame !== 0 || this.timer !== 0;
  }

  get time(): number {
    const { from, to } = this.course();
    return Math.min(Math.max(this.now, from), to);
  }

  private get part(): number {
    const { from, to } = this.course();
    return to > from ? (this.time - from) / (to - from) : 0;
  }

  /** Goes to a time, as when another motion begins. */
  go(time: number): void {
    this.pause();
    this.now = time;
    this.show();
  }

  play(): void {
    const { from, to } = this.course();
    if (this.time >= to) this.now = from;
    this.silence(true);
    this.button.textContent = this.common.pause;
    this.last = performance.now();
    if (STILL.matches) this.step();
    else this.frame = requestAnimationFrame(this.tick);
  }

  /** Plays by itself, for those who do not mind. */
  playUnlessStill(): void {
    if (!STILL.matches) this.play();
  }

  pause(): void {
    if (!this.playing) return;
    cancelAnimationFrame(this.frame);
    window.clearTimeout(this.timer);
    this.frame = 0;
    this.timer = 0;
    this.button.textContent = this.common.play;
    this.silence(false);
  }

  private readonly tick = (now: number): void => {
    const { to, speed } = this.course();
    this.now = Math.min(this.time + (Math.max(0, now - this.last) / 1000) * speed, to);
    this.last = now;
    this.frame = requestAnimationFrame(this.tick);
    if (this.now >= to) this.pause();
    this.slider.show(this.part);
    this.moved();
  };

  /** From event to event, without any motion in between. */
  private readonly step = (): void => {
    const { stops, to } = this.course();
    const next = stops.find((it) => it > this.time + 1e-9 && it < to) ?? to;
    this.now = next;
    this.timer = next < to ? window.setTimeout(this.step, STEP) : 0;
    if (next >= to) {
      this.button.textContent = this.common.play;
      this.silence(false);
    }
    this.show();
  };

  private show(): void {
    this.slider.show(this.part);
    this.changed();
  }
}

export class Picture {
  readonly figure: HTMLElement;
  readonly controls = make('div', { class: 'controls' });
  private readonly stage = make('div', { class: 'stage' });
  private readonly canvas: HTMLCanvasElement;
  private sheet: Sheet | null = null;
  private widget: HoopWidget | null = null;
  private readonly sentence = make('p', { class: 'says', 'aria-live': 'polite' });
  private readonly laboratory: HTMLAnchorElement;
  private readonly handles: { element: HTMLElement; place: () => readonly [number, number] }[] = [];
  private readonly players: Player[] = [];
  private draw: Draw = () => undefined;
  private says: () => string = () => '';
  private said = '';
  private link: (() => string) | null = null;
  private frame = 0;
  private inSight = false;
  private stale = true;

  constructor(
    readonly id: string,
    readonly words: Words,
    private readonly common: Common,
    private palette: Palette,
  ) {
    this.canvas = make('canvas', {
      role: 'img',
      'aria-label': words.shows,
      'aria-describedby': `${id}-says`,
    });
    this.sentence.id = `${id}-says`;
    this.laboratory = make('a', { class: 'laboratory' }, common.laboratory);
    this.laboratory.hidden = true;
    this.stage.append(this.canvas);
    const caption = make('figcaption', {}, words.title);
    this.figure = make(
      'figure',
      { id, class: 'picture' },
      this.stage,
      this.sentence,
      this.controls,
      caption,
    );
    caption.append(' ', this.laboratory);
    new IntersectionObserver(
      ([entry]) => {
        this.inSight = entry?.isIntersecting === true;
        if (!this.inSight) for (const player of this.players) player.pause();
        else if (this.stale) this.changed();
      },
      { rootMargin: '200px' },
    ).observe(this.figure);
  }

  /** What is drawn and said; `link` is the address of the same motion in the laboratory. */
  live(draw: Draw, says: () => string, link: (() => string) | null = null): void {
    this.sheet = new Sheet(this.canvas, this.changed);
    this.draw = draw;
    this.begin(says, link);
  }

  /** The same of a hoop to take hold of. */
  hold(host: (palette: () => Palette) => HoopHost, says: () => string, link: () => string): void {
    this.widget = new HoopWidget(
      this.canvas,
      host(() => this.palette),
      this.changed,
      this.common.weight,
    );
    this.begin(says, link);
  }

  private begin(says: () => string, link: (() => string) | null): void {
    this.says = says;
    this.link = link;
    this.laboratory.hidden = link === null;
    this.changed();
  }

  slider(
    name: string,
    options: SliderOptions,
    changed: (value: number) => void = () => undefined,
  ): Slider {
    const slider: Slider = new Slider(`${this.id}-${name}`, this.word(name), options, () => {
      changed(slider.value);
      this.changed();
    });
    this.controls.append(slider.row);
    return slider;
  }

  player(
    course: () => Course,
    text: (time: number) => string,
    first: number | null = null,
  ): Player {
    const player = new Player(
      `${this.id}-time`,
      this.common,
      course,
      text,
      this.changed,
      this.paintNow,
      (playing) => this.sentence.setAttribute('aria-busy', String(playing)),
      first,
    );
    this.controls.append(make('div', { class: 'player' }, player.button, player.slider.row));
    this.players.push(player);
    return player;
  }

  /**
   * A point of the canvas that is dragged, and on a map also put where one clicks; the sliders that it sets are its controls for the
   * keyboard.
   */
  handle(
    place: () => readonly [number, number],
    drag: (x: number, y: number) => void,
    isMap = false,
  ): void {
    const element = make('div', { class: 'grip', 'aria-hidden': 'true' });
    element.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', (event) => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      const box = this.canvas.getBoundingClientRect();
      drag(event.clientX - box.left, event.clientY - box.top);
    });
    if (isMap) {
      this.canvas.addEventListener('click', ({ offsetX, offsetY }) => drag(offsetX, offsetY));
      this.canvas.classList.add('map');
    }
    this.stage.append(element);
    this.handles.push({ element, place });
  }

  /** A word of the text, or the library's. */
  word(name: string): string {
    const word = this.words.controls[name] ?? LIBRARY[name] ?? OF_THE_LIBRARY[name];
    if (word === undefined) throw new Error(`the picture ${this.id} has no word for ${name}`);
    return word;
  }

  get size(): Size {
    return this.widget?.size ?? this.sheet?.size ?? { width: 0, height: 0 };
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.changed();
  }

  /** Draws it again, soon. */
  readonly changed = (): void => {
    this.stale = true;
    if (!this.inSight || this.frame !== 0) return;
    this.frame = requestAnimationFrame(this.paintNow);
  };

  /** Draws it now, where a frame of the screen has begun: to wait for the next would halve their number. */
  private readonly paintNow = (): void => {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (this.inSight) this.paint();
    else this.stale = true;
  };

  private paint(): void {
    this.stale = false;
    if (this.size.width === 0) return;
    if (this.sheet) this.draw(this.sheet.clear(), this.size, this.palette);
    this.widget?.paint();
    const sentence = this.says();
    if (this.said !== sentence) {
      this.said = sentence;
      this.sentence.replaceChildren(...rich(sentence, {}, String));
    }
    if (this.link !== null) this.laboratory.href = this.link();
    for (const { element, place } of this.handles) {
      const [x, y] = place();
      element.style.transform = `translate(${x}px, ${y}px)`;
    }
    this.figure.dataset.drawn = String(Number(this.figure.dataset.drawn ?? 0) + 1);
  }
}
