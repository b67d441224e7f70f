import { bracketDepth, deepest } from "../brackets.ts";
import { inertSelector, inertStyle } from "../inert.ts";
import type { Warn } from "../lengths.ts";
import { levelsOf, mentioned, nothing, type Declared, type Levels } from "./declared.ts";
import { costOf, extentOf } from "./selectors.ts";
import { rulesOf, type Rule } from "./sheets.ts";

/**
 * What the document's own style sheets and `style` attributes say of where its shapes are and which are shown. The
 * browser reads both and looks the selectors up, but the sheets belong to no page: nothing is styled or fetched by
 * them.
 */

export type Styles = (element: Element) => Declared;

/** No more elements than this are looked at for all rules together; to keep what was found takes longer. */
const mostLookups = 5e7;
const lookupsPerFind = 40;

export function stylesOf(root: Element, warn: Warn): Styles {
  const bySheets = cascade(root, warn);
  const ofText = new Map<string, Levels>();
  const inline = (text: string): Levels => {
    let levels = ofText.get(text);
    if (levels === undefined) ofText.set(text, (levels = attributeOf(text)));
    return levels;
  };
  return (element) => {
    const [own, sheets] = [inline(element.getAttribute(inertStyle) ?? ""), bySheets.get(element) ?? nothing];
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

type Found = Map<Element, { readonly normal: Map<string, string>; readonly important: Map<string, string> }>;

/** The rules from the lightest to the heaviest, so that a later one takes a lighter one's place. */
function cascade(root: Element, warn: Warn): ReadonlyMap<Element, Levels> {
  const found: Found = new Map();
  const rules = rulesOf(root, warn).sort((a, b) => a.layer.rank - b.layer.rank || a.weight - b.weight);
  const important: { readonly rule: Rule; readonly elements: readonly Element[] }[] = [];
  const extent = rules.length === 0 ? { elements: 0, depth: 0, widest: 0 } : extentOf(root.ownerDocument);
  let lookups = 0;
  for (const rule of rules) {
    lookups += costOf(rule.text, extent);
    if (lookups > mostLookups) {
      warn("W_STYLE", root);
      break;
    }
    const elements = [...matching(root, rule.text)];
    lookups += lookupsPerFind * elements.length;
    declare(found, elements, rule, "normal");
    if (rule.levels.important.size > 0) important.push({ rule, elements });
  }
  important.sort((a, b) => b.rule.layer.rank - a.rule.layer.rank);
  for (const { rule, elements } of important) declare(found, elements, rule, "important");
  return found;
}

function declare(found: Found, elements: readonly Element[], { levels }: Rule, level: keyof Levels): void {
  for (const element of elements) {
    let own = found.get(element);
    if (own === undefined) found.set(element, (own = { normal: new Map(), important: new Map() }));
    for (const [property, value] of levels[level]) own[level].set(property, value);
  }
}

function matching(root: Element, selector: string): Iterable<Element> {
  try {
    return root.ownerDocument.querySelectorAll(inertSelector(selector));
  } catch {
    // A namespace of the sheet's own, which nothing here has.
    return [];
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
