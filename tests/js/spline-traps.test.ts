// The engine of curves of any roots dies, and takes nothing along; in the slim edition it waits to be loaded.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";

import { ExplineError, HermiteCurve, InterpolatingCurve, initSplineSync } from "expline";

import { trapping } from "./trapping.ts";

// In this process going back to points stops the engine; everything else is as it is delivered.
initSplineSync({ bytes: trapping("reduce_spline", "pkg/expline_spline_bg.wasm") });

test("after a trap curves of every kind from before give the bits that they gave", () => {
  const through = new InterpolatingCurve({ points: [0, 0, 4, 1, 5, 6, -1, 3] });
  const local = through.refineAt(1.5, { levels: 3 });
  local.setPatchPoint(0, 0, 5, 5);
  const fine = through.refine(2);
  const ellipse = HermiteCurve.ellipse({ center: [0, 0], radii: [3, 2], count: 4 });
  const all = [through, local, fine, ellipse];
  const samples = all.map((curve) => curve.sample(50));
  const lengths = all.map((curve) => curve.length());
  for (let i = 0; i < 20; i += 1) {
    assert.throws(() => fine.reduce(), (error) => {
      assert.ok(error instanceof ExplineError);
      assert.equal(error.code, "E_INTERNAL");
      assert.equal(error.fatal, true);
      return true;
    });
    assert.deepEqual(all.map((curve) => curve.sample(50)), samples);
    assert.deepEqual(all.map((curve) => curve.length()), lengths);
  }
});

test("a curve whose point was moved is to the bit what an engine that knows nothing makes of its points", () => {
  const points = [0, 0, 4, 1, 5, 6, -1, 3, -4, 1];
  const lists = [undefined, [0, 0, 0, 0], [0, { re: 0, im: 1 }, { re: 0, im: -1 }], [0, 0, 0, 0, 0, 0], [0, 0.5, -0.5]];
  const curves = lists.flatMap((roots) => [true, false].map((closed) => new InterpolatingCurve({ points, closed, ...(roots === undefined ? {} : { roots }) })));
  const all = [...curves, ...curves.slice(0, 3).map((curve) => curve.refineAt(1.2))];
  const moved = (): Float64Array[] => all.map((curve) => curve.sample(60));
  moved();
  all.forEach((curve, i) => curve.setPoint(1, 3, 0.25 * i));
  const kept = moved();
  const fine = new InterpolatingCurve({ points }).refine(1);
  assert.throws(() => fine.reduce(), ExplineError);
  assert.deepEqual(moved(), kept);
});

test("the path and the ellipse of a curve through points are those of its Hermite curve", () => {
  const place = (k: number): [number, number] => [3 + 2 * Math.cos((2 * Math.PI * k) / 7), 1 + 5 * Math.sin((2 * Math.PI * k) / 7)];
  const curve = new InterpolatingCurve({ points: [0, 1, 2, 3, 4, 5, 6].map(place) });
  const { curve: same, maxError } = curve.toHermite();
  assert.equal(maxError, 0);
  assert.equal(curve.toPathD().d, same.toPathD().d);
  assert.deepEqual(curve.asEllipse(), same.asEllipse());
});

test("the slim entry's curves through points say that they wait for initSpline, which finds its file", () => {
  const said = execFileSync(process.execPath, ["--input-type=module", "-e", `
    import init, { InterpolatingCurve, initSpline } from "expline/slim";
    await init();
    const points = [0, 0, 4, 0, 4, 4, 0, 4];
    let code;
    try { new InterpolatingCurve({ points }); } catch (error) { code = error.code; }
    await initSpline();
    console.log(code, new InterpolatingCurve({ points }).closed);
  `], { encoding: "utf8" }).trim();
  assert.equal(said, "E_NOT_READY true");
});
