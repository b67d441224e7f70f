import assert from "node:assert/strict";
import { test } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

const browser = useBrowser();

/** A small window: where no graphics card shades, the processor does it pixel by pixel. */
function open(t: Parameters<typeof browser.open>[0], hash = ""): Promise<Demo> {
  return browser.open(t, hash, { viewport: { width: 1030, height: 560 } });
}

type Place = readonly [number, number, number];

/** The mesh on its uniform grid of 65 × 65 parameters. */
async function mesh(demo: Demo): Promise<Place[]> {
  const { positions, rows, cols } = await demo.page.evaluate(() => window.explineDemo.mesh(65, 65));
  assert.deepEqual([rows, cols, positions.length], [65, 65, 3 * 65 * 65]);
  return Array.from({ length: rows * cols }, (_, i) => [positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0]);
}

function distances(a: readonly Place[], b: readonly Place[]): number[] {
  return a.map((p, i) => Math.hypot(p[0] - (b[i]?.[0] ?? 0), p[1] - (b[i]?.[1] ?? 0), p[2] - (b[i]?.[2] ?? 0)));
}

function largest(a: readonly Place[], b: readonly Place[]): number {
  return Math.max(...distances(a, b));
}

async function surfaceOf(demo: Demo): Promise<Awaited<ReturnType<Demo["state"]>>["surface"]> {
  return (await demo.state()).surface;
}

/** The stage as it is on the screen, both canvases. */
async function picture(demo: Demo): Promise<Buffer> {
  return demo.byId("stage").screenshot();
}

/**
 * The shares of the stage that are not paper, and that have the warm colour of an inside, of what the page itself has
 * drawn.
 */
async function shares(demo: Demo): Promise<{ ink: number; inside: number }> {
  const shot = await picture(demo);
  return demo.page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    if (context === null) return { ink: 0, inside: 0 };
    context.drawImage(image, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, image.width, image.height);
    let [drawn, warm] = [0, 0];
    for (let i = 0; i < pixels.length; i += 4) {
      const away = [0, 1, 2].some((k) => Math.abs((pixels[i + k] ?? 0) - (pixels[4 * 40 + k] ?? 0)) > 8);
      if (away) drawn += 1;
      if ((pixels[i] ?? 0) > (pixels[i + 2] ?? 0) + 16) warm += 1;
    }
    return { ink: drawn / (pixels.length / 4), inside: warm / (pixels.length / 4) };
  }, shot.toString("base64"));
}

test("V25 the sphere is a sphere; turning the view changes the picture and not the surface", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-sphere");
  const before = await mesh(demo);
  const error = Math.max(...before.map((p) => Math.abs(Math.hypot(...p) - 1)));
  t.diagnostic(`sphere of radius 1: largest error ${error}`);
  assert.ok(error <= 1e-6);
  const shot = await picture(demo);
  const stage = await demo.byId("stage").boundingBox();
  assert.ok(stage !== null);
  await demo.dragFrom({ x: stage.x + 30, y: stage.y + 30 }, 120, 50);
  assert.notDeepEqual(await picture(demo), shot);
  assert.deepEqual(await mesh(demo), before);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
  assert.deepEqual(demo.complaints, []);
});

test("V25 dragging a control point moves the surface near it and nowhere else, and one undo takes it back", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const { support, u, v, net } = await surfaceOf(demo);
  const before = await mesh(demo);
  const old = net.find((point) => point.u === 1 && point.v === 1);
  assert.ok(old !== undefined && u !== undefined && v !== undefined);
  await demo.drag("cp-1-1", 60, 0);
  const after = await mesh(demo);
  const moved = distances(before, after);
  assert.ok(Math.max(...moved) > 0.05, `moved by ${Math.max(...moved)}`);
  const around = (value: number, period: number): number => Math.min(((value % period) + period) % period, period - (((value % period) + period) % period));
  moved.forEach((distance, i) => {
    const [s, r] = [(Math.floor(i / 65) / 65) * u.count, ((i % 65) / 65) * v.count];
    if (around(s - 1, u.count) > support[0] || around(r - 1, v.count) > support[1]) assert.ok(distance <= 1e-7, `at ${s}, ${r}: ${distance}`);
  });
  const chosen = (await surfaceOf(demo)).net.find((point) => point.u === 1 && point.v === 1);
  assert.ok(chosen !== undefined && Math.hypot(chosen.x - old.x, chosen.y - old.y, chosen.z - old.z) > 0.05);
  await demo.press("Control+z");
  assert.deepEqual(await mesh(demo), before);
});

test("V25 levels leave the surface where it is, up and down; a typed coordinate moves it", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-sphere");
  const before = await mesh(demo);
  const points = (await surfaceOf(demo)).net.length;
  for (const level of [1, 2]) {
    await demo.slide("surf-level-u", level);
    assert.equal((await surfaceOf(demo)).levelU, level);
    assert.ok((await surfaceOf(demo)).net.length > points);
    assert.ok(largest(await mesh(demo), before) <= 1e-6);
  }
  await demo.slide("surf-level-u", 0);
  assert.equal((await surfaceOf(demo)).net.length, points);
  assert.ok(largest(await mesh(demo), before) <= 1e-9);
  await demo.click("cp-2-3");
  const y = Number(await demo.byId("surf-y").inputValue());
  await demo.byId("surf-y").fill(String(y + 0.25));
  await demo.press("Enter");
  const typed = (await surfaceOf(demo)).net.find((point) => point.u === 2 && point.v === 3);
  assert.ok(typed !== undefined && Math.abs(typed.y - y - 0.25) < 1e-3);
  assert.ok(largest(await mesh(demo), before) > 0.05);
});

test("a long coordinate is seen as far as there is room, and told in full; what is typed is kept with every digit, and arrows step from it", async (t) => {
  const demo = await open(t, "#/surface");
  await demo.focusStage();
  await demo.press("]");
  const field = demo.byId("surf-x");
  const x = async (): Promise<number | undefined> => (await surfaceOf(demo)).net[0]?.x;
  // Each beside the last: the step between them is no number of as many digits.
  for (const [typed, seen] of [["-123.456789", "-123.46"], ["12.3456789", "12.346"], ["-54321.9876", "-54322"], ["-1.23456789", "-1.2346"]] as const) {
    await field.fill(typed);
    await demo.press("Enter");
    assert.equal(await x(), Number(typed));
    assert.equal(await field.inputValue(), seen);
    const { cut, told } = await field.evaluate((input: HTMLInputElement) => ({ cut: input.scrollWidth - input.clientWidth, told: input.title }));
    assert.ok(cut <= 0, `${seen} is cut by ${cut} px`);
    assert.ok(told.startsWith(`${typed}.`), told);
  }
  await demo.press("ArrowUp");
  assert.ok(Math.abs((await x() ?? NaN) - -1.22456789) < 1e-12, `${await x()}`);
});

test("refining a place adds points there alone and moves nothing; the finer points move less of the surface", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const before = await mesh(demo);
  await demo.click("cp-1-1");
  await demo.byId("surf-refine").click();
  await demo.idle();
  const { details, net } = await surfaceOf(demo);
  assert.equal(details?.length, 1);
  assert.ok(largest(await mesh(demo), before) <= 1e-12);
  await demo.drag("cd-0-1-1", 25, -10);
  const moved = distances(await mesh(demo), before).filter((distance) => distance > 1e-9).length;
  assert.ok(moved > 0);
  await demo.press("Control+z", "Control+z");
  await demo.drag("cp-1-1", 25, -10);
  const coarse = distances(await mesh(demo), before).filter((distance) => distance > 1e-9).length;
  assert.ok(moved < coarse, `${moved} vertices against ${coarse}`);
  assert.equal(net.length, (await surfaceOf(demo)).net.length);
});

test("the count of triangles follows the tessellation, and the time of a frame the turning of the view", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const coarse = await demo.metric("m-triangles");
  await demo.slide("surf-tess", 32);
  assert.equal(await demo.metric("m-triangles"), 4 * coarse);
  await demo.page.evaluate(() => {
    const shown = document.querySelector('[data-testid="m-ms"]');
    const seen = new Set<string>();
    Reflect.set(window, "frameTimes", seen);
    if (shown !== null) new MutationObserver(() => seen.add(shown.getAttribute("data-value") ?? "")).observe(shown, { attributes: true });
  });
  const { x } = await demo.centre("stage");
  await demo.page.mouse.move(x, 120);
  await demo.page.mouse.down();
  for (let i = 1; i <= 10; i += 1) await demo.page.mouse.move(x + 12 * i, 120);
  await demo.page.mouse.up();
  await demo.idle();
  assert.ok(await demo.page.evaluate(() => (Reflect.get(window, "frameTimes") as Set<string>).size) > 2);
});

for (const sample of ["surf-torus", "surf-roman", "surf-paraboloid", "surf-cylinder", "surf-character"]) {
  test(`V25 ${sample} is drawn`, async (t) => {
    const demo = await open(t, `#/surface?sample=${sample}`);
    const { ink } = await shares(demo);
    assert.ok(ink >= 0.02, `${ink} of the stage`);
    assert.deepEqual(demo.complaints, []);
  });
}

test("of sheets that lie on each other, as all of the Roman surface do, the outside is seen; elsewhere insides are", async (t) => {
  const roman = await shares(await open(t, "#/surface?sample=surf-roman"));
  const cylinder = await shares(await open(t, "#/surface?sample=surf-cylinder"));
  assert.ok(roman.ink > 0.1 && roman.inside < 1e-3, `inside ${roman.inside} of ${roman.ink}`);
  assert.ok(cylinder.inside > 0.02, `inside ${cylinder.inside} of ${cylinder.ink}`);
});

test("without WebGL 2 the surface is drawn in lines, says why, and can be edited all the same", async (t) => {
  const demo = await open(t);
  await demo.page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function patched(this: HTMLCanvasElement, ...parameters: Parameters<typeof original>) {
      return parameters[0] === "webgl2" ? null : original.apply(this, parameters);
    } as typeof original;
  });
  await demo.page.reload();
  await demo.load("#/surface?sample=surf-torus");
  assert.match(await demo.textOf("surface-note"), /WebGL 2/);
  assert.ok((await shares(demo)).ink >= 0.02);
  const before = await mesh(demo);
  await demo.drag("cp-1-1", 40, 0);
  assert.ok(largest(await mesh(demo), before) > 0.03);
  assert.deepEqual(demo.complaints, []);
});

test("an address with a sample that there is none of says so and shows the first one", async (t) => {
  const demo = await open(t, "#/surface?sample=teapot");
  assert.match(await demo.textOf("toast"), /no sample called teapot/u);
  assert.equal(await demo.page.evaluate(() => location.hash), "#/surface?sample=surf-torus");
});

test("the address names the sample for as long as it is as it was opened, and leads back to it", async (t) => {
  const demo = await open(t, "#/surface");
  const address = (): Promise<string> => demo.page.evaluate(() => location.hash);
  assert.equal(await address(), "#/surface?sample=surf-torus");
  await demo.byId("surf-sample").selectOption("surf-sphere");
  await demo.idle();
  assert.equal(await address(), "#/surface?sample=surf-sphere");
  await demo.drag("cp-2-2", 20, 10);
  assert.equal(await address(), "#/surface");
  await demo.press("Control+z");
  assert.equal(await address(), "#/surface?sample=surf-sphere");
  await demo.page.goBack();
  await demo.page.waitForFunction(() => window.explineDemo.getState().surface.sample === "surf-torus");
  assert.equal(await address(), "#/surface?sample=surf-torus");
});

test("in forced colours the solid has no colour of its own: shape alone, in the system's", async (t) => {
  const demo = await browser.open(t, "#/surface?sample=surf-torus", { viewport: { width: 1030, height: 560 }, forcedColors: "active", colorScheme: "light" });
  const shot = (await demo.byId("stage").screenshot()).toString("base64");
  const seen = await demo.page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context?.drawImage(image, 0, 0);
    const pixels = context?.getImageData(0, 0, image.width, image.height).data ?? new Uint8ClampedArray();
    let [coloured, dark] = [0, 0];
    for (let i = 0; i < pixels.length; i += 4) {
      const [r = 0, g = 0, b = 0] = pixels.subarray(i, i + 3);
      if (Math.max(r, g, b) - Math.min(r, g, b) > 8) coloured += 1;
      if (Math.max(r, g, b) < 100) dark += 1;
    }
    return { coloured: coloured / (pixels.length / 4), dark: dark / (pixels.length / 4) };
  }, shot);
  assert.ok(seen.coloured < 1e-3, `${(100 * seen.coloured).toFixed(1)} % of the stage is coloured`);
  assert.ok(seen.dark > 0.005, "its lines are there");
});

test("a lost graphics context is drawn in lines until it comes back", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const shaded = await picture(demo);
  const lose = async (gone: boolean): Promise<void> => {
    await demo.page.evaluate((now) => {
      const canvas = document.querySelector<HTMLCanvasElement>(".stage-solid");
      const store = window as unknown as { extension?: WEBGL_lose_context | null };
      store.extension ??= canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null;
      if (now) store.extension?.loseContext();
      else store.extension?.restoreContext();
    }, gone);
    await demo.until(() => demo.byId("surface-note").isVisible(), (shown) => shown === gone, "the note comes and goes");
    await demo.idle();
  };
  await lose(true);
  assert.match(await demo.textOf("surface-note"), /graphics card/);
  await lose(false);
  assert.equal(await demo.byId("surface-note").isVisible(), false);
  assert.deepEqual(await picture(demo), shaded);
});

test("Surface by keyboard alone: points are stepped through, nudged, refined, and read out", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const before = await mesh(demo);
  await demo.focusStage();
  await demo.press("]", "]");
  assert.match(await demo.textOf("live"), /Control point 1, 2, on the surface/);
  // One press: on a slow machine two of them are too far apart to be one entry.
  await demo.press("ArrowUp");
  assert.ok(largest(await mesh(demo), before) > 0.003);
  await demo.press("Control+z");
  assert.deepEqual(await mesh(demo), before);
  await demo.press("Enter");
  assert.equal((await surfaceOf(demo)).details?.length, 1);
  await demo.press("Shift+3");
  assert.equal(await demo.byId("stage").getAttribute("aria-label"), "Surface");
});

test("the weights of the chosen point stand on the surface, the views of a drawing board are buttons, and nothing of either moves it", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const before = await mesh(demo);
  const plain = await picture(demo);
  await demo.byId("ov-weights").check();
  await demo.idle();
  const first = await picture(demo);
  assert.notDeepEqual(first, plain);
  await demo.focusStage();
  await demo.press("]", "]", "]");
  const other = await picture(demo);
  await demo.byId("ov-weights").uncheck();
  await demo.idle();
  assert.notDeepEqual(await picture(demo), other);
  await demo.byId("surf-top").click();
  await demo.idle();
  assert.ok(((await demo.state()).orbit?.pitch ?? 0) > 1.5);
  assert.deepEqual(await mesh(demo), before);
});

test("a surface goes through its file and through a link with every bit", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-cylinder");
  await demo.drag("cp-1-3", 30, 10);
  await demo.click("cp-1-3");
  await demo.byId("surf-refine").click();
  await demo.idle();
  const state = await demo.state();
  await demo.byId("surf-sample").selectOption("surf-sphere");
  await demo.idle();
  await demo.page.evaluate((saved) => window.explineDemo.setState(saved), state);
  assert.deepEqual((await demo.state()).surface, state.surface);
});

test("a surface that is none, in a file that is opened over another surface, gives way to its sample, and the page goes on", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-sphere");
  const good = await demo.state();
  const { u } = good.surface;
  assert.ok(u !== undefined);
  // Roots come in pairs: alone, this one spans no real function.
  const alone = u.roots.map((root, i) => (i === 1 ? { ...root, im: 2 } : root));
  await demo.page.evaluate((state) => window.explineDemo.setState(state), { ...good, surface: { ...good.surface, u: { ...u, roots: alone } } });
  await demo.idle();
  assert.deepEqual((await demo.state()).surface.u, u);
  assert.match(await demo.textOf("error"), /The surface could not be opened/u);
  await demo.press("]");
  assert.deepEqual(demo.complaints, []);
});

test("the 3-D library is loaded with Surface mode and not before", async (t) => {
  const demo = await open(t);
  const requests: string[] = [];
  demo.page.on("request", (request) => requests.push(new URL(request.url()).pathname));
  const loaded = await demo.page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
  assert.equal(loaded.filter((name) => /surface-mode|shaded-view/.test(name)).length, 0);
  await demo.byId("tab-surface").click();
  await demo.idle();
  assert.ok(requests.some((name) => /shaded-view/.test(name)));
});

test("the zoom is that of the view: moving a point changes neither, and fitting the surface makes it 100 % again", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const percent = (): Promise<string> => demo.byId("zoom-pct").inputValue();
  assert.equal(await percent(), "100 %");
  await demo.drag("cp-1-1", 160, 0);
  assert.equal(await percent(), "100 %");
  // The page's own file opens with the view as it was.
  await demo.page.evaluate(() => window.explineDemo.setState(window.explineDemo.getState()));
  const opened = await percent();
  await demo.drag("cp-1-1", -90, 0);
  assert.equal(await percent(), opened);
  await demo.byId("zoom-fit").click();
  await demo.idle();
  assert.equal(await percent(), "100 %");
  await demo.byId("zoom-pct").fill("50");
  await demo.press("Enter");
  assert.equal(await percent(), "50 %");
});

test("the wheel zooms at the pointer: the point under it stays there, and the surface is not gone through", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-sphere");
  const before = await demo.centre("cp-1-3");
  // A wheel is on whole pixels.
  const at = { x: Math.floor(before.x), y: Math.floor(before.y) };
  for (let turn = 0; turn < 5; turn += 1) await demo.wheel(at, 5);
  const [now, zoom] = [await demo.centre("cp-1-3"), parseFloat(await demo.byId("zoom-pct").inputValue()) / 100];
  assert.ok(zoom > 10);
  // What is beside the pointer, as far away as what is under it, goes away from it by as much as is zoomed.
  const wanted = { x: at.x + zoom * (before.x - at.x), y: at.y + zoom * (before.y - at.y) };
  assert.ok(Math.hypot(now.x - wanted.x, now.y - wanted.y) <= 1.5, JSON.stringify({ at, now, wanted }));
  // Insides are warm, and whoever is in the sphere sees nothing else.
  assert.ok((await shares(demo)).inside < 0.01);
});

test("without a drag the view turns as well: by buttons, and by arrows while nothing is selected", async (t) => {
  const demo = await open(t, "#/surface?sample=surf-torus");
  const before = await mesh(demo);
  const first = await picture(demo);
  await demo.byId("surf-turn-left").click();
  await demo.idle();
  const turned = await picture(demo);
  assert.notDeepEqual(turned, first);
  assert.match(await demo.textOf("live"), /Seen from \d+ degrees around, \d+ degrees above/u);
  await demo.focusStage();
  await demo.press("ArrowRight");
  assert.notDeepEqual(await picture(demo), turned);
  await demo.press("Shift+ArrowRight", "Alt+ArrowDown");
  assert.deepEqual(await mesh(demo), before);
  assert.equal(await demo.byId("btn-undo").isDisabled(), true);
});
