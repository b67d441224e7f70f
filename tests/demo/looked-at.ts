import assert from "node:assert/strict";
import type { Page } from "playwright-core";

/** What can be measured of how well everybody can use a page: the demo's, and the documentation's. */

/** Something on a page that not everybody can use. */
export interface Finding {
  readonly what: string;
  readonly why: string;
}

/**
 * Interactive elements that are shown and have no name, or a box below 24 × 24; canvases and pictures without a text.
 * Links in `sentences` are as high as their lines.
 */
export function namesAndTargets(page: Page, sentences = "p"): Promise<Finding[]> {
  return page.evaluate((inText) => {
    const findings: { what: string; why: string }[] = [];
    const describe = (element: Element): string => `${element.localName}[${element.getAttribute("data-testid") ?? element.getAttribute("class") ?? ""}] ${element.textContent?.slice(0, 30) ?? ""}`;
    const nameOf = (element: Element): string => {
      const labels = "labels" in element && element.labels instanceof NodeList ? [...element.labels].map((label) => label.textContent ?? "").join(" ") : "";
      const by = (element.getAttribute("aria-labelledby") ?? "").split(" ").map((id) => document.getElementById(id)?.textContent ?? "").join(" ");
      const text = element instanceof HTMLInputElement || element instanceof HTMLSelectElement || element instanceof HTMLTextAreaElement ? "" : (element.textContent ?? "");
      return [element.getAttribute("aria-label"), by, labels, text].join(" ").trim();
    };
    for (const element of document.querySelectorAll("a[href], button, input, select, textarea, summary, [role=button], [role=tab], [role=slider], [tabindex='0']")) {
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: false })) continue;
      const box = element.getBoundingClientRect();
      if (nameOf(element) === "") findings.push({ what: describe(element), why: "has no name" });
      const inline = element.localName === "a" && element.closest(inText) !== null;
      if (!inline && (box.width < 23.99 || box.height < 23.99)) findings.push({ what: describe(element), why: `is ${box.width.toFixed(1)} × ${box.height.toFixed(1)}` });
    }
    for (const element of document.querySelectorAll("canvas, img, svg")) {
      const host = element.closest("[aria-hidden=true], [role=application], [aria-label]");
      const own = element.getAttribute("aria-label") ?? element.getAttribute("alt");
      if (host === null && own === null) findings.push({ what: describe(element), why: "has no text alternative" });
    }
    return findings;
  }, sentences);
}

/** Text below 4.5 : 1 (3 : 1 when large), and outlines of controls below 3 : 1, against what is painted behind them. */
export function lowContrast(page: Page): Promise<Finding[]> {
  return page.evaluate(() => {
    type Colour = readonly [number, number, number, number];
    const probe = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const parse = (text: string): Colour => {
      if (probe === null) return [0, 0, 0, 0];
      probe.clearRect(0, 0, 1, 1);
      probe.fillStyle = text;
      probe.fillRect(0, 0, 1, 1);
      const [r = 0, g = 0, b = 0, a = 0] = probe.getImageData(0, 0, 1, 1).data;
      return [r, g, b, a / 255];
    };
    const over = (top: Colour, under: Colour): Colour => {
      const mix = (i: 0 | 1 | 2): number => top[i] * top[3] + under[i] * (1 - top[3]);
      return [mix(0), mix(1), mix(2), 1];
    };
    const behind = (element: Element | null): Colour => {
      if (element === null) return [255, 255, 255, 1];
      const own = parse(getComputedStyle(element).backgroundColor);
      return own[3] >= 1 ? own : over(own, behind(element.parentElement));
    };
    const luminance = (colour: Colour): number => {
      const linear = (value: number): number => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4);
      return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
    };
    const ratio = (a: Colour, b: Colour): number => {
      const [x, y] = [luminance(a), luminance(b)];
      return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
    };
    const findings: { what: string; why: string }[] = [];
    const seen = (element: Element): boolean => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && element.closest(":disabled, .visually-hidden, fieldset:disabled") === null;
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const element = node.parentElement;
      if (element === null || (node.textContent ?? "").trim() === "" || !seen(element) || element.closest("label:has(:disabled), option, script, style") !== null) continue;
      const style = getComputedStyle(element);
      const paper = behind(element);
      const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && Number(style.fontWeight) >= 700);
      const found = ratio(over(parse(style.color), paper), paper);
      if (found < (large ? 3 : 4.5)) findings.push({ what: (node.textContent ?? "").trim().slice(0, 40), why: `text ${found.toFixed(2)} : 1` });
    }
    for (const element of document.querySelectorAll("input:not([type=range], [type=checkbox], [type=radio], [type=file]), select, textarea, .button")) {
      if (!seen(element)) continue;
      const style = getComputedStyle(element);
      if (parseFloat(style.borderTopWidth) === 0) continue;
      const paper = behind(element.parentElement);
      const outline = ratio(over(parse(style.borderTopColor), paper), paper);
      const fill = ratio(behind(element), paper);
      if (Math.max(outline, fill) < 3) findings.push({ what: element.getAttribute("data-testid") ?? element.localName, why: `outline ${outline.toFixed(2)} : 1` });
    }
    return findings;
  });
}

/** Fails with all of them. */
export function assertNone(findings: readonly Finding[], where = ""): void {
  assert.equal(findings.map(({ what, why }) => `${where} ${what}: ${why}`).join("\n"), "");
}

/** By how many pixels a page is wider than its window. */
export async function overflow(page: Page): Promise<number> {
  return page.evaluate(() => Math.max(document.documentElement.scrollWidth, document.body.scrollWidth) - window.innerWidth);
}
