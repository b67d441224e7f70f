import type { Declared } from "./declared.ts";

/** What a shape is drawn with, as far as it matters for an outline: these come down from the groups around. */
export interface Paint {
  readonly fill: string;
  readonly stroke: string;
  readonly "fill-rule": string;
}

export const initialPaint: Paint = { fill: "black", stroke: "none", "fill-rule": "nonzero" };

/** Of shapes that were copied without the picture around them, which may have said what they are stroked with. */
export const unknownPaint: Paint = { ...initialPaint, stroke: "unknown" };

export function paintOf(element: Element, css: Declared, around: Paint): Paint {
  const value = (name: keyof Paint): string => {
    // JSX has no hyphens in names.
    const text = (css.get(name) ?? element.getAttribute(name) ?? element.getAttribute(name.replace("-", "")) ?? "").trim().toLowerCase();
    return /^(?:|inherit|unset|revert|revert-layer)$/u.test(text) ? around[name] : text;
  };
  return { fill: value("fill"), stroke: value("stroke"), "fill-rule": value("fill-rule") };
}

/** Whether paint is seen. */
export function isPaint(value: string): boolean {
  return value !== "none" && value !== "transparent";
}
