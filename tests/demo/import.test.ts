import assert from "node:assert/strict";
import { test } from "node:test";
import { assertSame, boxDiagonal, directedDistance, useBrowser, type Demo, type Pair } from "./page.ts";
import { bothWays, evaluatePath } from "./path-oracle.ts";

const { open } = useBrowser();

async function importText(demo: Demo, text: string): Promise<void> {
  if ((await demo.byId("import-dialog").count()) === 0) await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-apply").click();
}

async function imported(demo: Demo, text: string): Promise<void> {
  await importText(demo, text);
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
}

async function refused(demo: Demo, text: string): Promise<{ id: string; text: string }> {
  await importText(demo, text);
  const error = demo.byId("error");
  await error.waitFor();
  return { id: (await error.getAttribute("data-error")) ?? "", text: (await error.textContent()) ?? "" };
}

const twoContours = "M10 10h80v40a20 20 0 0 1-20 20H40q-30 0-30-30zM120 20c20-20 60-20 80 0s20 60 0 80t-80-20z";

test("a sample as it was opened gives way to an import, one that was worked on does not", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.byId("btn-import").click();
  assert.equal(await demo.byId("import-replace").isChecked(), true);
  await demo.press("Escape");
  await demo.click("pt-0-0");
  await demo.press("ArrowRight");
  await demo.byId("btn-import").click();
  assert.equal(await demo.byId("import-replace").isChecked(), false);
  await demo.byId("import-to").getByRole("radio", { name: "Fit, to simplify" }).check();
  assert.equal(await demo.byId("import-replace").isChecked(), true, "nobody has worked in Fit");
});

test("V15 a path of every kind of command comes in as it is drawn", async (t) => {
  const demo = await open(t);
  await imported(demo, twoContours);
  const { contours } = (await demo.state()).curve;
  assert.equal(contours.length, 2);
  assert.ok(contours.every((contour) => contour.closed));
  const expected = evaluatePath(twoContours);
  for (const [i, subpath] of expected.entries()) {
    const curve = await demo.sample(4000, i);
    const away = bothWays(curve, subpath.points, true);
    t.diagnostic(`contour ${i}: ${away.toExponential(1)} from the standard's own evaluation`);
    assert.ok(away <= 0.3, `contour ${i} is ${away} away`);
  }
  // The straight sides: y = 10 from 10 to 90, x = 90 from 10 to 50.
  const first = await demo.sample(4000, 0);
  const onTop = first.filter(([x, y]) => y < 15 && x > 15 && x < 85);
  assert.ok(onTop.length > 100 && onTop.every(([, y]) => Math.abs(y - 10) <= 0.01));
  const onRight = first.filter(([x, y]) => x > 85 && y > 15 && y < 49);
  assert.ok(onRight.length > 50 && onRight.every(([x]) => Math.abs(x - 90) <= 0.01));
});

test("an import applies nothing of the file to the page: the console stays silent", async (t) => {
  const demo = await open(t);
  const said: string[] = [];
  demo.page.on("console", (message) => said.push(message.text()));
  const styled = '<style>.a{display:none}@import url(a.css);</style><g style="fill:red" onclick="x()"><path class="a" d="M9 9h9v9z"/><path style="x:1px" d="M0 0h9v9z"/></g><script>x()</script><image href="a.png"/>';
  const prefixed = '<s:style xmlns:s="http://www.w3.org/2000/svg">.b{fill:red}</s:style>';
  const files = [
    `<?xml-stylesheet href="a.css"?><svg xmlns="http://www.w3.org/2000/svg">${prefixed}${styled}</svg>`,
    `<div style='color:red'><base href="/x"><style>p{color:red}</style><svg STYLE = "color:red">${styled}</svg></div>`,
    "<svg viewBox='0 0 9 9' style={{ color: 'red' }}><path d='M0 0h9v9z' style={{ fill: 'red' }}/></svg>",
  ];
  for (const [i, file] of files.entries()) {
    await imported(demo, file);
    assert.equal((await demo.state()).curve.contours.length, i + 1);
  }
  assert.deepEqual(said, []);
});

test("V15 an ellipse under nested transforms is still exactly an ellipse", async (t) => {
  const demo = await open(t);
  const [cx, cy, rx, ry] = [30, 10, 25, 12];
  await imported(demo, `<svg xmlns="http://www.w3.org/2000/svg"><g transform="translate(50,20) rotate(30) scale(2)"><ellipse cx="${cx}" cy="${cy}" rx="${rx}" ry="${ry}"/></g></svg>`);
  assert.equal((await demo.state()).curve.contours.length, 1);
  const angle = Math.PI / 6;
  const worst = Math.max(...(await demo.sample(2000)).map(([x, y]) => {
    const [u, v] = [(x - 50) / 2, (y - 20) / 2];
    const [a, b] = [u * Math.cos(angle) + v * Math.sin(angle) - cx, -u * Math.sin(angle) + v * Math.cos(angle) - cy];
    return Math.abs((a / rx) ** 2 + (b / ry) ** 2 - 1);
  }));
  t.diagnostic(`conic residual ${worst.toExponential(1)}`);
  assert.ok(worst <= 1e-6, `residual ${worst}`);
});

test("V15 a path that breaks off names the character and changes nothing", async (t) => {
  const demo = await open(t);
  const before = await demo.state();
  const error = await refused(demo, "M10 10 L foo");
  assert.equal(error.id, "d-broken");
  assert.match(error.text, /character 10: “foo”/);
  assertSame(await demo.state(), before);
  assert.equal(await demo.byId("import-partial").isVisible(), false);
});

test("a path that breaks off after something drawable offers what was read", async (t) => {
  const demo = await open(t);
  const error = await refused(demo, "M0 0L100 0L100 80 L foo");
  assert.equal(error.id, "d-broken");
  await demo.byId("import-partial").click();
  await demo.idle();
  assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[0, 0], [100, 0], [100, 80]]);
});

test("importing is one step of the history", async (t) => {
  const demo = await open(t);
  const before = (await demo.state()).curve;
  await imported(demo, twoContours);
  await demo.press("Control+z");
  assertSame((await demo.state()).curve, before);
});

const shapes: readonly (readonly [name: string, markup: string, d: string])[] = [
  ["rect", '<rect x="10" y="20" width="100" height="60"/>', "M10 20h100v60h-100z"],
  ["rect with round corners", '<rect x="10" y="20" width="100" height="60" rx="20"/>', "M30 20h60a20 20 0 0 1 20 20v20a20 20 0 0 1-20 20h-60a20 20 0 0 1-20-20v-20a20 20 0 0 1 20-20z"],
  ["rect with corners larger than it", '<rect width="100" height="60" rx="90" ry="50"/>', "M50 0a50 30 0 0 1 50 30a50 30 0 0 1-50 30a50 30 0 0 1-50-30a50 30 0 0 1 50-30z"],
  ["circle", '<circle cx="50" cy="40" r="30"/>', "M80 40a30 30 0 0 1-60 0a30 30 0 0 1 60 0z"],
  ["line", '<line x1="1" y1="2" x2="30" y2="40"/>', "M1 2L30 40"],
  ["polyline", '<polyline fill="none" stroke="red" points="0,0 50,10 20 60"/>', "M0 0L50 10L20 60"],
  ["polyline that is filled", '<polyline points="0,0 50,10 20 60"/>', "M0 0L50 10L20 60z"],
  ["polygon", '<polygon points="0,0 50,10 20 60"/>', "M0 0L50 10L20 60z"],
  ["use of a shape in defs", '<defs><path id="p" d="M0 0h10v10z"/></defs><use href="#p" x="5" y="7"/>', "M5 7h10v10z"],
  ["viewBox", '<svg x="10" y="20" width="200" height="100" viewBox="5 5 100 50"><path d="M5 5h100v50z"/></svg>', "M10 20h200v100z"],
  ["viewBox that keeps its proportions", '<svg width="200" height="200" viewBox="0 0 100 50"><path d="M0 0h100v50z"/></svg>', "M0 50h200v100z"],
  ["matrix, skew and scale", '<g transform="matrix(1 0 0 1 5 6)"><path transform="skewX(45),scale(2 1)" d="M0 0h10v10z"/></g>', "M5 6h20l10 10z"],
  ["rotation about a point", '<path transform="rotate(90 10 10)" d="M10 10h20"/>', "M10 10v20"],
];

for (const [name, markup, d] of shapes) {
  test(`an SVG's ${name} is drawn where it stands`, async (t) => {
    const demo = await open(t);
    await imported(demo, `<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "x.dtd"><svg xmlns="http://www.w3.org/2000/svg">${markup}</svg>`);
    const [expected] = evaluatePath(d);
    assert.ok(expected !== undefined);
    assert.equal((await demo.state()).curve.contours.length, 1);
    // Every corner falls on a sample, so that the polygon through the samples cuts none.
    const curve = await demo.sample(expected.closed ? 1440 : 1441);
    const away = bothWays(curve, expected.points, expected.closed);
    // A chord of 1/400 of a quarter circle of radius 50 is 1e-4 from its arc; the curve itself is exact.
    assert.ok(away <= 2e-4 * boxDiagonal(expected.points), `${away} away`);
  });
}

test("icons of a sprite, and what a style sheet moves, sizes and hides, come in as browsers draw them", async (t) => {
  const demo = await open(t);
  await imported(demo, `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50">
    <style>.far { transform: translate(60px, 10px) } .far > rect { width: 20px; height: 10px } .layers .off, [data-off] { display: none } .unseen { visibility: hidden }</style>
    <symbol id="icon" viewBox="0 0 10 10"><path d="M0 0H10V10H0Z"/></symbol>
    <use href="#icon" x="5" y="5" width="50%" height="20" style="fill: red"/>
    <g class="far"><rect/></g><g class="layers"><path class="off" d="M0 0H99"/><path data-off="" d="M0 0V99"/><path class="unseen" d="M0 0L99 99"/></g></svg>`);
  const { contours } = (await demo.state()).curve;
  assert.deepEqual(contours.map(({ points }) => points.map(({ x, y }) => [x, y])), [
    [[20, 5], [40, 5], [40, 25], [20, 25]],
    [[60, 10], [80, 10], [80, 20], [60, 20]],
  ]);
});

for (const [name, text] of [
  ["an attribute", 'd="M3 3h18v18H3z"'], ["CSS", 'clip-path: path("M3 3h18v18H3z");'], ["a program", "const shape = new Path2D('M3 3h18v18H3z');"], ["an element", '<path fill="red" d="M3 3h18v18H3z" />'],
  ["a symbol of a sprite", '<symbol id="box" viewBox="0 0 24 24"><path d="M3 3h18v18H3z"/></symbol>'],
  ["a style's picture in base64", `background: url("data:image/svg+xml;base64,${Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><title>Ω</title><path d="M3 3h18v18H3z"/></svg>').toString("base64")}");`],
  ["a style's picture, percent-encoded", "url(data:image/svg+xml;charset=utf-8,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 24 24'%3E%3Crect x='3' y='3' width='18' height='18'/%3E%3C/svg%3E)"],
] as const) {
  test(`a path is read out of ${name}`, async (t) => {
    const demo = await open(t);
    await imported(demo, text);
    assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[3, 3], [21, 3], [21, 21], [3, 21]]);
  });
}

test("curved shapes that are moved, turned and stretched about boxes of their own come in where the browser draws them", async (t) => {
  // Handles and centres of arcs stick out of these boxes: only the box of the curve itself gives these places.
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300" width="400" height="300">
    <style>path, g { transform-box: fill-box; transform-origin: center } .half { transform: translate(50%, -25%) } .turn { transform: rotate(33deg) scale(1.5, .7) }
      .corner { transform: skewX(20deg) scale(.8); transform-origin: 100% 0 } .all { transform: rotate(-15deg) translateX(10%) }</style>
    <path class="half" d="M100 100C60 20 220 20 180 100C240 160 40 190 100 100Z"/>
    <path class="turn" d="M250 80a40 25 30 1 1 60 20q-10 60-60-20z"/>
    <path class="corner" d="M60 200Q100 120 140 200T220 210"/>
    <g class="all"><path d="M260 180c40-60 90 20 20 40s-60-20-20-40z"/><path class="turn" d="M300 240A50 30 0 0 1 380 250L360 270"/></g></svg>`;
  const demo = await open(t);
  await imported(demo, svg);
  const browser = await demo.page.context().newPage();
  await browser.goto("about:blank");
  const drawn = await browser.evaluate((text): Pair[][] => {
    document.body.innerHTML = text;
    const picture = document.querySelector("svg");
    const back = picture?.getScreenCTM()?.inverse();
    return [...document.querySelectorAll("path")].map((path) => {
      const whole = path.getTotalLength();
      return Array.from({ length: 400 }, (_, i): Pair => {
        const { x, y } = path.getPointAtLength((i / 399) * whole).matrixTransform(path.getScreenCTM() ?? undefined).matrixTransform(back);
        return [x, y];
      });
    });
  }, svg);
  assert.equal((await demo.state()).curve.contours.length, drawn.length);
  for (const [i, places] of drawn.entries()) {
    const closed = (await demo.state()).curve.contours[i]?.closed === true;
    // Chromium walks along paths in single precision, and its lengths are good to a few thousandths.
    // Every corner falls on a sample, whether there are two, three, four or five.
    const far = directedDistance(places, await demo.sample(3840, i), closed);
    assert.ok(far <= 0.02, `path ${i + 1} is ${far} beside`);
  }
});

test("a drawing far larger than the stage comes in whole, and stays in reach", async (t) => {
  const demo = await open(t);
  await imported(demo, "M1e5 1e5H9e6V9e6H1e5z");
  for (const [x, y] of [[1e5, 1e5], [9e6, 9e6]] as const) {
    const at = await demo.toScreen(x, y);
    assert.ok(at.x > 40 && at.x < 976 && at.y > 48 && at.y < 768, `${x}, ${y} is seen at ${at.x}, ${at.y}`);
  }
  const { view } = await demo.state();
  await demo.wheel(await demo.centre("stage"), -300);
  assert.ok(Math.abs(8.9e6 * (await demo.state()).view.zoom - 40) < 0.1, "farther away there is nothing");
  await demo.byId("zoom-fit").click();
  await demo.press("+", "+");
  assert.ok((await demo.state()).view.zoom > 1.5 * view.zoom, "nearer in steps, not by a jump to 5 %");
  assert.match(await demo.byId("zoom-pct").inputValue(), /^0\.\d+ %$/u);
  const kept = await demo.state();
  await demo.page.evaluate((state) => window.explineDemo.setState(state), kept);
  assert.deepEqual((await demo.state()).view, kept.view);
});

test("points as a program has them, in pairs or with their names, become a smooth curve through all of them", async (t) => {
  const demo = await open(t);
  for (const text of ["[[10, 20], [30, -4.5e1], [50, 20]]", "[\n  [10, 20],\n  [30, -45],\n  [50, 20],\n];", '[{"x": 10, "y": 20}, {"x": 30, "y": -45}, {"x": 50, "y": 20}]', "[{ x: 10, y: 20 }, { x: 30, y: -45 }, { x: 50, y: 20 }]"]) {
    await demo.click("btn-clear");
    await imported(demo, text);
    assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[10, 20], [30, -45], [50, 20]], text);
  }
  // What only begins so is refused as a row that is none, with its number.
  assert.equal((await refused(demo, "[[10, 20], [30, 40, 50]]")).id, "points-rows");
});

test("points as rows become a smooth curve through all of them", async (t) => {
  const demo = await open(t);
  await imported(demo, "0,0\n100,20\n180,120\n60;150");
  const points = await demo.points();
  assert.deepEqual(points.map(({ x, y }) => [x, y]), [[0, 0], [100, 20], [180, 120], [60, 150]]);
  assert.ok(points.slice(1, 3).every(({ kind }) => kind !== "cusp"));
  assert.equal((await refused(demo, "0,0\n100,north")).id, "points-rows");
});

test("a table of measurements that is pasted in Fit is fitted, and what was made of its columns and gaps is said", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-sine");
  const rows = Array.from({ length: 40 }, (_, i) => (i === 7 ? `${i};NaN;1` : `${i};${(10 * i).toFixed(2).replace(".", ",")};${(100 + 40 * Math.sin(i / 6)).toFixed(2).replace(".", ",")}`));
  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.querySelector("canvas")?.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, ["# probe 3", "Nr.;Weg [mm];Höhe [mm]", ...rows].join("\n"));
  await demo.until(async () => (await demo.state()) as unknown as { fit: { data: number[][] } }, ({ fit }) => fit.data.length === 39, "the points of the table");
  await demo.idle();
  const said = await demo.textOf("toast");
  assert.match(said, /39 points/u);
  assert.match(said, /of 3 columns, 2 and 3 were read as x and y/u, "the first only numbers the rows");
  assert.match(said, /line 10 /u, "the line without a number, counted as the text has it");
});

async function drop(demo: Demo, name: string, type: string, content: string | number[]): Promise<void> {
  await demo.page.evaluate(([fileName, fileType, bytes]) => {
    const data = new DataTransfer();
    data.items.add(new File([typeof bytes === "string" ? bytes : Uint8Array.from(bytes)], fileName, { type: fileType }));
    document.querySelector("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, type, content] as const);
}

const square = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h40v40h-40z"/></svg>';

test("V23 an SVG file comes in by the field, by drop on the stage and by paste", async (t) => {
  const demo = await open(t);
  await demo.byId("btn-import").click();
  await demo.byId("import-file").setInputFiles({ name: "logo.svg", mimeType: "image/svg+xml", buffer: Buffer.from(square) });
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[0, 0], [40, 0], [40, 40], [0, 40]]);

  await drop(demo, "logo.svg", "image/svg+xml", square);
  await demo.page.waitForFunction(() => window.explineDemo.getState().curve.contours.length === 2);

  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.querySelector("canvas")?.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, square);
  await demo.page.waitForFunction(() => window.explineDemo.getState().curve.contours.length === 3);
});

async function takeOffer(demo: Demo, label: string): Promise<void> {
  await demo.page.locator('[data-testid="toast"] .toast-action', { hasText: label }).click();
  await demo.idle();
}

test("a drawing that comes in is edited or simplified: each mode offers the other, and the dialog asks", async (t) => {
  const demo = await open(t);
  await drop(demo, "logo.svg", "image/svg+xml", square);
  await takeOffer(demo, "Simplify in Fit");
  const { mode, fit, curve } = await demo.state();
  assert.equal(mode, "fit");
  assert.equal(curve.contours.length, 1, "a copy: what is in Curve stays");
  assert.equal(await demo.page.locator('[data-testid="toast"] .toast-action').count(), 0, "nor is it offered there once more");
  for (const corner of [[0, 0], [40, 0], [40, 40], [0, 40]] as const) assert.ok(fit.data.some(([x, y]) => Math.hypot(x - corner[0], y - corner[1]) < 1e-9), `the corner ${corner} is not cut off`);
  assert.ok((await demo.metric("m-knots")) <= 6);
  await drop(demo, "logo.svg", "image/svg+xml", square.replace("M0 0", "M100 0"));
  await demo.page.waitForFunction((before) => window.explineDemo.getState().fit.data.length > before, fit.data.length);
  await takeOffer(demo, "Edit in Curve");
  assert.deepEqual((await demo.points(1)).map(({ x, y }) => [x, y]), [[100, 0], [140, 0], [140, 40], [100, 40]]);

  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(twoContours);
  await demo.byId("import-to").getByRole("radio", { name: "Fit, to simplify" }).check();
  assert.equal(await demo.byId("import-replace").isChecked(), false, "what is one's own stays unless one says otherwise");
  await demo.byId("import-replace").check();
  await demo.byId("import-apply").click();
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
  const after = await demo.state();
  assert.equal(after.mode, "fit");
  assert.equal(after.fit.starts.length, 1, "the two contours in place of what was there, as the dialog says");
  assert.equal(after.curve.contours.length, 2);
});

test("Simplify takes what is chosen to Fit; the same once more takes its place", async (t) => {
  const demo = await open(t);
  await imported(demo, twoContours);
  await demo.byId("curve-simplify").click();
  await demo.idle();
  assert.equal((await demo.state()).fit.starts.length, 1);
  await demo.byId("tab-curve").click();
  await demo.focusStage();
  await demo.press("]");
  await demo.byId("curve-simplify").click();
  await demo.idle();
  const { mode, fit } = await demo.state();
  assert.equal(mode, "fit");
  assert.deepEqual(fit.starts, []);
  const [max, knots] = [await demo.metric("m-max"), await demo.metric("m-knots")];
  // A quarter of a hundredth of the size of what is simplified, and not of what came first.
  assert.ok(max <= 0.0025 * Math.hypot(197, 110) && knots < 20, `${knots} knots, ${max} away`);
});

test("Simplify shows the drawing alone; Undo brings back what was drawn in Fit", async (t) => {
  const demo = await open(t, "#/fit");
  await demo.click("btn-clear");
  await demo.byId("fit-tool").getByRole("radio", { name: "Draw" }).check();
  await demo.dragFrom({ x: 300, y: 300 }, 200, 80, 30);
  const drawn = (await demo.state()).fit.data;
  assert.ok(drawn.length > 10);
  await demo.byId("tab-curve").click();
  await demo.byId("curve-simplify").click();
  await demo.idle();
  // The circle of two points about (400, 300).
  assert.ok((await demo.state()).fit.data.every(([x, y]) => Math.abs(Math.hypot(x - 400, y - 300) - 160) < 1e-6), "nothing but the circle");
  await takeOffer(demo, "Undo");
  assert.deepEqual((await demo.state()).fit.data, drawn);
});

test("an SVG that is dropped while Trace shows a sample leaves a drawing of one's own in Curve", async (t) => {
  const demo = await open(t);
  await imported(demo, twoContours);
  await demo.byId("tab-trace").click();
  await demo.idle();
  await drop(demo, "logo.svg", "image/svg+xml", square);
  await demo.page.waitForFunction(() => window.explineDemo.getState().mode === "curve");
  await demo.idle();
  assert.equal((await demo.state()).curve.contours.length, 3);
});

test("Ctrl+C copies what the mode shows: the fitted curve, the outlines as ink", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle", { permissions: ["clipboard-read", "clipboard-write"] });
  const copied = async (): Promise<string> => {
    await demo.focusStage();
    return demo.copied(() => demo.press("Control+c"));
  };
  const fit = /\sd="([^"]+)"/u.exec(await copied())?.[1] ?? "";
  const [circle] = evaluatePath(fit);
  assert.ok(circle !== undefined && bothWays(await demo.sample(2000), circle.points, true) <= 0.02 + 1e-3);
  await demo.load("#/trace?sample=trace-disc");
  const disc = await copied();
  assert.match(disc, /<path d="M[^CQL]*Z" fill="[^n]/u, "a filled path of arcs and nothing else");
});

test("V23 a JSON file restores the drawing that it was made of", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const saved = await demo.state();
  await demo.byId("btn-clear").click();
  await demo.byId("btn-import").click();
  await demo.byId("import-file").setInputFiles({ name: "heart.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(saved)) });
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
  assertSame(await demo.state(), saved);
});

test("V23 what cannot be read is refused by name, and the drawing stays", async (t) => {
  const demo = await open(t);
  const before = (await demo.state()).curve;
  const png = [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 0];
  for (const [name, type, content, id] of [
    ["paper.pdf", "application/pdf", "%PDF-1.7", "file-type"],
    ["renamed.svg", "image/svg+xml", png, "file-type"],
    ["error-page.svg", "image/svg+xml", "<!doctype html><html><body>404</body></html>", "svg-broken"],
    ["empty.svg", "image/svg+xml", '<svg xmlns="http://www.w3.org/2000/svg"><text>hi</text></svg>', "svg-nopath"],
    ["picture.svg", "image/svg+xml", '<svg xmlns="http://www.w3.org/2000/svg"><image href="data:image/png;base64,AA" width="9" height="9"/></svg>', "svg-nopath"],
    ["newer.json", "application/json", '{"format":"expline-demo","version":9}', "json-version"],
    ["other.json", "application/json", '{"version":1}', "json-broken"],
    // Pictures are looked at by Trace, which then is open.
    ["photo.png", "image/png", png, "image-broken"],
  ] as const) {
    await drop(demo, name, type, content as string | number[]);
    const error = demo.page.locator(`[data-testid="error"][data-error="${id}"]`);
    await error.waitFor();
    if (id === "image-broken") assert.match((await error.textContent()) ?? "", /photo\.png/);
    assertSame((await demo.state()).curve, before);
  }
});

test("V23 pasting into a field changes that field only", async (t) => {
  const demo = await open(t);
  await demo.click("pt-0-0");
  const before = (await demo.state()).curve.contours.length;
  const field = demo.byId("pt-x");
  await field.focus();
  await demo.page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.activeElement?.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, "M0 0L10 10");
  await demo.idle();
  assert.equal((await demo.state()).curve.contours.length, before);
});

test("DM-027 DM-028 a field takes a decimal comma and refuses what is no number, keeping its value", async (t) => {
  const demo = await open(t);
  const omega = demo.byId("omega");
  await omega.fill("1,5");
  await omega.press("Enter");
  await demo.idle();
  assert.equal((await demo.state()).curve.omega, 1.5);
  for (const text of ["1e999", "abc", "", "0x10", "7"]) {
    await omega.fill(text);
    await omega.press("Enter");
    await demo.idle();
    assert.equal((await demo.state()).curve.omega, 1.5, text);
    assert.equal(await demo.page.locator('[data-error="number"]').count(), 1, text);
    assert.equal(await omega.inputValue(), "1.5", text);
  }
});

test("an automatic frequency is shown as the number that it is, and arrows step from there", async (t) => {
  const demo = await open(t);
  const omega = demo.byId("omega");
  assert.equal(await omega.inputValue(), "3.1416", "2π over 2 points");
  await demo.byId("points").fill("8");
  await demo.byId("points").press("Enter");
  await demo.idle();
  assert.equal(await omega.inputValue(), "0.7854", "2π over 8 points");
  assert.equal((await demo.state()).curve.omega, "auto");
  await omega.press("ArrowUp");
  await demo.idle();
  assert.equal(await omega.inputValue(), "0.7954");
  assert.ok(Math.abs(Number((await demo.state()).curve.omega) - Math.PI / 4 - 0.01) < 1e-11, "from the number itself, not from its printed digits");
  await demo.click("omega-auto");
  assert.equal(await omega.inputValue(), "0.7854");
  // Segments of a path have their own, which may be the same.
  await imported(demo, "M0 0a50 50 0 0 1 100 0a50 50 0 0 1-100 0z");
  assert.equal(await omega.inputValue(), "3.1416");
  await imported(demo, "M0 0a50 50 0 0 1 100 0C120 40 60 90 0 0z");
  assert.equal(await omega.inputValue(), "Mixed", "they differ");
});

test("a field adds up what is typed into it, and Undo takes a number back while the field has the focus", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  await demo.click("pt-0-1");
  const field = demo.byId("pt-x");
  const { x: start } = await demo.point(1);
  await field.focus();
  await demo.press("End");
  await demo.page.keyboard.type("+10");
  await demo.press("Enter");
  assert.equal((await demo.point(1)).x, start + 10);
  // Numbers in quick succession are one step.
  await demo.page.waitForTimeout(700);
  await field.fill("300/4px");
  await demo.press("Enter");
  assert.equal((await demo.point(1)).x, 75);
  await demo.press("Control+z");
  assert.equal((await demo.point(1)).x, start + 10);
  assert.equal(await field.inputValue(), (start + 10).toFixed(2));
  await demo.press("Control+Shift+z");
  assert.equal((await demo.point(1)).x, 75);
  // What is typed and not taken yet is the field's own to undo.
  await demo.page.keyboard.type("1");
  await demo.press("Control+z");
  assert.equal((await demo.point(1)).x, 75);
});

test("a joint that a file's few decimals have bent by a fraction of a degree is smooth, and not moved", async (t) => {
  const demo = await open(t);
  await imported(demo, "M0 0C10 0 30 5 40 10C50 15.02 70 10 80 10L80 40");
  const points = await demo.points();
  assert.deepEqual(points.map(({ kind }) => kind).slice(1, 3), ["smooth", "cusp"]);
  assert.deepEqual([points[1]?.out.dx.toFixed(9), points[1]?.out.dy.toFixed(9)], ["10.000000000", "5.020000000"]);
});

test("an imported logo keeps its corners and can be edited at once", async (t) => {
  const demo = await open(t);
  await imported(demo, square);
  await demo.withoutSnap();
  const at: Pair = [40, 40];
  const screen = await demo.toScreen(...at);
  await demo.dragFrom(screen, 20, 10);
  const zoom = (await demo.state()).view.zoom;
  const moved = await demo.point(2);
  assert.ok(Math.abs(moved.x - (40 + 20 / zoom)) < 0.5 / zoom && Math.abs(moved.y - (40 + 10 / zoom)) < 0.5 / zoom);
  assert.equal(moved.kind, "cusp");
});

test("a second logo is chosen, so that it can be moved from where it lies over the first", async (t) => {
  const demo = await open(t);
  await imported(demo, square);
  assert.equal(await demo.page.getByText("Nothing selected. Click a point").count(), 1, "one that is alone is looked at first");
  const first = await demo.points();
  await demo.byId("btn-import").click();
  assert.equal(await demo.byId("import-replace").isChecked(), false, "what is one's own stays unless one says otherwise");
  await imported(demo, square);
  await demo.withoutSnap();
  const from = await demo.toScreen(first[0]?.x ?? 0, first[0]?.y ?? 0);
  // Where two points are at one place, the chosen one is taken.
  await demo.dragFrom(from, 60, 30);
  const { zoom } = (await demo.state()).view;
  assert.deepEqual(await demo.points(0), first, "the first one has stayed");
  for (const [i, { x, y }] of (await demo.points(1)).entries()) {
    const [dx, dy] = [x - (first[i]?.x ?? 0), y - (first[i]?.y ?? 0)];
    assert.ok(Math.abs(dx - 60 / zoom) < 0.5 / zoom && Math.abs(dy - 30 / zoom) < 0.5 / zoom, `point ${i} by ${dx}, ${dy}`);
  }
});

test("what another mode hands over in place of somebody's own drawing says so, and Undo brings that back", async (t) => {
  const demo = await open(t, "#/fit?sample=fit-circle");
  await demo.byId("fit-edit").click();
  await demo.byId("toast").waitFor();
  assert.doesNotMatch(await demo.textOf("toast"), /Undo/u, "the sample that the page opens with is nobody's work");
  await demo.byId("btn-clear").click();
  await imported(demo, square);
  const { curve } = await demo.state();
  await demo.byId("tab-fit").click();
  await demo.byId("fit-edit").click();
  await demo.page.locator(".toast", { hasText: "Undo restores the previous drawing." }).getByRole("button", { name: "Undo" }).click();
  await demo.idle();
  assertSame((await demo.state()).curve, curve);
});

test("what draws nothing is refused and leaves the drawing; rows under a heading are points", async (t) => {
  const demo = await open(t, "#/curve?sample=heart");
  const { curve } = await demo.state();
  for (const text of ["M10 10", "M10 10 M20 20", "   "]) {
    assert.equal((await refused(demo, text)).id, "paste-unknown", text);
    assertSame((await demo.state()).curve, curve);
  }
  assert.match((await refused(demo, "M 0 0 L")).text, /character 8, where it ends/);
  await imported(demo, "x,y\n10,20\n30,45\n80,20\n");
  assert.deepEqual((await demo.points()).map(({ x, y }) => [x, y]), [[10, 20], [30, 45], [80, 20]]);
});

test("a path of 20,000 points has names for those around the chosen one; one of 150,000 is too large", async (t) => {
  const demo = await open(t);
  const paste = (count: number): Promise<void> => demo.page.evaluate((n) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", `M1 1${Array.from({ length: n - 1 }, (_, i) => `L${i % 1000} ${(i * 7) % 777}`).join("")}`);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, count);
  await paste(20_000);
  await demo.until(() => demo.metric("m-points"), (points) => points === 20_000, "the path is there");
  const buttons = (): Promise<number> => demo.page.locator(".stage-proxies button").count();
  assert.ok(await buttons() <= 256, `${await buttons()} buttons`);
  await demo.focusStage();
  await demo.press("End");
  await demo.byId("pt-0-19999").waitFor({ state: "attached" });
  assert.ok(await buttons() <= 256 + 4, `${await buttons()} buttons`);
  await paste(150_000);
  await demo.byId("error").waitFor();
  assert.equal(await demo.byId("error").getAttribute("data-error"), "d-big");
  assert.equal(await demo.metric("m-points"), 20_000);
});
