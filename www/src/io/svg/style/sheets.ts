import { bracketDepth, deepest } from "../brackets.ts";
import { inertStyle } from "../inert.ts";
import type { Warn } from "../lengths.ts";
import { levelsOf, isFollowed, mentioned, type Levels } from "./declared.ts";
import { layerIn, outermost, rankLayers, type Layer } from "./layers.ts";
import { nestedIn, selectorsOf, type Selector } from "./selectors.ts";

/** The rules of a document's own style sheets, as the browser reads them. */

export interface Rule extends Selector {
  readonly levels: Levels;
  readonly layer: Layer;
}

/** No more rules than this, of the properties that are followed. */
const mostRules = 5000;

export function rulesOf(root: Element, warn: Warn): Rule[] {
  const rules: Rule[] = [];
  const layers = outermost();
  let followed = 0;
  for (const style of root.querySelectorAll(inertStyle)) {
    if (!isMeant(style)) continue;
    const skipped = (): void => warn("W_STYLE", style);
    if (bracketDepth(style.textContent ?? "") > deepest) {
      skipped();
      continue;
    }
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style.textContent ?? "");
    for (const { selectors, style: text, layer } of rulesIn(sheet.cssRules, { layer: layers, outer: null, conditions: 0, skipped })) {
      if (!isFollowed(text)) continue;
      followed += 1;
      if (followed > mostRules) {
        skipped();
        break;
      }
      const levels = levelsOf(text);
      for (const selector of selectors) rules.push({ ...selector, levels, layer });
    }
  }
  rankLayers(layers);
  return rules;
}

function isMeant(style: Element): boolean {
  const [type, media] = [style.getAttribute("type") ?? "", style.getAttribute("media") ?? ""];
  const says = (pattern: RegExp): boolean => pattern.test(style.textContent ?? "");
  return /^(?:text\/css)?$/iu.test(type.trim()) && (media === "" || matchMedia(media).matches) && (says(mentioned) || says(/@layer/iu));
}

/** Where a list of rules stands. */
interface Within {
  readonly layer: Layer;
  /** The selectors of the rule around. */
  readonly outer: readonly Selector[] | null;
  readonly conditions: number;
  /** Something may have been said here that is not followed. */
  readonly skipped: () => void;
}

interface Declarations {
  readonly selectors: readonly Selector[];
  readonly style: CSSStyleDeclaration;
  readonly layer: Layer;
}

/** Rules that apply here, also from inside conditions, layers and other rules. */
function* rulesIn(rules: CSSRuleList, within: Within): Generator<Declarations> {
  const { layer, outer, conditions, skipped } = within;
  for (const rule of rules) {
    if (rule instanceof CSSStyleRule) yield* ruleAndInner(rule, within);
    // What stands after a rule in a rule.
    else if (outer !== null && "style" in rule) yield { selectors: outer, style: rule.style as CSSStyleDeclaration, layer };
    else if (rule instanceof CSSLayerStatementRule) for (const name of rule.nameList) layerIn(layer, name);
    else if (rule instanceof CSSLayerBlockRule) yield* rulesIn(rule.cssRules, { ...within, layer: layerIn(layer, rule.name) });
    else if (rule instanceof CSSMediaRule || rule instanceof CSSSupportsRule) {
      const holds = rule instanceof CSSMediaRule ? matchMedia(rule.media.mediaText).matches : CSS.supports(rule.conditionText);
      if (holds && conditions < 8) yield* rulesIn(rule.cssRules, { ...within, conditions: conditions + 1 });
    } else if (rule instanceof CSSGroupingRule && !isStart(rule) && mentioned.test(rule.cssText)) skipped();
  }
}

/** Where an animation comes from is not where it stands. */
function isStart(rule: CSSRule): boolean {
  return rule.cssText.startsWith("@starting-style");
}

function* ruleAndInner(rule: CSSStyleRule, within: Within): Generator<Declarations> {
  const text = nestedIn(rule.selectorText, within.outer);
  if (text === null) {
    if (mentioned.test(rule.cssText)) within.skipped();
    return;
  }
  const isEmpty = !isFollowed(rule.style);
  // The selectors of most rules need not be looked at.
  if (isEmpty && rule.cssRules.length === 0) return;
  const selectors = selectorsOf(text);
  if (!isEmpty) yield { selectors, style: rule.style, layer: within.layer };
  if (rule.cssRules.length > 0) yield* rulesIn(rule.cssRules, { ...within, outer: selectors });
}
