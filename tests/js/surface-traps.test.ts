// The engine of surfaces dies, and takes nothing along.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, HermiteCurve, TensorSurface, initSurfaceSync } from "expline";

import { trapping } from "./trapping.ts";

// In this process going down a level stops the engine; everything else is as it is delivered.
initSurfaceSync({ bytes: trapping("surface_reduce", "pkg/expline_surface_bg.wasm") });

test("after a trap surfaces and curves from before give the bits that they gave", () => {
  const surface = TensorSurface.torus(3, 1).refineAt(2, 2);
  surface.setPoint(1, 1, 0, 4, 1);
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [3, 2], count: 4 });
  const [mesh, samples] = [surface.mesh(20, 20), curve.sample(50)];
  for (let i = 0; i < 20; i += 1) {
    assert.throws(() => surface.reduce(0, 0), (error) => {
      assert.ok(error instanceof ExplineError);
      assert.equal(error.code, "E_INTERNAL");
      assert.equal(error.fatal, true);
      return true;
    });
    assert.deepEqual(surface.mesh(20, 20), mesh);
    assert.deepEqual(curve.sample(50), samples);
  }
});
