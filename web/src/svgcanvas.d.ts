declare module 'svgcanvas' {
  /** The interface of a canvas context, which writes SVG. */
  export const Context: new (width: number, height: number) => unknown;
}
