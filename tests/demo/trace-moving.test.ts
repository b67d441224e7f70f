import assert from "node:assert/strict";
import { test, type TestContext } from "node:test";
import { useBrowser, type Demo } from "./page.ts";

const { open } = useBrowser();

/** Outlines on a lattice: 1,200 points of 100 rings. */
function rings(): object[] {
  return Array.from({ length: 100 }, (_, k) => {
    const [x, y, radius] = [40 + 80 * (k % 10), 30 + 60 * Math.floor(k / 10), 12 + (k % 7) * 2];
    const points = Array.from({ length: 12 }, (_, i) => {
      const [cos, sin] = [Math.cos((i * Math.PI) / 6), Math.sin((i * Math.PI) / 6)];
      const out = { dx: (-radius * sin * Math.PI) / 18, dy: (radius * cos * Math.PI) / 18 };
      return { x: x + radius * cos, y: y + radius * sin, kind: i === 3 ? "cusp" : "symmetric", in: { dx: -out.dx, dy: -out.dy }, out };
    });
    return { family: "hermite", closed: true, points, support: 1 };
  });
}

async function openRings(t: TestContext): Promise<Demo> {
  const demo = await open(t, "#/trace");
  const state = await demo.state();
  const kept = { name: "rings", width: 800, height: 600, contours: rings() };
  const changed = { ...state, mode: "trace" as const, view: { zoom: 0.8, x: 400, y: 300 }, trace: { settings: state.trace.settings, corners: [], kept } };
  await demo.page.evaluate((next) => window.explineDemo.setState(next as unknown as Parameters<typeof window.explineDemo.setState>[0]), changed);
  await demo.idle();
  return demo;
}

/** The picture as it is after everything was drawn from scratch. */
async function drawnAnew(demo: Demo): Promise<string> {
  for (const view of ["outline", "result"]) {
    await demo.byId("trace-view").locator(`[value="${view}"]`).check();
    await demo.idle();
  }
  return demo.pixels();
}

/** Cubics that were added to paths since the last time. */
function cubics(demo: Demo): Promise<number> {
  return demo.page.evaluate(() => {
    const { prototype } = Path2D;
    const since = Number(Reflect.get(window, "cubics") ?? 0);
    if (Reflect.get(window, "cubics") === undefined) {
      const add = prototype.bezierCurveTo;
      prototype.bezierCurveTo = function count(...place) {
        Reflect.set(window, "cubics", Number(Reflect.get(window, "cubics")) + 1);
        add.apply(this, place);
      };
    }
    Reflect.set(window, "cubics", 0);
    return since;
  });
}

test("a picture that was moved with its paper is what would be drawn, and of the outlines only those at its edge were", async (t) => {
  const demo = await openRings(t);
  const stage = await demo.centre("stage");
  // Beside all rings, where no point is under the pointer.
  const from = { x: stage.x, y: stage.y };
  await demo.dragFrom(from, 6, 4, 2);
  await cubics(demo);
  await demo.dragFrom(from, 40, -24, 5);
  const drawn = await cubics(demo);
  assert.ok(drawn < 5 * 1200 / 4, `${drawn} cubics in five steps`);
  const moved = await demo.pixels();
  await demo.page.mouse.move(from.x + 40, from.y - 24);
  // Places are single floats to a canvas: where a path stands elsewhere, a shade of its edge differs here and there. A
  // picture a pixel off has ten thousand.
  assert.ok((await demo.changedPixels(moved, await drawnAnew(demo))) < 100);
});

test("a picture that was zoomed is what would be drawn as soon as that is over", async (t) => {
  const demo = await openRings(t);
  const stage = await demo.centre("stage");
  for (const notches of [3, -5]) {
    await demo.wheel(stage, notches);
    const zoomed = await demo.pixels();
    assert.equal(await demo.changedPixels(zoomed, await drawnAnew(demo)), 0);
  }
});
