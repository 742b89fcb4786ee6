// The pane of the hoop.

import { byId } from '../dom';
import type { Palette } from '../generated/palette';
import type { Lab } from '../state/lab';
import { Sheet } from '../views/canvas';
import { drawHoop } from '../views/hoop';

export class HoopPane {
  private readonly sheet: Sheet;

  constructor(
    private readonly lab: Lab,
    private palette: Palette,
    draw: () => void,
  ) {
    this.sheet = new Sheet(byId('hoop', HTMLCanvasElement), draw);
    const follow = byId('follow', HTMLInputElement);
    follow.addEventListener('change', () => lab.setView({ follow: follow.checked }));
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
  }

  viewChanged(): void {
    byId('follow', HTMLInputElement).checked = this.lab.state.view.follow;
  }

  paint(): void {
    if (this.sheet.size.width === 0) return;
    this.drawOn(this.sheet.clear(), this.sheet.size.width, this.sheet.size.height);
  }

  drawOn(c: CanvasRenderingContext2D, width: number, height: number): void {
    const { motion, time, plain, problem, state } = this.lab;
    drawHoop(
      c,
      { width, height },
      {
        motion,
        sample: motion.at(time),
        offset: plain.offset,
        h: problem.h,
        follow: state.view.follow,
        palette: this.palette,
      },
    );
  }
}
