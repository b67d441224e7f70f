import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import type { Browser, Page } from "playwright-core";
import { launch } from "../../scripts/browser.mjs";

/**
 * Where an SVG's shapes are and which are shown: what the page's reader says against the pixels that the browser draws.
 */

type Box = [left: number, top: number, right: number, bottom: number];

interface Outcome {
  /** Of all shapes together; null if there are none. */
  readonly box: Box | null;
  readonly warnings: readonly string[];
  readonly ms: number;
}

const dots = 8;
let browser: Browser | undefined;
let page: Page | undefined;

before(async () => {
  const bundle = await build({
    stdin: { contents: 'export { readSvg } from "./www/src/io/svg/svg-file.ts"; export { selectorsOf } from "./www/src/io/svg/style/selectors.ts";', resolveDir: process.cwd(), loader: "ts" },
    bundle: true, format: "iife", globalName: "reader", write: false,
  });
  browser = await launch();
  page = await browser.newPage({ viewport: { width: 100, height: 50 }, deviceScaleFactor: dots });
  await page.setContent("<!doctype html><body>");
  await page.addScriptTag({ content: bundle.outputFiles[0]?.text ?? "" });
});

after(() => browser?.close());

interface Reader {
  readSvg(text: string, boundsOf: (d: string) => { left: number; top: number; right: number; bottom: number }): { shapes: { d: string; transform: number[] }[]; warnings: { code: string }[] };
  selectorsOf(list: string): { text: string; weight: number }[];
}

function read(svg: string): Promise<Outcome> {
  assert.ok(page !== undefined);
  return page.evaluate((text) => {
    const start = performance.now();
    const { shapes, warnings } = (globalThis as unknown as { reader: Reader }).reader.readSvg(text, (d) => {
      const svg = document.body.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "svg"));
      svg.innerHTML = `<path d="${d}"/>`;
      const { x, y, width, height } = (svg.firstChild as SVGPathElement).getBBox();
      svg.remove();
      return { left: x, top: y, right: x + width, bottom: y + height };
    });
    const ms = performance.now() - start;
    document.body.innerHTML = `<svg>${shapes.map(({ d, transform }) => `<path d="${d}" transform="matrix(${transform.join()})"/>`).join("")}</svg>`;
    const corner = document.querySelector("svg")?.getBoundingClientRect();
    const boxes = Array.from(document.querySelectorAll("path"), (path) => path.getBoundingClientRect());
    document.body.replaceChildren();
    const [x, y] = [corner?.x ?? 0, corner?.y ?? 0];
    const box: Box = [Math.min(...boxes.map(({ left }) => left - x)), Math.min(...boxes.map(({ top }) => top - y)), Math.max(...boxes.map(({ right }) => right - x)), Math.max(...boxes.map(({ bottom }) => bottom - y))];
    return { box: boxes.length === 0 ? null : box, warnings: warnings.map(({ code }) => code), ms };
  }, svg);
}

/** The box of what is dark on the screen; null where nothing is. */
async function drawn(svg: string): Promise<Box | null> {
  assert.ok(page !== undefined);
  await page.evaluate((text) => {
    document.body.style.margin = "0";
    document.body.innerHTML = text;
  }, svg);
  const picture = (await page.screenshot()).toString("base64");
  return page.evaluate(async ([data, scale]) => {
    document.body.replaceChildren();
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0);
    const pixels = context?.getImageData(0, 0, image.width, image.height).data ?? [];
    let box: Box | null = null;
    for (let i = 0; i < pixels.length; i += 4) {
      if ((pixels[i] ?? 255) > 127) continue;
      const [x, y] = [(i / 4) % image.width, Math.floor(i / 4 / image.width)];
      box = box === null ? [x, y, x + 1, y + 1] : [Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x + 1), Math.max(box[3], y + 1)];
    }
    return box === null ? null : (box.map((side) => side / scale) as Box);
  }, [picture, dots] as const);
}

const ns = 'xmlns="http://www.w3.org/2000/svg"';
const framed = (inner: string): string => `<svg ${ns} viewBox="0 0 100 50" width="100" height="50" style="display:block">${inner.replace(/&(?!\w+;)/gu, "&amp;")}</svg>`;
const tile = '<rect width="10" height="10"/>';
const symbol = (attributes: string, inner = tile): string => `<symbol id="s" viewBox="0 0 10 10" ${attributes}>${inner}</symbol>`;

type Case = readonly [what: string, inner: string, box: Box | null];

const frames: readonly Case[] = [
  ["an inner picture that a use gives a size", '<defs><svg id="q" viewBox="0 0 1 1" width="10" height="10"><rect width="1" height="1"/></svg></defs><use href="#q" width="30" height="30"/>', [0, 0, 30, 30]],
  ["a symbol that a use places and gives a size", `${symbol("")}<use href="#s" x="5" y="5" width="50%" height="20"/>`, [20, 5, 40, 25]],
  ["a symbol that nothing gives a size", `${symbol("")}<use href="#s"/>`, [25, 0, 75, 50]],
  ["a symbol with a size of its own", `${symbol('width="20" height="20"')}<use href="#s"/>`, [0, 0, 20, 20]],
  ["a symbol with a size of its own, of which a use says one side", `${symbol('width="20" height="20"')}<use href="#s" width="10"/>`, [0, 5, 10, 15]],
  ["a symbol with a place and a transform of its own", `${symbol('x="3" y="4" width="20" height="20" transform="translate(7 1)"')}<use href="#s"/>`, [10, 5, 30, 25]],
  ["a symbol that is stretched", `${symbol('preserveAspectRatio="none"')}<use href="#s"/>`, [0, 0, 100, 50]],
  ["a symbol aligned to an end", `${symbol('preserveAspectRatio="xMaxYMid"')}<use href="#s"/>`, [50, 0, 100, 50]],
  ["percentages in a symbol with a view box", `${symbol("", '<rect width="50%" height="50%"/>')}<use href="#s" width="20" height="20"/>`, [0, 0, 10, 10]],
  ["percentages in a symbol without one", '<symbol id="s"><rect width="50%" height="50%"/></symbol><use href="#s" width="20" height="10"/>', [0, 0, 10, 5]],
  ["a symbol used in a smaller picture", `${symbol("")}<svg x="60" width="20" height="20"><use href="#s"/></svg>`, [60, 0, 80, 20]],
  ["an inner picture without a size", `<svg viewBox="0 0 10 10">${tile}</svg>`, [25, 0, 75, 50]],
  ["an inner picture of which one side is said", `<svg width="20" viewBox="0 0 10 10">${tile}</svg>`, [0, 15, 20, 35]],
  ["an inner picture of automatic size", `<svg width="auto" height="20" viewBox="0 0 10 10">${tile}</svg>`, [40, 0, 60, 20]],
  ["an inner picture without area", `<svg width="0" height="20">${tile}</svg><svg width="20" height="0" viewBox="0 0 10 10">${tile}</svg>`, null],
  ["a group, which a use gives no size", `<g id="s">${tile}</g><use href="#s" x="20" width="50" height="50"/>`, [0, 0, 30, 10]],
];

const bySheets: readonly Case[] = [
  ["a transform of a rule", `<style>.t{transform:translate(50px,20px)}</style><rect class="t" width="10" height="10"/>`, [50, 20, 60, 30]],
  ["a transform of a symbol's rule", `<style>#s{transform:translate(9px)}</style>${symbol('width="20" height="20"')}<use href="#s"/>`, [9, 0, 29, 20]],
  ["what a hidden attribute says", `<rect visibility="hidden" width="80" height="9"/>${tile}`, [0, 0, 10, 10]],
  ["what a hidden group has, but for what shows", `<g visibility="hidden"><rect width="80" height="9"/><g style="visibility: visible"><rect x="30" width="10" height="10"/></g></g>`, [30, 0, 40, 10]],
  ["what is hidden where it is used", `<defs><g id="h"><rect width="80" height="9"/><rect visibility="visible" x="30" width="10" height="10"/></g></defs><use href="#h" visibility="hidden"/>`, [30, 0, 40, 10]],
  ["what is collapsed", '<rect visibility="collapse" width="10" height="10"/>', null],
  ["a symbol that is not displayed", `${symbol('display="none"')}<use href="#s"/>`, null],
  ["a shape in a group that is not displayed, where it is used", `<g display="none"><rect id="r" width="10" height="10"/></g><use href="#r" x="5"/>`, [5, 0, 15, 10]],
  ["rules for what is inside", `<style>g .x{display:none} svg g.y > rect{display:none}</style><g><rect class="x" width="80" height="9"/></g><g class="y"><rect width="50" height="50"/></g>${tile}`, [0, 0, 10, 10]],
  ["a rule for a long list of classes", `<style>${Array.from({ length: 500 }, (_, i) => `.cls-${i}`).join()}{x:20px}</style><rect class="cls-499" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["rules for what comes after", `<style>rect + rect ~ rect{display:none} :not(#a):nth-child(3){x:30px}</style><rect id="a" width="5" height="5"/><rect width="10" height="10"/><rect width="80" height="9"/>`, [0, 0, 40, 10]],
  ["the rule of the heavier selector", `<style>#a{x:50px} rect.b{x:40px} .b{x:30px} rect{x:20px}</style><rect id="a" class="b" width="10" height="10"/>`, [50, 0, 60, 10]],
  ["of equal rules the later, over those that weigh nothing", `<style>.a{x:20px} .b{x:30px} :where(#a.a){x:40px}</style><rect id="a" class="a b" width="10" height="10"/>`, [30, 0, 40, 10]],
  ["a selector with a heavy part in it", `<style>rect:is(#z, .a){x:20px} .a.a.a{x:30px}</style><rect class="a" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["an important rule over a style", `<style>rect{x:20px!important}</style><rect x="5" width="10" height="10" style="x:40px"/>`, [20, 0, 30, 10]],
  ["an important style over an important rule", `<style>rect{x:20px!important}</style><rect width="10" height="10" style="x:40px!important"/>`, [40, 0, 50, 10]],
  ["sizes of a rule", "<style>rect{width:50px;height:30px;x:10%;rx:4px}</style><rect/>", [10, 0, 60, 30]],
  ["sizes of a style", '<rect style="width:20px;height:10%;y:calc(10px + 5px)"/>', [0, 15, 20, 20]],
  ["sizes of a style without units", '<rect style="width:20;height:15" width="5" height="5"/>', [0, 0, 20, 15]],
  ["a rounder circle than its attribute says", '<circle r="5" style="r:20px;cx:30px;cy:25"/>', [10, 5, 50, 45]],
  ["radii of an ellipse by a rule", "<style>ellipse{cx:50%;cy:50%;rx:20px;ry:10px}</style><ellipse/>", [30, 15, 70, 35]],
  ["a path by a style", `<path d="M0 0H5V5" style="d:path('M0 0L20 20V0z')"/>`, [0, 0, 20, 20]],
  ["a use that a style places", `${symbol('width="20" height="20"')}<use href="#s" x="5" style="x:30px"/>`, [30, 0, 50, 20]],
  ["a property that is set back", `<style>rect{transform:translate(50px);x:9px}</style><rect width="10" height="10" style="transform:initial;x:unset"/>`, [0, 0, 10, 10]],
  ["rules under conditions", `<style>@media screen{rect{x:20px}} @media print{rect{x:50px}} @supports (display:nonsense){rect{x:70px}}</style>${tile}`, [20, 0, 30, 10]],
  ["a sheet for paper", `<style media="print">rect{x:20px}</style>${tile}`, [0, 0, 10, 10]],
  ["a sheet of another language", `<style type="text/less">rect{x:20px}</style>${tile}`, [0, 0, 10, 10]],
];

const nested: readonly Case[] = [
  ["a rule in a rule", `<style>.g{rect{x:20px}}</style><rect width="10" height="10"/><g class="g"><rect width="10" height="10"/></g>`, [0, 0, 30, 10]],
  ["a rule for the same element", `<style>rect{&.a{x:20px}}</style><rect class="a" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["a rule for children alone", `<style>.g{>rect{x:20px}}</style><g class="g"><g><rect width="10" height="10"/></g></g>`, [0, 0, 10, 10]],
  ["a rule for an element inside another that follows", `<style>.a,.b{x:5px;g &{x:20px}}</style><g><rect class="b" width="10" height="10"/></g>`, [20, 0, 30, 10]],
  ["rules three deep", `<style>svg{.g{y:1px;& .h{&>rect{x:20px}}}}</style><g class="g"><g class="h"><rect width="10" height="10"/></g></g>`, [20, 0, 30, 10]],
  ["what stands after a rule in a rule", `<style>rect{x:20px;&.z{x:9px}x:30px}</style><rect class="a" width="10" height="10"/>`, [30, 0, 40, 10]],
  ["a condition in a rule", `<style>rect{@media screen{x:20px;&.a{y:5px}}@media print{x:70px}}</style><rect class="a" width="10" height="10"/>`, [20, 5, 30, 15]],
  ["a rule in a rule, as heavy as the heaviest of the outer ones", `<style>#no,.g{rect{x:20px}} .g.g.g rect{x:50px}</style><g class="g"><rect width="10" height="10"/></g>`, [20, 0, 30, 10]],
  ["a rule in a rule of one selector, as heavy as both", `<style>.g{.a{x:20px}} .a{x:50px}</style><g class="g"><rect class="a" width="10" height="10"/></g>`, [20, 0, 30, 10]],
  ["an outer rule in brackets", `<style>.a{:is(&,.z){x:20px} rect&{y:5px} & &{x:60px}}</style><rect class="a" width="10" height="10"/>`, [20, 5, 30, 15]],
  ["an outer rule where there is none", `<style>& rect{x:20px}</style>${tile}`, [20, 0, 30, 10]],
  ["a kind after a class", `<style>.a{&:not(circle){x:20px}}</style><rect class="a" width="10" height="10"/>`, [20, 0, 30, 10]],
];

const layered: readonly Case[] = [
  ["a rule of a layer", `<style>@layer a{rect{x:20px}}</style>${tile}`, [20, 0, 30, 10]],
  ["a light rule of a later layer", `<style>@layer a{#r{x:50px}}@layer b{rect{x:20px}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["layers in the order that was said first", `<style>@layer b,a;@layer a{rect{x:20px}}@layer b{#r{x:50px}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["a rule of no layer", `<style>rect{x:20px}@layer a{#r{x:50px}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["an important rule of the earlier layer", `<style>@layer a{rect{x:20px!important}}@layer b{#r{x:50px!important}}#r{x:60px!important}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["a layer's own rules over those of layers in it", `<style>@layer a{rect{x:20px}@layer b{#r{x:50px}}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["a layer in a layer by its long name", `<style>@layer a.b,a.c;@layer a{@layer c{rect{x:20px}}@layer b{#r{x:50px}}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["layers without names, each its own", `<style>@layer{#r{x:50px}}@layer{rect{x:20px}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["layers of two sheets", `<style>@layer b,a;</style><style>@layer a{rect{x:20px}}@layer b{#r{x:50px}}</style><rect id="r" width="10" height="10"/>`, [20, 0, 30, 10]],
  ["a layer in a rule, and a condition in a layer", `<style>@layer a{@media screen{g{@layer b{rect{x:20px}}}}}</style><g>${tile}</g>`, [20, 0, 30, 10]],
  ["where an animation starts, which is not where it stands", `<style>@starting-style{rect{x:20px}}</style>${tile}`, [0, 0, 10, 10]],
  ["rules for what has a style", `<style>[style]{x:20px} rect[ style*="fill" ]{y:5px}</style><rect style="fill:#000" width="10" height="10"/>`, [20, 5, 30, 15]],
];

const boxes: readonly Case[] = [
  ["a step by a share of the viewport", '<rect style="transform:translate(20%,calc(10% + 5px))" width="10" height="10"/>', [20, 10, 30, 20]],
  ["a step by a share of an inner picture", '<svg width="50" height="50" viewBox="0 0 100 100"><rect style="transform:translateX(20%) translateY(10%)" width="10" height="10"/></svg>', [10, 5, 15, 10]],
  ["a step of its own by a share", '<rect style="translate:20% 10%" width="10" height="10"/>', [20, 5, 30, 15]],
  ["a step by a share of the shape", '<rect style="transform-box:fill-box;transform:translate(200%,50%)" x="5" width="10" height="20"/>', [25, 10, 35, 30]],
  ["a step back by half of the shape", '<circle style="transform-box:fill-box;transform:translate(-50%,-50%)" cx="30" cy="20" r="10"/>', [10, 0, 30, 20]],
  ["a growth about the middle of the viewport", '<rect style="transform:scale(2);transform-origin:center" x="40" y="20" width="10" height="10"/>', [30, 15, 50, 35]],
  ["a growth about the middle of the shape", '<rect style="transform:scale(2);transform-box:fill-box;transform-origin:center" x="40" y="20" width="10" height="10"/>', [35, 15, 55, 35]],
  ["a growth about a corner of the shape by an attribute", '<rect transform="scale(2)" transform-origin="bottom right" style="transform-box:fill-box" x="40" y="20" width="10" height="10"/>', [30, 10, 50, 30]],
  ["a growth about one side", '<rect style="transform:scale(2);transform-box:fill-box;transform-origin:top" x="40" y="20" width="10" height="10"/>', [35, 20, 55, 40]],
  ["a growth about a share of the viewport", '<rect style="scale:50%;transform-origin:100% 20%" width="10" height="10"/>', [50, 5, 55, 10]],
  ["a turn about the middle of a group", '<g style="rotate:90deg;transform-box:fill-box;transform-origin:50% 50%"><rect x="20" y="20" width="10" height="5"/><rect x="40" y="25" width="20" height="5" transform="translate(5 0)"/></g>', [37.5, 2.5, 47.5, 47.5]],
  ["a growth about the middle of what a use draws, before it is placed", `${symbol('width="20" height="20"')}<use href="#s" x="30" y="10" style="scale:.5;transform-box:fill-box;transform-origin:center"/>`, [20, 10, 30, 20]],
  ["a growth inside another", '<g style="scale:2;transform-box:fill-box;transform-origin:0 0"><rect style="scale:2;transform-box:fill-box;transform-origin:center" x="20" y="10" width="10" height="10"/></g>', [15, 5, 55, 45]],
  ["what is in no third dimension", '<rect style="transform:translateZ(0) translate3d(20px,5px,0) rotateZ(90deg) scale3d(1,2,1)" width="10" height="10"/>', [0, 5, 20, 15]],
];

for (const [title, cases] of [["frames", frames], ["CSS", bySheets], ["rules in rules", nested], ["layers", layered], ["boxes", boxes]] as const) {
  for (const [what, inner, box] of cases) {
    test(`${title}: ${what} is where the browser draws it`, async () => {
      const outcome = await read(framed(inner));
      const seen = await drawn(framed(inner));
      // A side between two pixels is up to half of one away.
      const near = (a: Box | null, b: Box | null): boolean => (a === null || b === null ? a === b : a.every((side, i) => Math.abs(side - (b[i] ?? NaN)) <= 0.6 / dots));
      assert.ok(near(seen, box), `drawn at ${String(seen)}`);
      assert.ok(near(outcome.box, seen), `read at ${String(outcome.box)}, drawn at ${String(seen)}`);
      assert.deepEqual(outcome.warnings, []);
    });
  }
}

test("what of a style sheet is not followed is told", async () => {
  for (const inner of ["<style>@container (width>1px){rect{x:20px}}</style>", "<style>@scope (g){rect{x:20px}}</style>", '<style>rect{transform-box:stroke-box;transform-origin:center;transform:scale(2)}</style>', '<style>rect{transform:rotateX(30deg)}</style>', '<path d="M0 0" style="d:var(--d)"/>']) {
    const { warnings } = await read(framed(inner + tile));
    assert.ok(warnings.some((code) => code.startsWith("W_STYLE")), inner.slice(0, 80));
  }
  for (const inner of ["<style>@layer a{rect{fill:red}} @font-face{font-family:x}</style>", "<style>rect{fill:red}</style>"]) {
    assert.deepEqual((await read(framed(inner + tile))).warnings, []);
  }
});

test("a style attribute with calls within calls is not followed", async () => {
  const { box } = await read(framed(`<rect width="10" height="10" style="x:${"calc(".repeat(100_000)}1px${")".repeat(100_000)}"/>`));
  assert.deepEqual(box, [0, 0, 10, 10]);
});

test("a symbol without a size in a picture without one is as large as its box, and that is told", async () => {
  const { box, warnings } = await read(`<svg ${ns}>${symbol("")}<use href="#s"/></svg>`);
  assert.deepEqual(box, [0, 0, 10, 10]);
  assert.deepEqual(warnings, ["W_UNIT"]);
});

/** 20,000 shapes side by side, and sheets that would have each looked at many times over. */
const hostile: readonly (readonly [what: string, css: string])[] = [
  ["looks sideways", ".z ~ .a{x:1px} :is(.z ~ .a, .c) ~ .a{x:2px}"],
  ["looks ahead", "rect:has(~ .q){x:1px}"],
  ["counts", ":nth-last-child(2n+1 of .a:nth-child(2n of .a)){x:1px}"],
  ["has 20,000 rules", Array.from({ length: 20_000 }, (_, i) => `.a:not(.b${i}){x:${i}px}`).join("")],
  ["has 400,000 rules", "a{x:1}".repeat(400_000)],
  ["has rules in rules that double", `${"&,& &{".repeat(30)}x:1px`],
  ["has calls within calls", `${":is(".repeat(500)}a${")".repeat(500)}{x:1px}`],
  ["has a selector of 100,000 parts", `${"a,".repeat(100_000)}a{x:1px}`],
  ["has conditions in conditions", `${"@media all{".repeat(500)}a{x:1px}`],
];

for (const [what, css] of hostile) {
  test(`a hostile style sheet that ${what} is given up in time, and that is told`, async (t) => {
    const { ms, warnings } = await read(`<svg ${ns}><style>${css.replaceAll("&", "&amp;").replaceAll(">", "&gt;")}</style>${'<rect class="a" width="1" height="1"/>'.repeat(20_000)}</svg>`);
    t.diagnostic(`${ms.toFixed(0)} ms`);
    assert.ok(warnings.includes("W_STYLE"), warnings.join());
    // A page that is asked for as much by a plain drawing of this size answers as late on a busy machine.
    assert.ok(ms < 20_000, `${ms} ms`);
  });
}

/** By the rules of CSS: ids, then classes, attributes and pseudo-classes, then kinds. */
const weights: readonly (readonly [selector: string, ids: number, classes: number, kinds: number])[] = [
  ["*", 0, 0, 0], ["li", 0, 0, 1], ["ul li", 0, 0, 2], ["ul ol + li", 0, 0, 3], ["h1 + *[rel=\"up]\"]", 0, 1, 1], ["ul ol li.red", 0, 1, 3],
  ["li.red.level", 0, 2, 1], ["#x34y", 1, 0, 0], ["#s12:not(foo)", 1, 0, 1], [".foo :is(.bar, #baz)", 1, 1, 0], [":where(#a) b", 0, 0, 1],
  ["a:nth-child(2n+1)", 0, 1, 1], ["a::before", 0, 0, 2], [".\\31 23 > a\\.b", 0, 1, 1], [":not(a, :is(b c, .d))", 0, 1, 0],
];

test("selectors weigh what the standard says, in a list each by itself", async () => {
  const list = weights.map(([text]) => text).join(", ");
  const found = (await page?.evaluate((text) => (globalThis as unknown as { reader: Reader }).reader.selectorsOf(text), list)) ?? [];
  assert.deepEqual(found.map(({ text, weight }) => [text.trim(), weight]), weights.map(([text, a, b, c]) => [text, a * 2 ** 32 + b * 2 ** 16 + c]));
});
