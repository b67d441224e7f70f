import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";
import { cells, cellsOf, opened, saved } from "./pictures.ts";

/**
 * The colours and lines of drawings: what comes out of the page against what the browser makes of the file that went
 * in.
 */

const { open } = useBrowser();

const framed = (inner: string): string => `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 48 48" width="48" height="48">${inner}</svg>`;
const ring = "M24 4a20 20 0 1 0 0 40a20 20 0 1 0 0-40ZM24 14a10 10 0 1 0 0 20a10 10 0 1 0 0-20Z";

const drawings: readonly (readonly [what: string, inner: string])[] = [
  ["names, digits and functions", '<rect width="24" height="48" fill="rebeccapurple"/><rect x="24" width="24" height="24" fill="#0a8"/><rect x="24" y="24" width="24" height="24" fill="hsl(20 90% 50%)"/>'],
  ["colours of other spaces", '<rect width="24" height="24" fill="oklch(60% 0.2 30)"/><rect x="24" width="24" height="24" fill="color(display-p3 0 0.6 0.3)"/><rect y="24" width="24" height="24" fill="lab(50% 40 -60 / 50%)"/><rect x="24" y="24" width="24" height="24" fill="color-mix(in srgb, red 30%, blue)"/>'],
  ["attributes, styles and rules", '<style>.a{fill:#123456}.b{fill:rgb(200 40 10)}</style><g fill="gold"><rect width="16" height="48"/><rect class="a" x="16" width="16" height="48"/><rect class="a" style="fill:teal" x="32" width="16" height="24"/><rect class="b" x="32" y="24" width="16" height="24" fill="red"/></g>'],
  ["the colour around", '<g color="#c2185b"><circle cx="24" cy="24" r="20" fill="currentColor"/><rect x="18" y="18" width="12" height="12" style="color:navy;fill:currentColor"/></g>'],
  ["white over a colour, black over white", `<circle cx="24" cy="24" r="22" fill="#0b57d0"/><path d="${ring}" fill="#fff" fill-rule="evenodd"/><circle cx="24" cy="24" r="5"/>`],
  ["one colour by two names, over itself and running both ways", '<path fill="#f00" d="M4 4h24v24h-24z"/><path fill="red" d="M20 20v24h24v-24z"/><path fill="#00f" d="M30 4h6v6h-6z"/>'],
  ["the same colour below and above another", '<rect x="2" y="2" width="30" height="30" fill="#2e7d32"/><rect x="10" y="10" width="30" height="30" fill="#fdd835"/><rect x="18" y="18" width="28" height="28" fill="#2e7d32"/>'],
  ["what shows through: its own opacity, a group's, and a colour's", '<rect width="48" height="30" fill="#1565c0"/><rect x="4" y="4" width="12" height="40" fill="#e53935" fill-opacity=".5"/><g opacity="50%"><rect x="18" y="4" width="12" height="40" fill="#e53935" opacity=".5"/></g><rect x="32" y="4" width="12" height="40" fill="#e5393580"/>'],
  ["what is not to be seen", '<rect width="24" height="48" fill="#00897b"/><rect width="48" height="48" fill="red" opacity="0"/><rect width="48" height="48" fill="red" fill-opacity="0%"/><rect width="48" height="48" fill="#f000"/>'],
  ["an area of one colour alone", `<path d="${ring}" fill="#e10098" fill-rule="evenodd"/>`],
  ["a hole that runs the same way, in one colour of two", `<path d="${ring}" fill="#6a1b9a" fill-rule="evenodd"/><path d="M20 20h8v8h-8zM22 22h4v4h-4z" fill="#ff8f00"/>`],
];

/** As icons are drawn, and what is rarer; each line is wide enough to have a middle. */
const lines: readonly (readonly [what: string, inner: string])[] = [
  ["an icon of lines in one colour", '<g fill="none" stroke="currentColor" color="#00695c" stroke-width="5" stroke-linecap="round" stroke-linejoin="round"><path d="M6 24h14l8 16 8-32 4 16"/><circle cx="24" cy="10" r="6"/></g>'],
  ["ends and corners of all kinds", '<g fill="none" stroke="#c2185b" stroke-width="6"><path d="M8 8h16v12"/><path d="M8 26h16v12" stroke-linecap="square" stroke-linejoin="bevel"/><path d="M36 10v28l4-8" stroke-linecap="round" stroke-linejoin="round"/></g>'],
  ["lines around areas, of other colours and of one that shows through", '<rect x="8" y="8" width="32" height="20" fill="#ffcc00" stroke="#204080" stroke-width="6"/><circle cx="24" cy="34" r="9" fill="#fff" stroke="#b71c1c80" stroke-width="5"/><path d="M4 46h40" stroke="#2e7d32" stroke-width="4" stroke-opacity=".5"/>'],
  ["widths by styles, in other units, and of what is drawn larger", '<style>.w{stroke-width:1mm;stroke:teal}</style><path class="w" d="M4 10h40"/><g transform="scale(4)" stroke="navy"><path d="M1 5h10" stroke-width="1"/><path d="M1 7h10" style="stroke-width:1.5px"/></g><path d="M4 42h40" stroke="red" stroke-width="10%"/>'],
  ["dashes: of attributes and styles, in groups, with an offset, of what is drawn larger, around a circle, and of one length", '<style>.d{stroke:teal;stroke-dasharray:3px,5px;stroke-dashoffset:-2}</style><g fill="none" stroke-width="5"><path class="d" d="M4 6h40"/><g transform="scale(2)" stroke="#204080" stroke-dasharray="4 2.5"><path stroke-width="2.5" d="M2 7h20"/><circle stroke-width="3" cx="8" cy="16" r="4.5"/></g><path d="M30 22v22h14" stroke="#c2185b" stroke-dasharray="7" stroke-linejoin="round"/></g>'],
  ["dashes that are none: negative, all of no length, or broken off by a style", '<g stroke="#2e7d32" stroke-width="6"><path d="M4 8h40" stroke-dasharray="6 -3"/><path d="M4 20h40" stroke-dasharray="0 0"/><g stroke-dasharray="5"><path d="M4 32h40" style="stroke-dasharray:none"/></g></g>'],
  ["a gradient along a line, and lines that are not there", '<defs><linearGradient id="g"><stop stop-color="#0a0"/><stop offset="1" stop-color="#0a0"/></linearGradient></defs><path d="M4 10l40 4" stroke="url(#g)" stroke-width="8"/><path d="M4 30h40" fill="none" stroke="red" stroke-width="0"/><path d="M4 40h40" stroke="#00f" stroke-width="6" stroke-opacity="1"/><path d="M4 24h40" fill="none" stroke="red" stroke-width="6" opacity="0"/>'],
];

/**
 * Opacities have 256 steps in a colour and 1000 in a file, and what shows through is rounded each time it is drawn
 * over.
 */
const rounding = 3;

const apart = (a: readonly number[], b: readonly number[]): number => {
  // What is less opaque counts less: of nothing no colour is seen.
  const seen = ([red = 0, green = 0, blue = 0, opacity = 0]: readonly number[]): number[] => [(red * opacity) / 255, (green * opacity) / 255, (blue * opacity) / 255, opacity];
  const [one, other] = [seen(a), seen(b)];
  return Math.max(...one.map((value, i) => Math.abs(value - (other[i] ?? 0))));
};

type Cells = Awaited<ReturnType<typeof cellsOf>>;

/** Where eight cells around are as the one between them: two programs smooth edges in two ways. */
function isFlat(picture: Cells, at: number): boolean {
  const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => picture[at + dy * cells + dx]));
  return around.every((cell) => cell === undefined || apart(cell, picture[at] ?? []) <= 1);
}

for (const [what, inner] of [...drawings, ...lines]) {
  test(`a drawing keeps its colours and lines in both kinds of file: ${what}`, async (t) => {
    const demo = await open(t);
    await opened(demo, framed(inner));
    const wanted = await cellsOf(demo, "image/svg+xml", Buffer.from(framed(inner)));
    await demo.byId("btn-export").click();
    const flat = wanted.flatMap((_, i) => (isFlat(wanted, i) ? [i] : []));
    assert.ok(flat.length > wanted.length / 2);
    for (const [id, type] of [["export-svg", "image/svg+xml"], ["export-png", "image/png"]] as const) {
      const found = await cellsOf(demo, type, await saved(demo, id));
      const farthest = Math.max(...flat.map((i) => apart(found[i] ?? [], wanted[i] ?? [])));
      assert.ok(farthest <= rounding, `${id}: ${farthest}`);
    }
  });
}

const inksOf = (demo: Demo): Promise<(string | undefined)[]> => demo.page.evaluate(() => window.explineDemo.getState().curve.contours.map(({ ink }) => ink));

test("dashes in parts of the whole outline come in as long as they look there", async (t) => {
  const demo = await open(t);
  const line = 'fill="none" stroke="teal" stroke-width="4"';
  await opened(demo, framed([
    // 50 units long, which count for 10: one of them is 5. The scale of a transform comes on top.
    `<path d="M4 4H24V34" ${line} stroke-dasharray="2 1" stroke-dashoffset="1" pathLength="10"/>`,
    `<g transform="scale(2)"><circle cx="10" cy="10" r="5" ${line} stroke-dasharray=".5 .25" pathLength="1"/></g>`,
    // What is no length is as if it were not there.
    `<path d="M4 4H24V34" ${line} stroke-dasharray="2 1" pathLength="-3"/>`,
  ].join("")));
  const lines = await demo.page.evaluate(() => window.explineDemo.getState().curve.contours.map((contour) => contour.line));
  const rounded = lines.map((each) => [each?.dashes?.map((length) => Number(length.toFixed(6))), each?.dashOffset]);
  const round = 20 * Math.PI;
  assert.deepEqual(rounded, [[[10, 5], 5], [[0.5 * round, 0.25 * round].map((length) => Number(length.toFixed(6))), undefined], [[2, 1], undefined]]);
});

test("dashes whose lengths nobody could tell are left out, and that is said", async (t) => {
  const demo = await open(t);
  await opened(demo, framed('<path d="M4 4 44 20V44" fill="none" stroke="teal" stroke-width="4" stroke-dasharray="6 3" pathLength="0" stroke-linejoin="round"/>'));
  assert.deepEqual(await demo.page.evaluate(() => window.explineDemo.getState().curve.contours.map(({ line }) => line)), [{ width: 4, color: "#008080", join: "round" }]);
  assert.match(await demo.page.locator("[role=status], .toast").allInnerTexts().then(String), /a dashed line became solid/u);
});

test("a gradient comes in as the mean of what it draws, and that is said", async (t) => {
  const stops = '<stop offset="0.25" stop-color="#ff8800"/><stop offset="75%" style="stop-color:#0044cc"/><stop class="end" offset="1"/>';
  const text = framed(`<style>.end{stop-color:#fff;stop-opacity:.5}</style><defs><linearGradient id="of">${stops}</linearGradient><linearGradient id="By" xlink:href="#of"/></defs><rect width="48" height="48" style="fill:url(#By)"/>`);
  const demo = await open(t);
  await opened(demo, text);
  const drawn = await cellsOf(demo, "image/svg+xml", Buffer.from(text));
  const mean = (of: (cell: readonly [number, number, number, number]) => number): number => drawn.reduce((sum, cell) => sum + of(cell), 0) / drawn.length;
  const opacity = mean((cell) => cell[3]);
  const wanted = [0, 1, 2].map((channel) => mean((cell) => ((cell[channel] ?? 0) * cell[3]) / opacity));
  const [ink = ""] = await inksOf(demo);
  const channels = [1, 3, 5, 7].map((at) => Number.parseInt(ink.slice(at, at + 2), 16));
  // The browser mixes its stops by steps of their own.
  for (const [i, value] of [...wanted, opacity].entries()) assert.ok(Math.abs((channels[i] ?? NaN) - value) <= 3, `${ink}: ${wanted.join()}, ${opacity}`);
  assert.match(await demo.page.locator("[role=status], .toast").allInnerTexts().then(String), /a gradient became its average colour/u);
});

test("what is only stroked stays a line beside areas, in both kinds of file and where it is closed", async (t) => {
  const demo = await open(t);
  await opened(demo, framed('<rect x="4" y="4" width="20" height="20" fill="#00897b"/><circle cx="24" cy="24" r="22" fill="none" stroke="#333"/><path d="M30 30L40 44" fill="none" stroke="black"/>'));
  assert.deepEqual(await inksOf(demo), ["#00897b", "none", "none"]);
  await demo.byId("btn-export").click();
  for (const [id, type] of [["export-svg", "image/svg+xml"], ["export-png", "image/png"]] as const) {
    const found = await cellsOf(demo, type, await saved(demo, id));
    const at = (x: number, y: number): number[] => [...(found[Math.floor(2.5 * y) * cells + Math.floor(2.5 * x)] ?? [])];
    assert.deepEqual(at(14, 14), [0, 0x89, 0x7b, 255], id);
    assert.deepEqual(at(36, 20), [0, 0, 0, 0], `${id}: in the circle`);
    const line = Math.max(...[-1, 0, 1].map((dx) => at(46 + 0.4 * dx, 24)[3] ?? 0));
    assert.ok(line > 60, `${id}: the circle itself`);
  }
});

test("ink of no colour of its own has that of the page: black, what a page says, and our own files", async (t) => {
  const demo = await open(t);
  for (const inner of [`<path d="${ring}"/>`, `<path d="${ring}" fill="#000"/><path d="M0 0h4v4z" fill="rgb(0 0 0)"/>`, `<path d="${ring}" fill="currentColor"/>`, `<path d="${ring}" fill="#1b1f24"/>`]) {
    await opened(demo, framed(inner));
    for (const ink of await inksOf(demo)) assert.equal(ink, undefined, inner);
  }
  await opened(demo, framed(`<path d="${ring}" fill="currentColor"/><path d="M0 0h4v4z" fill="red"/><path d="M9 0h4v4z"/>`));
  assert.deepEqual((await inksOf(demo)).slice(-4), [undefined, undefined, "#ff0000", "#000000"], "beside a colour black is one, and what a page says is not known");
});

test("the stage shows areas in their colours, under lines and points that are seen on all of them", async (t) => {
  const demo = await open(t);
  await opened(demo, framed('<rect width="48" height="48" fill="#204080"/><rect x="12" y="12" width="24" height="24" fill="#ffcc00"/>'));
  const colors = await demo.page.evaluate(() => {
    const canvas = document.querySelector("canvas");
    const box = canvas?.getBoundingClientRect();
    const canvasColor = getComputedStyle(document.documentElement).getPropertyValue("--canvas").trim();
    const at = (x: number, y: number): number[] => {
      const place = window.explineDemo.toScreen(x, y);
      return [...(canvas?.getContext("2d")?.getImageData(Math.round((place.x - (box?.left ?? 0)) * devicePixelRatio), Math.round((place.y - (box?.top ?? 0)) * devicePixelRatio), 1, 1).data ?? [])].slice(0, 3);
    };
    return { canvasColor, below: at(6, 20), above: at(20, 20) };
  });
  const paper = (/^rgb\((.*)\)$/u.exec(colors.canvasColor)?.[1] ?? "").split(",").map(Number);
  const halfWay = (color: readonly number[]): number[] => color.map((value, i) => (value + (paper[i] ?? NaN)) / 2);
  for (const [found, color] of [[colors.below, [0x20, 0x40, 0x80]], [colors.above, [0xff, 0xcc, 0]]] as const) {
    halfWay(color).forEach((value, i) => assert.ok(Math.abs((found[i] ?? NaN) - value) <= 2, `${found.join()} for ${color.join()} on ${colors.canvasColor}`));
  }
});

test("a drawing that is made simpler in Fit keeps its colours, in what Fit saves and back in Curve", async (t) => {
  const text = framed('<rect x="3" y="3" width="42" height="42" fill="#204080"/><circle cx="24" cy="24" r="18" fill="#ffcc00"/><path d="M14 24a10 10 0 0 0 20 0z" fill="#b71c1c80"/><circle cx="24" cy="24" r="21" fill="none" stroke="#000"/>');
  const inks = ["#204080", "#ffcc00", "#b71c1c80", "none"];
  const demo = await open(t);
  await opened(demo, text);
  await demo.byId("curve-simplify").click();
  await demo.idle();
  assert.deepEqual(await demo.page.evaluate(() => window.explineDemo.getState().fit.paints?.map(({ ink }) => ink)), inks);
  const wanted = await cellsOf(demo, "image/svg+xml", Buffer.from(text));
  const flat = wanted.flatMap((_, i) => (isFlat(wanted, i) && isFlat(wanted, i + 2) && isFlat(wanted, i - 2) && isFlat(wanted, i + 2 * cells) && isFlat(wanted, i - 2 * cells) ? [i] : []));
  for (const mode of ["fit", "curve"] as const) {
    if (mode === "curve") {
      await demo.byId("fit-edit").click();
      await demo.idle();
      assert.deepEqual(await inksOf(demo), inks);
      const lines = await demo.page.evaluate(() => window.explineDemo.getState().curve.contours.map(({ line }) => line ?? null));
      assert.deepEqual(lines, [null, null, null, { width: 1, color: "#000000" }]);
    }
    await demo.byId("btn-export").click();
    const found = await cellsOf(demo, "image/svg+xml", await saved(demo, "export-svg"));
    const away = flat.filter((i) => apart(found[i] ?? [], wanted[i] ?? []) > rounding).length;
    // Lines are as thin as they are everywhere in the page's files, and a fit may be a quarter of a percent away.
    assert.ok(flat.length > 0.4 * cells * cells && away < 0.005 * flat.length, `${mode}: ${away} of ${flat.length}`);
    await demo.page.keyboard.press("Escape");
  }
});
