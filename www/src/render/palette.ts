/** Colours of the canvas, read from the same tokens as the page. */

export interface Palette {
  readonly canvas: string;
  readonly ink: string;
  readonly ink2: string;
  readonly line: string;
  readonly focus: string;
  readonly point: string;
  readonly curve: string;
  readonly handle: string;
  readonly cusp: string;
  readonly original: string;
  readonly warn: string;
  readonly linear: string;
  /** The two sides of a surface. */
  readonly solid: string;
  readonly solidBack: string;
}

const names = ["canvas", "ink", "ink2", "line", "focus", "point", "curve", "handle", "cusp", "original", "warn", "linear", "solid", "solid-back"] as const;

export function readPalette(root: Element): Palette {
  const style = getComputedStyle(root);
  const read = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  const [canvas = "", ink = "", ink2 = "", line = "", focus = "", point = "", curve = "", handle = "", cusp = "", original = "", warn = "", linear = "", solid = "", solidBack = ""] = names.map(read);
  return { canvas, ink, ink2, line, focus, point, curve, handle, cusp, original, warn, linear, solid, solidBack };
}
