import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import type { Browser, Page } from "playwright-core";
import { launch } from "../../scripts/browser.mjs";

/** SVG documents under hostile input, read by the page's own reader in a page that has nothing else in it. */

interface Outcome {
  readonly code?: string;
  readonly detail?: { readonly reason?: string; readonly limit?: string; readonly line?: number };
  readonly shapes: readonly { readonly d: string; readonly transform: readonly number[] }[];
  readonly warnings: readonly string[];
  readonly ran: number;
  readonly ms: number;
}

let browser: Browser | undefined;
let page: Page | undefined;
const requests: string[] = [];

before(async () => {
  const bundle = await build({
    stdin: { contents: 'export { readSvg } from "./www/src/io/svg/svg-file.ts"; export { escapeXml, writeSvg } from "./www/src/io/svg/svg-write.ts";', resolveDir: process.cwd(), loader: "ts" },
    bundle: true, format: "iife", globalName: "reader", write: false,
  });
  browser = await launch();
  page = await browser.newPage();
  page.on("request", (request) => requests.push(request.url()));
  await page.addScriptTag({ content: bundle.outputFiles[0]?.text ?? "" });
});

after(() => browser?.close());

function read(svg: string): Promise<Outcome> {
  assert.ok(page !== undefined);
  return page.evaluate((text) => {
    const host = globalThis as unknown as { reader: { readSvg(text: string): { shapes: Outcome["shapes"]; warnings: { code: string }[] } }; ran?: number };
    host.ran = 0;
    const start = performance.now();
    try {
      const { shapes, warnings } = host.reader.readSvg(text);
      return { shapes, warnings: warnings.map(({ code }) => code), ran: host.ran, ms: performance.now() - start };
    } catch (error) {
      const { code, detail } = error as { code: string; detail: Outcome["detail"] };
      return { code, ...(detail === undefined ? {} : { detail }), shapes: [], warnings: [], ran: host.ran, ms: performance.now() - start };
    }
  }, svg);
}

const ns = "xmlns='http://www.w3.org/2000/svg'";
const path = "<path d='M0 0L1 1'/>";

function nested(depth: number, tag: string, inner = path): string {
  return `<svg ${ns}>${`<g ${tag}>`.repeat(depth)}${inner}${"</g>".repeat(depth)}</svg>`;
}

function useTree(levels: number, fan: number): string {
  let defs = `<path id='l0' d='M0 0L1 1'/>`;
  for (let level = 1; level <= levels; level += 1) defs += `<g id='l${level}'>${`<use href='#l${level - 1}'/>`.repeat(fan)}</g>`;
  return `<svg ${ns}><defs>${defs}</defs><use href='#l${levels}'/></svg>`;
}

function useChain(length: number): string {
  let defs = `<path id='c0' d='M0 0L1 1'/>`;
  for (let i = 1; i <= length; i += 1) defs += `<use id='c${i}' href='#c${i - 1}'/>`;
  return `<svg ${ns}><defs>${defs}</defs><use href='#c${length}'/></svg>`;
}

const laughs = `<!DOCTYPE svg [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;'>]><svg ${ns}><text>&b;</text>${path}</svg>`;

const refused: readonly (readonly [id: string, what: string, svg: () => string, code: string, why: string])[] = [
  ["SV-025", "entities that multiply", () => laughs, "E_PARSE_SVG", "doctype"],
  ["SV-025b", "an entity that names a file", () => `<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/hosts'>]><svg ${ns}><text>&a;</text>${path}</svg>`, "E_PARSE_SVG", "doctype"],
  ["SV-025c", "an entity with markup in it", () => `<!DOCTYPE svg [<!ENTITY a '<g/>'>]><svg ${ns}>&a;${path}</svg>`, "E_PARSE_SVG", "doctype"],
  ["SV-025d", "a plain entity of 10 000 letters, written a thousand times", () => `<!DOCTYPE svg [<!ENTITY a '${"x".repeat(10_000)}'>]><svg ${ns}><desc>${"&a;".repeat(1000)}</desc>${path}</svg>`, "E_LIMIT", "maxBytes"],
  ["SV-028", "100 000 nested groups", () => nested(100_000, ""), "E_LIMIT", "maxDepth"],
  ["SV-028b", "a style sheet of 100 000 calls in one another", () => `<svg ${ns}><style>${":is(".repeat(100_000)}a${")".repeat(100_000)}{x:1px}</style>${path}</svg>`, "E_LIMIT", "maxDepth"],
  ["SV-028c", "the same with coded brackets", () => `<svg ${ns}><style>${":is&#x28;".repeat(100_000)}a${")".repeat(100_000)}{x:1px}</style>${path}</svg>`, "E_LIMIT", "maxDepth"],
  ["SV-029", "a million siblings", () => `<svg ${ns}>${"<g/>".repeat(1_000_000)}</svg>`, "E_LIMIT", "maxNodes"],
  ["SV-031", "a tree of uses that would draw 10 000 million times", () => useTree(10, 10), "E_LIMIT", "maxUseExpansion"],
  ["SV-031b", "a chain of 50 000 uses", () => useChain(50_000), "E_LIMIT", "maxDepth"],
  ["SV-038", "a thousand nested scalings", () => nested(1000, "transform='scale(10)'"), "E_LIMIT", "maxDepth"],
  ["SV-039", "sixty nested scalings by a million", () => nested(60, "transform='scale(1000000)'"), "E_RANGE", ""],
  ["SV-046", "a page of HTML", () => "<!doctype html><html><body>404</body></html>", "E_PARSE_SVG", "root"],
  ["SV-046d", "a page of HTML with pictures of other kinds", () => "<html><body><img src='http://example.invalid/x.png'><canvas></canvas></body></html>", "E_PARSE_SVG", ""],
  ["SV-046b", "broken markup", () => `<svg ${ns}>\n<path d='M0 0'></svg>`, "E_PARSE_SVG", "markup"],
  ["SV-046c", "text that is no markup", () => "hello", "E_PARSE_SVG", "markup"],
  ["SV-051", "a hundred megabytes", () => `<svg ${ns}>${" ".repeat(20 * 1024 * 1024)}</svg>`, "E_LIMIT", "maxBytes"],
  ["SV-052", "an element with 100 000 attributes", () => `<svg ${ns}><path ${Array.from({ length: 100_000 }, (_, i) => `a${i}='1'`).join(" ")}/></svg>`, "E_LIMIT", "maxAttributes"],
  ["SV-018b", "a path of a million commands", () => `<svg ${ns}><path d='M0 0${"l1 1".repeat(1_000_000)}'/></svg>`, "E_LIMIT", "maxCommands"],
];

for (const [id, what, make, code, why] of refused) {
  test(`${id} ${what}: ${code} ${why}`, async (t) => {
    const outcome = await read(make());
    t.diagnostic(`${outcome.ms.toFixed(0)} ms`);
    assert.equal(outcome.code, code);
    if (why !== "") assert.ok(outcome.detail?.reason === why || outcome.detail?.limit === why, JSON.stringify(outcome.detail));
  });
}

const accepted: readonly (readonly [id: string, what: string, svg: string, shapes: number, warning: string | null])[] = [
  ["SV-027", "a plain document type", `<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd"><svg ${ns}>${path}</svg>`, 1, null],
  ["SV-030", "a use of its own ancestor", `<svg ${ns}><g id='a'><use href='#a'/></g></svg>`, 0, "W_CYCLE"],
  ["SV-030b", "two that use each other", `<svg ${ns}><g id='a'><use href='#b'/>${path}</g><g id='b'><use href='#a'/></g></svg>`, 2, "W_CYCLE"],
  ["SV-030c", "a ring of uses", `<svg ${ns}><use id='u' href='#v'/><use id='v' href='#u'/>${path}</svg>`, 1, "W_CYCLE"],
  ["SV-032", "scripts, handlers and foreign objects", `<svg ${ns} onload='globalThis.ran=1'><script>globalThis.ran=1</script><a href='javascript:globalThis.ran=1'>${path}</a><foreignObject><body onload='globalThis.ran=1'/></foreignObject><image href='http://example.invalid/x.png' onerror='globalThis.ran=1'/></svg>`, 1, "W_PICTURE"],
  ["SV-033", "a style that tries to break out", `<svg ${ns}><style>&lt;/style&gt;&lt;img src onerror=globalThis.ran=1&gt;</style>${path}</svg>`, 1, null],
  ["SV-034", "outside references", `<svg ${ns}><use href='http://example.invalid/a.svg#b'/><use href='//example.invalid#c'/>${path}</svg>`, 1, "W_NO_TARGET"],
  ["SV-036", "a transform that is none", `<svg ${ns}><path transform='matrix(1 0 NaN)' d='M0 0L1 1'/></svg>`, 1, "W_BAD_TRANSFORM"],
  ["SV-036b", "an empty transform", `<svg ${ns}><path transform='' d='M0 0L1 1'/></svg>`, 1, null],
  ["SV-040", "a viewBox of no size", `<svg ${ns} viewBox='0 0 0 0'>${path}</svg>`, 1, "W_BAD_VIEWBOX"],
  ["SV-042", "sizes in percent and auto", `<svg ${ns} width='50%' height='auto'>${path}</svg>`, 1, "W_UNIT"],
  ["SV-044", "a byte order mark and an XML declaration", `\uFEFF<?xml version='1.0' encoding='UTF-8'?><svg ${ns}>${path}</svg>`, 1, null],
  ["SV-045", "no namespace at all", `<svg>${path}</svg>`, 1, null],
  ["SV-049", "shapes without a size", `<svg ${ns}><rect width='-1' height='2'/><circle r='NaN'/><ellipse rx='0' ry='1'/></svg>`, 0, "W_BAD_LENGTH"],
  ["SV-050", "a polygon with a lone last number", `<svg ${ns}><polygon points='0,0 1,0 1'/></svg>`, 1, "W_ODD_POINTS"],
  ["SV-053", "what is not displayed", `<svg ${ns}><g display='none'>${path}</g><path style='display: none' d='M0 0L1 1'/>${path}</svg>`, 1, null],
  ["SV-026", "entities of plain text, as Illustrator writes its namespaces", `<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "x.dtd" [\n<!ENTITY ns_svg "http://www.w3.org/2000/svg">\n<!ENTITY ns_ai 'http://ns.adobe.com/'>\n]><svg xmlns="&ns_svg;" xmlns:i="&ns_ai;">${path}</svg>`, 1, null],
  ["SV-056", "layers that a style sheet hides", `<svg ${ns}><style>.st0{fill:red}.st1, #off{display:none}\n@import url(http://example.invalid/a.css);</style><g class='st0'>${path}</g><g class='a st1'>${path}</g><g id='off'>${path}</g><path class='st1' style='display:inline' d='M0 0L1 1'/></svg>`, 2, null],
  ["SV-057", "text, which has no outlines here", `<svg ${ns}><text>Hi</text>${path}</svg>`, 1, "W_TEXT"],
  ["SV-068", "a picture, of which no outlines are made here", `<svg ${ns}><image href='data:image/png;base64,AA' width='9' height='9'/><g visibility='hidden'><image width='9' height='9'/></g>${path}</svg>`, 1, "W_PICTURE"],
  ["SV-058", "a transform by CSS that needs a box", `<svg ${ns}><path style='transform:translate(50%, 0)' d='M0 0L1 1'/></svg>`, 1, "W_STYLE_TRANSFORM"],
  ["SV-058b", "a transform by CSS in space", `<svg ${ns}><path style='rotate: 1 1 0 45deg' d='M0 0L1 1'/></svg>`, 1, "W_STYLE_TRANSFORM"],
  ["SV-058c", "a turn about the middle of a box", `<svg ${ns}><path style='transform: rotate(45deg); transform-origin: center' d='M0 0L1 1'/></svg>`, 1, "W_STYLE_TRANSFORM"],
  ["SV-066", "a clip that cuts something off", `<svg ${ns} viewBox='0 0 24 24'><clipPath id='c'><circle r='5'/></clipPath><g clip-path='url(#c)'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-066b", "a mask by a style", `<svg ${ns} viewBox='0 0 24 24'><mask id='m'><rect width='24' height='24'/></mask><g style='mask: url("#m")'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-066c", "a clip to a part of the frame", `<svg ${ns} viewBox='0 0 24 24'><clipPath id='c'><rect width='24' height='23'/></clipPath><g clip-path='url(#c)'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-066d", "a clip to a frame that is elsewhere", `<svg ${ns} viewBox='0 0 24 24'><clipPath id='c'><path d='M0 0H24V24H0Z'/></clipPath><g transform='translate(1 0)' clip-path='url(#c)'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-066e", "a triangle as a clip", `<svg ${ns} viewBox='0 0 24 24'><clipPath id='c'><path d='M0 0H24V24H12Z'/></clipPath><g clip-path='url(#c)'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-066f", "a clip by a shape of CSS", `<svg ${ns} viewBox='0 0 24 24'><g style='clip-path: circle(5px)'>${path}</g></svg>`, 1, "W_CLIP"],
  ["SV-067", "clips and masks to the frame, as drawing programs write them", `<svg ${ns} width='48' height='48' viewBox='0 0 24 24'><g clip-path='url(#c)'>${path}</g><mask id='m' style='mask-type:luminance' maskUnits='userSpaceOnUse' x='0' y='0' width='24' height='24'><path d='M24 0H0V24H24V0Z' fill='white'/></mask><g mask='url(#m)'>${path}</g><defs><clipPath id='c'><rect width='24' height='24' fill='white'/></clipPath></defs></svg>`, 2, null],
  ["SV-067b", "a frame's clip inside a moved group", `<svg ${ns} viewBox='5 5 24 24'><g transform='translate(5 5)' clip-path='url(#c)'>${path}</g><clipPath id='c'><rect width='24' height='24'/></clipPath></svg>`, 1, null],
  ["SV-067c", "a clip that is not there, which browsers do not apply either", `<svg ${ns} viewBox='0 0 24 24'><g clip-path='url(#c)'>${path}</g></svg>`, 1, null],
  ["SV-067d", "no clip", `<svg ${ns}><g clip-path='none' style='mask:none'>${path}</g></svg>`, 1, null],
  ["SV-059", "an icon as large as its text", `<svg ${ns} width='1em' height='1em' viewBox='0 0 24 24'>${path}</svg>`, 1, null],
  ["SV-060", "a path alone", path, 1, null],
  ["SV-061", "JSX", "<svg viewBox='0 0 24 24' {...props} strokeWidth={2}><path strokeLinecap={round} d={'M0 0L1 1'} /><path d=\"M1 1L2 2\" /></svg>", 2, null],
  ["SV-062", "components of React Native", "<Svg viewBox='0 0 24 24'><G><Path d='M0 0L1 1' /><Circle cx='1' cy='1' r='1' /></G></Svg>", 2, null],
  ["SV-063", "a button of a page", `<button onclick='globalThis.ran=1'><img src='http://example.invalid/x.png' onerror='globalThis.ran=1'><svg>${path}</svg><br>Save</button>`, 1, null],
  ["SV-055", "shapes in defs, clips, masks, markers, patterns and symbols", `<svg ${ns}><defs>${path}</defs><clipPath>${path}</clipPath><mask>${path}</mask><marker>${path}</marker><pattern>${path}</pattern><symbol>${path}</symbol>${path}</svg>`, 1, null],
];

for (const [id, what, svg, shapes, warning] of accepted) {
  test(`${id} ${what}: ${shapes} shapes${warning === null ? "" : `, ${warning}`}`, async () => {
    const outcome = await read(svg);
    assert.equal(outcome.code, undefined);
    assert.equal(outcome.shapes.length, shapes);
    if (warning === null) assert.deepEqual(outcome.warnings, []);
    else assert.ok(outcome.warnings.includes(warning), outcome.warnings.join());
    assert.equal(outcome.ran, 0, "nothing in the file was run");
    assert.ok(outcome.shapes.every((shape) => shape.transform.every(Number.isFinite)));
  });
}

test("SV-049 every shape without a size is warned of", async () => {
  const outcome = await read(`<svg ${ns}><rect width='-1' height='2'/><circle r='NaN'/><ellipse rx='0' ry='1'/></svg>`);
  assert.ok(outcome.warnings.length >= 3);
});

test("SV-050 the polygon keeps its whole pairs", async () => {
  const outcome = await read(`<svg ${ns}><polygon points='0,0 1,0 1'/></svg>`);
  assert.equal(outcome.shapes[0]?.d, "M0 0L1 0Z");
});

test("SV-061 what JSX has in braces is read as what it holds", async () => {
  const outcome = await read("<svg viewBox={'0 0 24 24'}><path d={\"M0 0L1 1\"} onClick={() => { globalThis.ran = 1 }} /></svg>");
  assert.deepEqual(outcome.shapes.map(({ d }) => d), ["M0 0L1 1"]);
  assert.equal(outcome.ran, 0);
});

/** By the definition of percentages: of the width, of the height, and of the diagonal over √2. */
const relative: readonly (readonly [id: string, svg: string, d: string])[] = [
  ["of the viewBox", `<svg ${ns} width='100%' viewBox='0 0 200 100'><rect x='10%' y='10%' width='50%' height='50%'/></svg>`, "M20 10H120V60H20Z"],
  ["of an inner picture without a viewBox", `<svg ${ns} viewBox='0 0 9 9'><svg width='80' height='60'><line x1='0' y1='0' x2='50%' y2='100%'/></svg></svg>`, "M0 0L40 60"],
  ["of a radius", `<svg ${ns} viewBox='0 0 70 10'><circle r='10%'/></svg>`, "M5 0A5 5 0 0 1 0 5A5 5 0 0 1 -5 0A5 5 0 0 1 0 -5A5 5 0 0 1 5 0Z"],
  ["in text sizes", `<svg ${ns}><rect x='1em' y='1ex' width='2rem' height='1in'/></svg>`, "M16 8H48V104H16Z"],
];

for (const [what, svg, d] of relative) {
  test(`SV-064 lengths ${what}`, async () => {
    const outcome = await read(svg);
    assert.deepEqual([outcome.shapes.map((shape) => shape.d), outcome.warnings], [[d], []]);
  });
}

const styled: readonly (readonly [attributes: string, what: string])[] = [
  ["style='transform: rotate(45deg)'", "a turn"],
  ["style='transform: matrix(1, 2, 3, 4, 5, 6) ! important; fill: red'", "a matrix among other properties"],
  ["style='fill: none; transform: translate(12px, -3px) rotate(0.25turn) scale(2, 0.5) skewX(10deg)' transform='scale(9)'", "a list, which the attribute yields to"],
  ["style='transform: translateX(7px) scaleY(-1) skew(0.1rad, 20grad)'", "functions that attributes do not have"],
  ["style='translate: 10px 20px; rotate: -30deg; scale: 2 3; transform: skewY(5deg)'", "properties of their own"],
  ["style='rotate: 30deg' transform='translate(4 5)'", "a property beside the attribute"],
  ["style='transform: rotate(30deg); transform-origin: 12px 7.5px'", "a turn about a place"],
  ["transform='rotate(30)' transform-origin='12 7.5'", "an attribute's turn about a place"],
  ["style='transform: translate(3px, 4px); transform-origin: center'", "a step, which happens about any place"],
  ["style='transform: none' transform='scale(9)'", "none, which the attribute yields to"],
  ["style='translate: none; stroke: url(a;b:c)'", "none of its own"],
];

for (const [attributes, what] of styled) {
  test(`SV-065 a transform by CSS is where the browser draws it: ${what}`, async () => {
    const svg = `<svg ${ns}><g ${attributes}>${path}</g></svg>`;
    const outcome = await read(svg);
    assert.deepEqual(outcome.warnings, []);
    const drawn = await page?.evaluate((text) => {
      document.body.innerHTML = text;
      const { a, b, c, d, e, f } = document.querySelector("path")?.getCTM() ?? new DOMMatrix([9, 9, 9, 9, 9, 9]);
      document.body.replaceChildren();
      return [a, b, c, d, e, f];
    }, svg);
    const own = outcome.shapes[0]?.transform ?? [];
    // The browser's own matrices have single precision.
    drawn?.forEach((value, i) => assert.ok(Math.abs(value - (own[i] ?? NaN)) <= 1e-5 * Math.max(1, Math.abs(value)), `[${own.join()}] is not [${drawn.join()}]`));
    assert.equal(own.length, drawn?.length);
  });
}

test("SV-027 SV-032 SV-034 nothing was ever fetched", () => {
  assert.deepEqual(requests.filter((url) => url !== "about:blank"), []);
});

const names: readonly (readonly [id: string, name: string])[] = [
  ["SX-001", '"><script>alert(1)</script>'],
  ["SX-002", "]]> --> & <!--"],
  ["SX-003", "a\u0000b\uFFFE\uD800"],
];

for (const [id, name] of names) {
  test(`${id} a title of ${JSON.stringify(name)} leaves the file well formed and comes back`, async () => {
    assert.ok(page !== undefined);
    const back = await page.evaluate((title) => {
      const { reader } = globalThis as unknown as { reader: { writeSvg(o: { title: string; d: string; box: null }): string } };
      const text = reader.writeSvg({ title, d: "M0 0L1 1", box: null });
      const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
      return { text, title: parsed.querySelector("title")?.textContent, broken: parsed.querySelector("parsererror") !== null, scripts: parsed.querySelectorAll("script").length };
    }, name);
    assert.equal(back.broken, false);
    assert.equal(back.scripts, 0);
    assert.doesNotMatch(back.text, /<script/);
    assert.equal(back.title, id === "SX-003" ? "a\uFFFDb\uFFFD\uFFFD" : name);
  });
}

test("SX-013 an empty drawing is a well-formed file without a path", async () => {
  assert.ok(page !== undefined);
  const text = await page.evaluate(() => (globalThis as unknown as { reader: { writeSvg(o: { title: string; d: string; box: null }): string } }).reader.writeSvg({ title: "", d: "", box: null }));
  assert.doesNotMatch(text, /<path/);
  assert.match(text, /<svg [^>]*viewBox="[-\d. ]+"[^>]*>/);
});
