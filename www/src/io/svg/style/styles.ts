import { bracketDepth } from "../brackets.ts";
import type { Warn } from "../lengths.ts";
import { costOf, extentOf, selectorsOf, type Selector } from "./selectors.ts";

/**
 * What the document's own style sheets and `style` attributes say of where its shapes are and which are shown. The browser
 * reads both and looks the selectors up, but the sheets belong to no page: nothing is styled or fetched by them.
 */

/** The properties that are followed, with what each is when it is set back. */
const initials: ReadonlyMap<string, string> = new Map([
  ["display", "inline"], ["visibility", "visible"],
  ["transform", "none"], ["translate", "none"], ["rotate", "none"], ["scale", "none"], ["transform-origin", "0 0"], ["transform-box", "view-box"],
  ["clip-path", "none"], ["mask", "none"],
  ["d", "none"], ["x", "0"], ["y", "0"], ["cx", "0"], ["cy", "0"], ["r", "0"], ["rx", "auto"], ["ry", "auto"], ["width", "auto"], ["height", "auto"],
]);
/** A quick look, before anything is parsed: most sheets are about colours. */
const mentioned = new RegExp(`(?:^|[;{\\s/])(?:${[...initials.keys()].join("|")})\\s*:`, "iu");

/** What CSS says of one element, by property; attributes of the same names come after it. */
export type Declared = ReadonlyMap<string, string>;
export type Styles = (element: Element) => Declared;

export const nothingDeclared: Declared = new Map();

interface Levels {
  readonly normal: Declared;
  readonly important: Declared;
}

const nothing: Levels = { normal: nothingDeclared, important: nothingDeclared };

/** No more rules of these properties than this are followed, nor more elements for all of them together; to keep what was found takes longer. */
const mostRules = 5000;
const mostLookups = 5e7;
const lookupsPerFind = 40;
/** Nobody writes brackets deeper than this. */
const deepest = 64;

export function stylesOf(root: Element, warn: Warn): Styles {
  const bySheets = cascade(root, warn);
  const ofText = new Map<string, Levels>();
  const inline = (text: string): Levels => {
    let levels = ofText.get(text);
    if (levels === undefined) ofText.set(text, (levels = attributeOf(text)));
    return levels;
  };
  return (element) => {
    const [own, sheets] = [inline(element.getAttribute("style") ?? ""), bySheets.get(element) ?? nothing];
    if (sheets === nothing && own.important.size === 0) return own.normal;
    return new Map([...sheets.normal, ...own.normal, ...sheets.important, ...own.important]);
  };
}

/** The text of a `style` attribute, read as browsers read an SVG element's: lengths may go without a unit. */
function attributeOf(text: string): Levels {
  if (!mentioned.test(text) || bracketDepth(text) > deepest) return nothing;
  const { style } = document.createElementNS("http://www.w3.org/2000/svg", "g");
  style.cssText = text;
  return levelsOf(style);
}

/** Most rules are about colours: their names are fewer than those that are followed. */
function isFollowed({ style }: CSSStyleRule): boolean {
  // Browsers take a mask apart.
  return Array.from(style).some((name) => initials.has(name) || name === "mask-image");
}

function levelsOf(style: CSSStyleDeclaration): Levels {
  const levels = { normal: new Map<string, string>(), important: new Map<string, string>() };
  for (const [property, initial] of initials) {
    const value = style.getPropertyValue(property).trim();
    if (value === "") continue;
    const isReset = /^(?:initial|unset|revert|revert-layer|inherit)$/iu.test(value);
    const isInherited = property === "visibility" && value !== "initial";
    levels[style.getPropertyPriority(property) === "" ? "normal" : "important"].set(property, isReset && !isInherited ? initial : value);
  }
  return levels;
}

interface Rule extends Selector {
  readonly levels: Levels;
}

/** The rules from the lightest to the heaviest, so that a later one takes a lighter one's place. */
function cascade(root: Element, warn: Warn): ReadonlyMap<Element, Levels> {
  const found = new Map<Element, { normal: Map<string, string>; important: Map<string, string> }>();
  const rules = rulesOf(root, warn).sort((a, b) => a.weight - b.weight);
  if (rules.length === 0) return found;
  const extent = extentOf(root.ownerDocument);
  let lookups = 0;
  for (const { text, levels } of rules) {
    lookups += costOf(text, extent);
    if (lookups > mostLookups) {
      warn("W_STYLE", root);
      break;
    }
    for (const element of matching(root, text)) {
      lookups += lookupsPerFind;
      let own = found.get(element);
      if (own === undefined) found.set(element, (own = { normal: new Map(), important: new Map() }));
      for (const level of ["normal", "important"] as const) for (const [property, value] of levels[level]) own[level].set(property, value);
    }
  }
  return found;
}

function matching(root: Element, selector: string): Iterable<Element> {
  try {
    return root.ownerDocument.querySelectorAll(selector);
  } catch {
    // A namespace of the sheet's own, which nothing here has.
    return [];
  }
}

function rulesOf(root: Element, warn: Warn): Rule[] {
  const rules: Rule[] = [];
  let followed = 0;
  for (const style of root.querySelectorAll("style")) {
    if (!isMeant(style)) continue;
    if (bracketDepth(style.textContent ?? "") > deepest) {
      warn("W_STYLE", style);
      continue;
    }
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style.textContent ?? "");
    for (const rule of styleRules(sheet.cssRules, 0, () => warn("W_STYLE", style))) {
      if (!isFollowed(rule)) continue;
      followed += 1;
      if (followed > mostRules) {
        warn("W_STYLE", style);
        return rules;
      }
      const levels = levelsOf(rule.style);
      for (const selector of selectorsOf(rule.selectorText)) rules.push({ ...selector, levels });
    }
  }
  return rules;
}

function isMeant(style: Element): boolean {
  const [type, media] = [style.getAttribute("type") ?? "", style.getAttribute("media") ?? ""];
  return /^(?:text\/css)?$/iu.test(type.trim()) && (media === "" || matchMedia(media).matches) && mentioned.test(style.textContent ?? "");
}

/** Rules that apply here, also from inside conditions; layers and rules in rules are not followed. */
function* styleRules(rules: CSSRuleList, depth: number, skipped: () => void): Generator<CSSStyleRule> {
  for (const rule of rules) {
    if (rule instanceof CSSStyleRule) {
      yield rule;
      if (rule.cssRules.length > 0 && mentioned.test(rule.cssText)) skipped();
    } else if (rule instanceof CSSMediaRule || rule instanceof CSSSupportsRule) {
      const holds = rule instanceof CSSMediaRule ? matchMedia(rule.media.mediaText).matches : CSS.supports(rule.conditionText);
      if (holds && depth < 8) yield* styleRules(rule.cssRules, depth + 1, skipped);
    } else if (rule instanceof CSSGroupingRule && mentioned.test(rule.cssText)) skipped();
  }
}

export function isHidden(element: Element, css: Declared): boolean {
  return (css.get("display") ?? element.getAttribute("display")) === "none";
}

/** Whether shapes in it are seen, as long as none says otherwise: a hidden group may have children that show. */
export function isVisible(element: Element, css: Declared, around: boolean): boolean {
  const value = (css.get("visibility") ?? element.getAttribute("visibility") ?? "").trim().toLowerCase();
  return value === "visible" || (around && value !== "hidden" && value !== "collapse");
}
