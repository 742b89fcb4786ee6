// Small helpers for the document.

/** The element with an id, of a class that is known. */
export function byId<T extends HTMLElement>(id: string, kind: new () => T): T {
  const element = document.getElementById(id);
  if (!(element instanceof kind)) throw new Error(`the page has no ${id}`);
  return element;
}

/** A new element with attributes and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A person who wants nothing to move by itself. */
export const STILL = matchMedia('(prefers-reduced-motion: reduce)');

/** Whether an element is in sight, or nearly; `came` is told when it comes. */
export function inSight(element: Element, came: () => void): () => boolean {
  let isSeen = true;
  new IntersectionObserver(
    ([entry]) => {
      isSeen = entry?.isIntersecting === true;
      if (isSeen) came();
    },
    { rootMargin: '200px' },
  ).observe(element);
  return () => isSeen;
}

/** A piece of a line as legends show it. */
export function line(width: number, dash: readonly number[]): SVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 30 8');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', 'M0 4h30');
  path.setAttribute('stroke-width', String(width));
  path.setAttribute('stroke-dasharray', dash.map((it) => it * width).join(' '));
  svg.append(path);
  return svg;
}

/** Up to `digits` significant digits, with a true minus. */
export function brief(value: number, digits = 5): string {
  if (!Number.isFinite(value)) return value > 0 ? '∞' : value < 0 ? '−∞' : '–';
  return String(Number(value.toPrecision(digits))).replaceAll('-', '−');
}
