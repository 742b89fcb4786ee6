// A canvas that fills its box at the resolution of the screen.

export interface Size {
  width: number;
  height: number;
}

export class Sheet {
  size: Size = { width: 0, height: 0 };
  readonly context: CanvasRenderingContext2D;

  constructor(
    readonly canvas: HTMLCanvasElement,
    resized: () => void,
  ) {
    const context = canvas.getContext('2d');
    if (!context) throw new Error('this browser has no canvas');
    this.context = context;
    new ResizeObserver(() => {
      this.fit();
      resized();
    }).observe(canvas);
    this.fit();
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const scale = window.devicePixelRatio || 1;
    this.size = { width, height };
    this.canvas.width = Math.round(width * scale);
    this.canvas.height = Math.round(height * scale);
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
  }

  clear(): CanvasRenderingContext2D {
    this.context.clearRect(0, 0, this.size.width, this.size.height);
    return this.context;
  }
}

/** An arrow from (x, y) by (dx, dy). Nothing for an arrow too short to see. */
export function arrow(
  c: CanvasRenderingContext2D,
  x: number,
  y: number,
  dx: number,
  dy: number,
  colour: string,
): void {
  const length = Math.hypot(dx, dy);
  if (length < 2) return;
  const head = Math.min(10, 0.6 * length);
  const [ux, uy] = [dx / length, dy / length];
  const [ex, ey] = [x + dx, y + dy];
  c.strokeStyle = colour;
  c.fillStyle = colour;
  c.lineWidth = 3;
  c.setLineDash([]);
  c.beginPath();
  c.moveTo(x, y);
  c.lineTo(ex - 0.8 * head * ux, ey - 0.8 * head * uy);
  c.stroke();
  c.beginPath();
  c.moveTo(ex, ey);
  c.lineTo(ex - head * ux - 0.5 * head * uy, ey - head * uy + 0.5 * head * ux);
  c.lineTo(ex - head * ux + 0.5 * head * uy, ey - head * uy - 0.5 * head * ux);
  c.closePath();
  c.fill();
}

/** Sets dashes that are given in units of the width of the line. */
export function setDash(c: CanvasRenderingContext2D, dash: readonly number[]): void {
  c.setLineDash(dash.map((it) => it * c.lineWidth));
}

/** Text with a rim of the paper's colour, readable on anything. */
export function label(
  c: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  ink: string,
  paper: string,
): void {
  c.lineWidth = 4;
  c.lineJoin = 'round';
  c.setLineDash([]);
  c.strokeStyle = paper;
  c.strokeText(text, x, y);
  c.fillStyle = ink;
  c.fillText(text, x, y);
}
