// For a lecture: the hoop on the whole screen with large letters, in metres and degrees, the
// friction that it needs against what the ground has, and a code that takes the motion to a telephone.

import { brief, byId } from '../dom';
import { COLUMN_ROWS } from '../generated/tables';
import type { Lab } from '../state/lab';
import type { ProblemState } from '../state/state';
import { format } from '../state/url';
import { setLetters } from '../views/font';
import { TEXTS } from './texts';

/** How much larger the letters in pictures are. */
const LARGER = 1.6;

/** Milliseconds after a change until the code is drawn anew. */
const PAUSE = 400;

const NUMBERS = ['time', 'theta', 'x', 'gap'] as const;

export class Lecture {
  private readonly button = byId('lecture', HTMLButtonElement);
  private readonly readout = byId('readout', HTMLParagraphElement);
  private readonly code = byId('qr', HTMLElement);
  /** The problem before, and as it was turned into metres; none where it is in SI units anyhow. */
  private before: { problem: ProblemState; shown: string } | null = null;
  private timer = 0;

  constructor(
    private readonly lab: Lab,
    /** The link of a problem. */
    private readonly address: (problem: ProblemState) => string,
    /** The sizes of letters have changed. */
    private readonly draw: () => void,
  ) {
    this.button.addEventListener('click', () => (this.isOn ? this.end() : this.begin()));
    document.addEventListener('fullscreenchange', () => {
      if (document.fullscreenElement === null && this.isOn) this.end();
    });
    document.addEventListener('keydown', ({ key }) => {
      if (key === 'Escape' && this.isOn && document.fullscreenElement === null) this.end();
    });
  }

  get isOn(): boolean {
    return document.documentElement.hasAttribute('data-lecture');
  }

  private begin(): void {
    const { lab } = this;
    this.show(true);
    // Where the browser has no full screen the page fills its window.
    document.documentElement.requestFullscreen?.().catch(() => undefined);
    const { problem } = lab.state;
    if (problem.system !== 'si') {
      lab.setSystem('si');
      this.before = { problem, shown: this.said };
    }
    lab.setView({});
  }

  private end(): void {
    this.show(false);
    if (document.fullscreenElement !== null) void document.exitFullscreen();
    const { before, lab } = this;
    this.before = null;
    // What has not been changed goes back to the last bit.
    if (before !== null) {
      if (before.shown === this.said) lab.take(before.problem, { time: lab.state.view.time });
      else lab.setSystem('dimensionless');
    }
    lab.setView({});
  }

  private get said(): string {
    const { problem, view } = this.lab.state;
    return format({ problem, view: { ...view, time: null } });
  }

  private show(isOn: boolean): void {
    document.documentElement.toggleAttribute('data-lecture', isOn);
    this.button.setAttribute('aria-pressed', String(isOn));
    this.button.textContent = isOn ? TEXTS.page.lecture_end : TEXTS.page.lecture;
    setLetters(isOn ? LARGER : 1);
    this.draw();
  }

  /** The instant in numbers, and the code of the motion. */
  showTime(): void {
    if (!this.isOn) return;
    const { motion, time, units } = this.lab;
    const now = motion.at(time);
    this.readout.textContent =
      now === null
        ? ''
        : NUMBERS.map((name) => {
            const { signs, units: names } = COLUMN_ROWS[name];
            return name === 'theta'
              ? `${signs.si} = ${brief((now.theta * 180) / Math.PI, 3)}°`
              : `${signs.si} = ${brief(now[name] * units[name], 3)} ${names.si}`;
          }).join('   ');
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.showCode(), PAUSE);
  }

  private async showCode(): Promise<void> {
    const { encode } = await import('uqr');
    // The shorter link, if it is of the same motion.
    const { before, lab } = this;
    const isSame = before !== null && before.shown === this.said;
    const { data, size } = encode(this.address(isSame ? before.problem : lab.state.problem), {
      border: 2,
    });
    const space = 'http://www.w3.org/2000/svg';
    const svg = document.createElementNS(space, 'svg');
    svg.setAttribute('viewBox', `0 0 ${size} ${size}`);
    const squares = data.flatMap((row, y) =>
      row.flatMap((isDark, x) => (isDark ? [`M${x} ${y}h1v1h-1z`] : [])),
    );
    const path = document.createElementNS(space, 'path');
    path.setAttribute('d', squares.join(''));
    svg.append(path);
    this.code.replaceChildren(svg);
  }
}
