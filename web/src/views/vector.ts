// A canvas context that writes SVG: the part of the interface that the views use.
//
// The libraries for this set `style` attributes while they measure fonts, which the policy of the
// page forbids.

type Attributes = Record<string, string | number>;

interface Pen {
  fillStyle: string;
  strokeStyle: string;
  lineWidth: number;
  lineJoin: string;
  globalAlpha: number;
  font: string;
  textAlign: string;
  textBaseline: string;
  dash: number[];
  /** Number of clip paths that are open. */
  clips: number;
}

const ANCHORS: Record<string, string> = {
  left: 'start',
  start: 'start',
  center: 'middle',
  right: 'end',
  end: 'end',
};

/** Where a line of text stands, in parts of its size. */
const DROPS: Record<string, number> = { top: 0.85, middle: 0.35, alphabetic: 0, bottom: -0.2 };

export class VectorContext implements Pen {
  fillStyle = '#000';
  strokeStyle = '#000';
  lineWidth = 1;
  lineJoin = 'miter';
  globalAlpha = 1;
  font = '10px sans-serif';
  textAlign = 'start';
  textBaseline = 'alphabetic';
  imageSmoothingEnabled = true;
  dash: number[] = [];
  clips = 0;
  private readonly parts: string[] = [];
  private readonly stack: Pen[] = [];
  private path: string[] = [];
  private paths = 0;

  constructor(
    private readonly width: number,
    private readonly height: number,
  ) {}

  toString(): string {
    const { width, height } = this;
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">
${this.parts.join('\n')}
</svg>
`;
  }

  save(): void {
    const {
      fillStyle,
      strokeStyle,
      lineWidth,
      lineJoin,
      globalAlpha,
      font,
      textAlign,
      textBaseline,
      dash,
      clips,
    } = this;
    this.stack.push({
      fillStyle,
      strokeStyle,
      lineWidth,
      lineJoin,
      globalAlpha,
      font,
      textAlign,
      textBaseline,
      dash,
      clips,
    });
  }

  restore(): void {
    const pen = this.stack.pop();
    if (!pen) return;
    for (; this.clips > pen.clips; this.clips--) this.parts.push('</g>');
    Object.assign(this, pen);
  }

  clip(): void {
    this.paths += 1;
    this.parts.push(
      `<clipPath id="clip-${this.paths}"><path d="${this.path.join('')}"/></clipPath>`,
    );
    this.parts.push(`<g clip-path="url(#clip-${this.paths})">`);
    this.clips += 1;
  }

  setLineDash(dash: number[]): void {
    this.dash = dash;
  }

  beginPath(): void {
    this.path = [];
  }

  moveTo(x: number, y: number): void {
    this.path.push(`M${at(x)} ${at(y)}`);
  }

  lineTo(x: number, y: number): void {
    this.path.push(`${this.path.length === 0 ? 'M' : 'L'}${at(x)} ${at(y)}`);
  }

  closePath(): void {
    this.path.push('Z');
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.path.push(`M${at(x)} ${at(y)}h${at(width)}v${at(height)}h${at(-width)}Z`);
  }

  /** An arc clockwise on the screen; a whole turn is two halves. */
  arc(x: number, y: number, radius: number, from: number, to: number): void {
    const point = (angle: number): string =>
      `${at(x + radius * Math.cos(angle))} ${at(y + radius * Math.sin(angle))}`;
    const middle = 0.5 * (from + to);
    this.path.push(`${this.path.length === 0 ? 'M' : 'L'}${point(from)}`);
    for (const angle of [middle, to])
      this.path.push(`A${at(radius)} ${at(radius)} 0 0 1 ${point(angle)}`);
  }

  stroke(): void {
    this.put('path', { d: this.path.join(''), ...this.lines });
  }

  fill(): void {
    this.put('path', { d: this.path.join(''), ...this.area });
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    this.put('rect', { x: at(x), y: at(y), width: at(width), height: at(height), ...this.area });
  }

  strokeRect(x: number, y: number, width: number, height: number): void {
    this.put('rect', { x: at(x), y: at(y), width: at(width), height: at(height), ...this.lines });
  }

  fillText(text: string, x: number, y: number): void {
    this.write(text, x, y, this.area);
  }

  strokeText(text: string, x: number, y: number): void {
    this.write(text, x, y, this.lines);
  }

  /** The part of a canvas that is drawn, as an image of its own. */
  drawImage(
    source: HTMLCanvasElement,
    sx: number,
    sy: number,
    sw: number,
    sh: number,
    x: number,
    y: number,
    width: number,
    height: number,
  ): void {
    const part = document.createElement('canvas');
    part.width = sw;
    part.height = sh;
    part.getContext('2d')?.drawImage(source, sx, sy, sw, sh, 0, 0, sw, sh);
    this.put('image', {
      x: at(x),
      y: at(y),
      width: at(width),
      height: at(height),
      preserveAspectRatio: 'none',
      href: part.toDataURL('image/png'),
    });
  }

  private get lines(): Attributes {
    return {
      fill: 'none',
      ...colour('stroke', this.strokeStyle),
      'stroke-width': this.lineWidth,
      'stroke-linejoin': this.lineJoin,
      ...(this.dash.length > 0 ? { 'stroke-dasharray': this.dash.join(' ') } : {}),
    };
  }

  private get area(): Attributes {
    return colour('fill', this.fillStyle);
  }

  private write(text: string, x: number, y: number, paint: Attributes): void {
    const [, style = '', weight = '', size = '10', family = ''] =
      /^(italic )?(bold )?([\d.]+)px (.*)$/.exec(this.font) ?? [];
    const drop = (DROPS[this.textBaseline] ?? 0) * Number(size);
    this.put(
      'text',
      {
        x: at(x),
        y: at(y + drop),
        'font-family': family.replaceAll('"', "'"),
        'font-size': size,
        ...(style ? { 'font-style': 'italic' } : {}),
        ...(weight ? { 'font-weight': 'bold' } : {}),
        'text-anchor': ANCHORS[this.textAlign] ?? 'start',
        ...paint,
      },
      text,
    );
  }

  private put(name: string, attributes: Attributes, text?: string): void {
    const all = this.globalAlpha === 1 ? attributes : { ...attributes, opacity: this.globalAlpha };
    const list = Object.entries(all)
      .map(([key, value]) => ` ${key}="${value}"`)
      .join('');
    this.parts.push(
      text === undefined ? `<${name}${list}/>` : `<${name}${list}>${escaped(text)}</${name}>`,
    );
  }
}

/** A hundredth of a pixel is more than enough. */
function at(value: number): string {
  return String(Math.round(value * 100) / 100);
}

/** A colour with its opacity apart, as every program that reads SVG knows it. */
function colour(kind: 'fill' | 'stroke', value: string): Attributes {
  const [, hex, alpha] = /^(#[\da-f]{6})([\da-f]{2})$/i.exec(value) ?? [];
  if (hex && alpha)
    return {
      [kind]: hex,
      [`${kind}-opacity`]: Math.round((100 * parseInt(alpha, 16)) / 255) / 100,
    };
  const [, red, green, blue, part] = /^rgb\((\d+) (\d+) (\d+) \/ ([\d.]+)\)$/.exec(value) ?? [];
  if (part) return { [kind]: `rgb(${red},${green},${blue})`, [`${kind}-opacity`]: part };
  return { [kind]: value };
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
