/** The worker that measures long interpolating contours. */
import init, { initSpline } from "expline/slim";
import wasmUrl from "expline/expline_bg.wasm?url";
import splineUrl from "expline/expline_spline_bg.wasm?url";
import type { WholeMeasures } from "./in-worker.ts";
import { pathSize } from "./path-size.ts";
import { splineOf, type SplineShape } from "../spline-shape.ts";

async function measured(shape: SplineShape): Promise<WholeMeasures> {
  await Promise.all([init({ wasmUrl }), initSpline({ wasmUrl: splineUrl })]);
  const curve = splineOf(shape);
  return { length: curve.length(), area: curve.closed ? curve.area() : 0, bytes: pathSize(curve) };
}

addEventListener("message", (event: MessageEvent<SplineShape>) => {
  measured(event.data).then((measures) => postMessage(measures), (error: unknown) => postMessage(String(error)));
});
