/** Colours and letters of the canvas, read from the same tokens as the page. */

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
  readonly cubic: string;
  readonly coinc: string;
  readonly err: string;
  /** From no error to the largest, as dark to light to the eye in either theme. */
  readonly heat: readonly string[];
  /** Of small text on the canvas, in CSS pixels, and the font: it grows with the page's. */
  readonly em: number;
  readonly font: string;
  /** The system's colours, of which there are few: shapes are told apart without. */
  readonly forced: boolean;
}

const names = [
  "canvas",
  "ink",
  "ink2",
  "line",
  "focus",
  "point",
  "curve",
  "handle",
  "cusp",
  "original",
  "warn",
  "linear",
  "solid",
  "solid-back",
  "cubic",
  "coinc",
  "err",
] as const;

export function readPalette(root: Element): Palette {
  const style = getComputedStyle(root);
  const read = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  const [canvas = "", ink = "", ink2 = "", line = "", focus = "", point = "", curve = "", handle = "", cusp = "", original = "", warn = "", linear = "", ...more] = names.map(read);
  const [solid = "", solidBack = "", cubic = "", coinc = "", err = ""] = more;
  const heat = [0, 1, 2, 3, 4].map((i) => read(`heat-${i}`));
  const em = 0.75 * parseFloat(style.fontSize);
  return {
    em,
    font: `${em}px ${read("font")}`,
    canvas,
    ink,
    ink2,
    line,
    focus,
    point,
    curve,
    handle,
    cusp,
    original,
    warn,
    linear,
    solid,
    solidBack,
    cubic,
    coinc,
    err,
    heat,
    forced: matchMedia("(forced-colors: active)").matches,
  };
}
