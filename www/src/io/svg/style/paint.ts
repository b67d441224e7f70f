import type { Declared } from "./declared.ts";

/** What a shape is drawn with: all but the opacity come down from the groups around. */
export interface Paint {
  readonly fill: string;
  readonly stroke: string;
  readonly "fill-rule": string;
  readonly "fill-opacity": string;
  readonly "stroke-width": string;
  readonly "stroke-opacity": string;
  readonly "stroke-linecap": string;
  readonly "stroke-linejoin": string;
  readonly "stroke-dasharray": string;
  readonly "stroke-dashoffset": string;
  /** What `currentcolor` is; empty where nothing says it. */
  readonly color: string;
  /** The shape's own and those of all groups around, multiplied. */
  readonly opacity: number;
}

export const initialPaint: Paint = {
  fill: "black", stroke: "none", "fill-rule": "nonzero", "fill-opacity": "1", color: "", opacity: 1,
  "stroke-width": "1", "stroke-opacity": "1", "stroke-linecap": "butt", "stroke-linejoin": "miter", "stroke-dasharray": "none", "stroke-dashoffset": "0",
};

/** What nothing says whether it is there. */
export const unknownStroke = "unknown";

/** Of shapes that were copied without the picture around them, which may have said what they are stroked with. */
export const unknownPaint: Paint = { ...initialPaint, stroke: unknownStroke };

export function paintOf(element: Element, css: Declared, around: Paint): Paint {
  const own = (name: keyof Paint): string =>
    // JSX has no hyphens in names.
    (css.get(name) ?? element.getAttribute(name) ?? element.getAttribute(name.replace("-", "")) ?? "").trim();
  const value = (name: Exclude<keyof Paint, "opacity">): string => {
    const text = own(name);
    return /^(?:|inherit|unset|revert|revert-layer)$/iu.test(text) ? around[name] : text;
  };
  const word = (name: Exclude<keyof Paint, "opacity">): string => value(name).toLowerCase();
  return {
    fill: value("fill"), stroke: value("stroke"), "fill-rule": word("fill-rule"), "fill-opacity": value("fill-opacity"), color: value("color"),
    "stroke-width": word("stroke-width"), "stroke-opacity": value("stroke-opacity"), "stroke-dasharray": word("stroke-dasharray"),
    "stroke-dashoffset": word("stroke-dashoffset"), "stroke-linecap": word("stroke-linecap"), "stroke-linejoin": word("stroke-linejoin"),
    opacity: around.opacity * opacityOf(own("opacity")),
  };
}

/** 1 where the text says nothing. */
export function opacityOf(text: string): number {
  const [, digits, percent] = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(%?)$/iu.exec(text.trim()) ?? [];
  return digits === undefined ? 1 : Math.min(1, Math.max(0, percent === "%" ? Number(digits) / 100 : Number(digits)));
}

/** Whether paint is seen. */
export function isPaint(value: string): boolean {
  return !/^(?:none|transparent)$/iu.test(value);
}
