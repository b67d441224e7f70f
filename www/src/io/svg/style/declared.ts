/** What a style says of the properties that are followed. */

/** These properties, with what each is when it is set back. */
const initials: ReadonlyMap<string, string> = new Map([
  ["display", "inline"], ["visibility", "visible"],
  ["transform", "none"], ["translate", "none"], ["rotate", "none"], ["scale", "none"], ["transform-origin", "0 0"], ["transform-box", "view-box"],
  ["clip-path", "none"], ["mask", "none"],
  ["fill", "black"], ["stroke", "none"], ["fill-rule", "nonzero"],
  ["stroke-width", "1"], ["stroke-opacity", "1"], ["stroke-linecap", "butt"], ["stroke-linejoin", "miter"], ["stroke-dasharray", "none"], ["stroke-dashoffset", "0"], ["vector-effect", "none"],
  ["color", "black"], ["fill-opacity", "1"], ["opacity", "1"], ["stop-color", "black"], ["stop-opacity", "1"],
  ["d", "none"], ["x", "0"], ["y", "0"], ["cx", "0"], ["cy", "0"], ["r", "0"], ["rx", "auto"], ["ry", "auto"], ["width", "auto"], ["height", "auto"],
]);

const inherited: ReadonlySet<string> = new Set([
  "visibility", "fill", "stroke", "fill-rule", "color", "fill-opacity",
  "stroke-width", "stroke-opacity", "stroke-linecap", "stroke-linejoin", "stroke-dasharray", "stroke-dashoffset",
]);

/** A quick look, before anything is parsed. */
export const mentioned = new RegExp(`(?:^|[;{\\s/])(?:${[...initials.keys()].join("|")})\\s*:`, "iu");

/** What CSS says of one element, by property; attributes of the same names come after it. */
export type Declared = ReadonlyMap<string, string>;

export const nothingDeclared: Declared = new Map();

export interface Levels {
  readonly normal: Declared;
  readonly important: Declared;
}

export const nothing: Levels = { normal: nothingDeclared, important: nothingDeclared };

/** Most rules say little: their names are fewer than those that are followed. */
export function isFollowed(style: CSSStyleDeclaration): boolean {
  // Browsers take a mask apart.
  return Array.from(style).some((name) => initials.has(name) || name === "mask-image");
}

export function levelsOf(style: CSSStyleDeclaration): Levels {
  const levels = { normal: new Map<string, string>(), important: new Map<string, string>() };
  for (const [property, initial] of initials) {
    const value = style.getPropertyValue(property).trim();
    if (value === "") continue;
    const isReset = /^(?:initial|unset|revert|revert-layer|inherit)$/iu.test(value);
    const isInherited = inherited.has(property) && value !== "initial";
    levels[style.getPropertyPriority(property) === "" ? "normal" : "important"].set(property, isReset && !isInherited ? initial : value);
  }
  return levels;
}
