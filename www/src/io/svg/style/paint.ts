import type { Declared } from "./declared.ts";

/** What a shape is drawn with, as far as it matters for outlines and areas: all but the opacity come down from the groups around. */
export interface Paint {
  readonly fill: string;
  readonly stroke: string;
  readonly "fill-rule": string;
  readonly "fill-opacity": string;
  /** What `currentcolor` is; empty where nothing says it. */
  readonly color: string;
  /** The shape's own and those of all groups around, multiplied. */
  readonly opacity: number;
}

export const initialPaint: Paint = { fill: "black", stroke: "none", "fill-rule": "nonzero", "fill-opacity": "1", color: "", opacity: 1 };

/** Of shapes that were copied without the picture around them, which may have said what they are stroked with. */
export const unknownPaint: Paint = { ...initialPaint, stroke: "unknown" };

export function paintOf(element: Element, css: Declared, around: Paint): Paint {
  const own = (name: keyof Paint): string =>
    // JSX has no hyphens in names.
    (css.get(name) ?? element.getAttribute(name) ?? element.getAttribute(name.replace("-", "")) ?? "").trim();
  const value = (name: Exclude<keyof Paint, "opacity">): string => {
    const text = own(name);
    return /^(?:|inherit|unset|revert|revert-layer)$/iu.test(text) ? around[name] : text;
  };
  return {
    fill: value("fill"), stroke: value("stroke"), "fill-rule": value("fill-rule").toLowerCase(), "fill-opacity": value("fill-opacity"), color: value("color"),
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
