import { declarations } from "./declarations.ts";

/** Selectors that are looked up at once: a class, an id or a kind of element, or several of them. */
const simple = /^[.#]?[\w-]+(?:\s*,\s*[.#]?[\w-]+)*$/u;
const mostRules = 1000;

/**
 * The elements that the document's own style sheets take out of the picture, such as hidden layers of Illustrator. The
 * sheets are read by the browser but belong to no page: nothing is styled or fetched by them.
 */
export function hiddenBySheets(root: Element): ReadonlySet<Element> {
  const hidden = new Set<Element>();
  for (const style of root.querySelectorAll("style")) {
    const text = style.textContent ?? "";
    if (!/display\s*:\s*none/iu.test(text)) continue;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    for (const rule of Array.from(sheet.cssRules).slice(0, mostRules)) {
      if (!(rule instanceof CSSStyleRule) || rule.style.display === "" || !simple.test(rule.selectorText)) continue;
      const none = rule.style.display === "none";
      // A later rule of the same weight wins.
      for (const element of root.querySelectorAll(rule.selectorText)) none ? hidden.add(element) : hidden.delete(element);
    }
  }
  return hidden;
}

export function isHidden(element: Element, bySheets: ReadonlySet<Element>): boolean {
  const own = declarations(element).get("display");
  if (own !== undefined) return own.toLowerCase() === "none";
  return bySheets.has(element) || element.getAttribute("display") === "none";
}
