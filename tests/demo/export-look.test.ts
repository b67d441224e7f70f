import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";
import { cellsOf, opened, saved } from "./pictures.ts";

/** What a drawing looks like in the files that are saved of it, as the browser itself draws them. */

const { open } = useBrowser();

/** An icon as icons are: 24 units, an area with a hole and a corner. */
const icon = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" width="24" height="24"><path fill="#1b1f24" fill-rule="evenodd" d="M12 0a12 12 0 1 0 0 24a12 12 0 1 0 0-24ZM7 7h10v10l-5-4l-5 4Z"/></svg>';

/** A real one: the file that simple-icons (CC0-1.0) has of it. */
const logo = (name: string): Promise<string> => readFile(createRequire(import.meta.url).resolve(`simple-icons/icons/${name}.svg`), "utf8");

/** How much of each of 120 × 120 cells of a picture is drawn on, from 0 to 1. */
async function shadesOf(demo: Demo, type: string, bytes: Buffer): Promise<number[]> {
  return (await cellsOf(demo, type, bytes)).map(([, , , opacity]) => opacity / 255);
}

const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;

test("an icon comes out of the page as the areas that it came in as, in both kinds of file", async (t) => {
  const demo = await open(t);
  await opened(demo, icon);
  const wanted = await shadesOf(demo, "image/svg+xml", Buffer.from(icon));
  await demo.byId("btn-export").click();
  for (const [id, type] of [["export-svg", "image/svg+xml"], ["export-png", "image/png"]] as const) {
    const shades = await shadesOf(demo, type, await saved(demo, id));
    const away = mean(shades.map((shade, i) => Math.abs(shade - (wanted[i] ?? 0))));
    // Two ways of smoothing edges; a line of two units around it would differ in a fifth of all.
    assert.ok(away < 0.02, `${id}: ${away}`);
  }
  assert.match(await demo.page.locator(".export-picture path").first().getAttribute("class") ?? "", /export-ink/, "the preview shows what the file does");
});

/**
 * Of 40 × 40 places all over an icon of 24 units, those with no edge near them: what the stage has there, and whether
 * it should be ink.
 */
async function onStage(demo: Demo, shades: readonly number[]): Promise<{ ink: boolean; color: string }[]> {
  const places = Array.from({ length: 40 * 40 }, (_, i) => ({ column: 3 * (i % 40) + 1, row: 3 * Math.floor(i / 40) + 1 })).filter(({ column, row }) => {
    const near = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => shades[(row + dy) * 120 + column + dx] ?? 0));
    return near.every((shade) => shade > 0.99) || near.every((shade) => shade < 0.01);
  });
  const colors = await demo.page.evaluate((all) => {
    const canvas = document.querySelector("canvas");
    const context = canvas?.getContext("2d");
    const box = canvas?.getBoundingClientRect();
    return all.map(({ x, y }) => {
      const at = window.explineDemo.toScreen(x, y);
      return String(context?.getImageData(Math.round(at.x - (box?.left ?? 0)), Math.round(at.y - (box?.top ?? 0)), 1, 1).data);
    });
  }, places.map(({ column, row }) => ({ x: (column + 0.5) / 5, y: (row + 0.5) / 5 })));
  return places.map(({ column, row }, i) => ({ ink: (shades[row * 120 + column] ?? 0) > 0.5, color: colors[i] ?? "" }));
}

test("real logos are filled on the stage and in files as their own files are: some overlap themselves, some have holes, some are not closed", async (t) => {
  for (const name of ["figma", "graphql", "first", "spotify", "whatsapp", "docker"]) {
    const demo = await open(t);
    const text = await logo(name);
    await opened(demo, text);
    const wanted = await shadesOf(demo, "image/svg+xml", Buffer.from(text));
    const seen = await onStage(demo, wanted);
    const most = (ink: boolean): string => {
      const colors = seen.filter((each) => each.ink === ink).map(({ color }) => color);
      return colors.sort((a, b) => colors.filter((c) => c === b).length - colors.filter((c) => c === a).length)[0] ?? "";
    };
    const [inkColor, paperColor] = [most(true), most(false)];
    assert.notEqual(inkColor, paperColor);
    // Marks of points lie over both.
    const wrong = seen.filter(({ ink, color }) => color === (ink ? paperColor : inkColor));
    assert.ok(wrong.length <= 0.001 * seen.length, `${name}: ${wrong.length} of ${seen.length} places`);
    await demo.byId("btn-export").click();
    const preview = await demo.page.locator(".export-picture path").first().evaluate((path) => getComputedStyle(path).fillRule);
    assert.equal(preview, ["figma", "graphql", "first"].includes(name) ? "nonzero" : "evenodd", "the preview shows what the file does");
    for (const [id, type] of [["export-svg", "image/svg+xml"], ["export-png", "image/png"]] as const) {
      const shades = await shadesOf(demo, type, await saved(demo, id));
      const away = mean(shades.map((shade, i) => Math.abs(shade - (wanted[i] ?? 0))));
      // Two ways of smoothing edges.
      assert.ok(away < (id === "export-svg" ? 0.005 : 0.02), `${name}, ${id}: ${away}`);
    }
  }
});

test("an icon that is edited comes back on its artboard, and an artboard that the drawing has left grows", async (t) => {
  const demo = await open(t);
  await opened(demo, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="M6 8H18V16H6Z"/></svg>');
  const viewBox = async (): Promise<string> => /viewBox="([^"]*)"/u.exec((await saved(demo, "export-svg")).toString("utf8"))?.[1] ?? "";
  await demo.click("pt-0-0");
  await demo.press("ArrowLeft", "ArrowUp");
  await demo.byId("btn-export").click();
  assert.equal(await viewBox(), "0 0 24 24");
  assert.equal(await demo.textOf("export-artboard"), "24 × 24");
  await demo.until(() => demo.textOf("export-png"), (text) => text === "PNG 512 × 512", "the picture is as large as the artboard at 2×");
  await demo.press("Escape");
  await demo.focusStage();
  await demo.press("Control+a", "Shift+ArrowRight", "Shift+ArrowRight");
  await demo.byId("btn-export").click();
  assert.equal(await viewBox(), "0 0 38 24");
  assert.equal(await demo.textOf("export-artboard"), "24 × 24, grown to fit");
});

test("a logo that is made simpler is saved on its artboard and filled as before, from Fit and from Curve", async (t) => {
  const demo = await open(t);
  const text = await logo("figma");
  await opened(demo, text);
  const wanted = await shadesOf(demo, "image/svg+xml", Buffer.from(text));
  await demo.byId("curve-simplify").click();
  await demo.idle();
  for (const mode of ["fit", "curve"]) {
    if (mode === "curve") await demo.byId("fit-edit").click();
    await demo.idle();
    assert.equal((await demo.state()).mode, mode);
    await demo.byId("btn-export").click();
    const svg = await saved(demo, "export-svg");
    const viewBox = (/viewBox="([^"]*)"/u.exec(svg.toString("utf8"))?.[1] ?? "").split(" ").map(Number);
    // A four-hundredth of its size may the simpler one be away, and reach so far out of the artboard.
    assert.ok(viewBox.length === 4 && [0, 0, 24, 24].every((wanted, i) => Math.abs((viewBox[i] ?? NaN) - wanted) < 0.3), viewBox.join(" "));
    const shades = await shadesOf(demo, "image/svg+xml", svg);
    const away = mean(shades.map((shade, i) => Math.abs(shade - (wanted[i] ?? 0))));
    // Even-odd would leave out 7 in 100 of the picture.
    assert.ok(away < 0.04, `${mode}: ${away}`);
    await demo.press("Escape");
  }
});

test("the frame that an icon has around it is not part of it, and what is only stroked goes out as lines", async (t) => {
  const demo = await open(t);
  await opened(demo, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path fill="none" d="M0 0h24v24H0z"/><path d="M4 4h8v8H4z"/></svg>');
  assert.equal((await demo.state()).curve.contours.length, 1);
  await demo.byId("btn-clear").click();
  await opened(demo, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="currentColor"><circle cx="12" cy="12" r="10"/></svg>');
  assert.equal((await demo.state()).curve.contours.length, 1);
  await demo.byId("btn-export").click();
  assert.match((await saved(demo, "export-svg")).toString("utf8"), /fill="none" stroke=/u);
});

test("of an icon as lines, lines are no thicker and a picture no smaller than of a drawing that is ten times as large", async (t) => {
  const demo = await open(t);
  await opened(demo, icon);
  await demo.byId("btn-export").click();
  await demo.byId("export-look").selectOption("lines");
  const svg = (await saved(demo, "export-svg")).toString("utf8");
  const [, stroke] = /stroke-width="([^"]+)"/u.exec(svg) ?? [];
  // 2 units of 256.
  assert.ok(Math.abs(Number(stroke) - (2 * 24) / 256) < 1e-3, svg);
  const [x = 0, y = 0, width = 0, height = 0] = (/viewBox="([^"]+)"/u.exec(svg)?.[1] ?? "").split(" ").map(Number);
  assert.ok(x < 0 && y < 0 && x + width > 24 && y + height > 24 && width <= 24.6, "room for the line and no more");
  await demo.byId("export-png-scale").selectOption("1");
  const png = await saved(demo, "export-png");
  // The artboard, and the line where it reaches out of it on both sides.
  assert.equal(png.readUInt32BE(16), 256 + 2 * 2);
  // A fifth of the area would be covered by lines of two units.
  assert.ok(mean((await shadesOf(demo, "image/png", png)).map((shade) => (shade > 0.5 ? 1 : 0))) < 0.08);
});

test("what the samples teach goes out as lines, and as areas when that is chosen", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.byId("btn-export").click();
  assert.match((await saved(demo, "export-svg")).toString("utf8"), /fill="none" stroke="[^"]+" stroke-width="2"/u);
  await demo.byId("export-look").selectOption("areas");
  assert.match((await saved(demo, "export-svg")).toString("utf8"), /<path [^>]*fill="#1b1f24" fill-rule="evenodd"\/>/u);
});

test("a picture without paper is in dark ink in the dark theme, too, as its SVG is; on paper it is as the stage", async (t) => {
  const demo = await open(t, "#/curve?sample=heart", { colorScheme: "dark" });
  await demo.byId("btn-export").click();
  /** How bright its line is, from 0 to 255: the cells that are covered most. */
  const lineOf = async (): Promise<number> => {
    const inked = (await cellsOf(demo, "image/png", await saved(demo, "export-png"))).filter(([, , , opacity]) => opacity > 150);
    return inked.length === 0 ? NaN : mean(inked.map(([red, green, blue]) => (red + green + blue) / 3).sort((a, b) => b - a).slice(0, 40));
  };
  await demo.byId("export-png-scale").selectOption("1");
  const alone = await lineOf();
  assert.ok(alone < 60, `as bright as ${alone}`);
  await demo.byId("export-png-paper").selectOption("paper");
  const onPaper = await lineOf();
  assert.ok(onPaper > 120, `as bright as ${onPaper}`);
});

test("a file of a trace is as large as the picture, with everything in its place, and stays so through Curve and Fit", async (t) => {
  const demo = await open(t, "#/trace?sample=trace-logo");
  const sheet = async (): Promise<string> => {
    await demo.byId("btn-export").click();
    const text = (await saved(demo, "export-svg")).toString("utf8");
    await demo.press("Escape");
    return /<svg[^>]*>/u.exec(text)?.[0] ?? "";
  };
  const whole = /viewBox="0 0 512 512" width="512" height="512"/u;
  assert.match(await sheet(), whole);
  await demo.byId("trace-edit").click();
  await demo.idle();
  assert.match(await sheet(), whole, "edited in Curve");
  assert.deepEqual((await demo.state()).curve.artboard, { x: 0, y: 0, width: 512, height: 512 }, "its size, and nothing else of the picture");
  await demo.byId("tab-trace").click();
  await demo.byId("trace-smooth-in-fit").click();
  await demo.idle();
  assert.match(await sheet(), whole, "smoothed in Fit");
});

test("the preview shows a line's dashes as the file does, and so does the stage", async (t) => {
  const demo = await open(t);
  await opened(demo, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 20" width="100" height="20"><path d="M10 10h80" stroke="teal" stroke-width="12" stroke-dasharray="20 10" stroke-dashoffset="5"/></svg>');
  /** Well beside the thin line in the middle: whether there is any of its colour. */
  const isDrawn = async (x: number): Promise<boolean> => {
    const at = await demo.toScreen(x, 7);
    return demo.page.evaluate(([left, top]) => {
      const canvas = document.querySelector<HTMLCanvasElement>("canvas.stage-canvas");
      const box = canvas?.getBoundingClientRect();
      const [red = 0, , blue = 0] = canvas?.getContext("2d")?.getImageData(left - (box?.left ?? 0), top - (box?.top ?? 0), 1, 1).data ?? [];
      return blue - red > 30;
    }, [at.x, at.y] as const);
  };
  // From 10: 15 of the first dash, then 10 without, then 20 with.
  assert.deepEqual(await Promise.all([12, 23, 30, 37, 52, 60].map(isDrawn)), [true, true, false, true, true, false]);
  await demo.byId("btn-export").click();
  const { strokeDasharray, strokeDashoffset } = await demo.page.locator(".export-picture path").evaluate((path: SVGPathElement) => path.style);
  assert.deepEqual([strokeDasharray.replace(",", ""), strokeDashoffset.replace("px", "")], ["20 10", "5"]);
});
