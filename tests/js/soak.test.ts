// A long session: thousands of edits of many curves, beside a model that is nothing but arrays.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve, InterpolatingCurve, fitSparse, fromJSON } from "expline";

import { bytesOfEngines, memories } from "./memories.ts";

const pages = (): number => bytesOfEngines() / 65_536;

/** The same numbers in every run. */
let seed = 7;
const random = (): number => (seed = (seed * 48_271) % 2_147_483_647) / 2_147_483_647;
const below = (n: number): number => Math.floor(random() * n);

/** A curve, and what its arrays must be. */
interface Modelled {
  curve: HermiteCurve;
  points: number[];
  tangents: number[];
}

function modelled(curve: HermiteCurve): Modelled {
  return { curve, points: Array.from(curve.points), tangents: Array.from(curve.tangents) };
}

function fresh(): Modelled {
  const points = Array.from({ length: 2 * (3 + below(9)) }, () => 100 * random());
  const tangents = points.map(() => 60 * random() - 30);
  return { curve: new HermiteCurve({ points, tangents, closed: random() < 0.7 }), points, tangents };
}

/** Edits, each done to the curve and, by other means, to the model. */
const EDITS: ((it: Modelled) => Modelled)[] = [
  (it) => {
    const [i, x, y] = [below(it.points.length / 2), 100 * random(), 100 * random()];
    it.curve.setPoint(i, x, y);
    it.points.splice(2 * i, 2, x, y);
    return it;
  },
  (it) => {
    const [i, x, y] = [below(it.points.length / 2), 60 * random() - 30, 60 * random() - 30];
    it.curve.setTangent(i, x, y);
    it.tangents.splice(2 * i, 2, x, y);
    return it;
  },
  (it) => {
    if (it.points.length > 60) return fresh();
    const [, end] = it.curve.domain;
    const t = (0.05 + 0.9 * random()) * end;
    const place = it.curve.evaluate(t);
    const longer = modelled(it.curve.insert(t));
    assert.equal(longer.points.length, it.points.length + 2, "one point more");
    const { distance } = longer.curve.nearest(place[0] ?? NaN, place[1] ?? NaN);
    assert.ok(distance < 1e-9, `the curve moved by ${distance}`);
    return longer;
  },
  (it) => (it.points.length > 8 ? modelled(it.curve.remove(1 + below(it.points.length / 2 - 2)).curve) : it),
  (it) => {
    const moved = modelled(it.curve.transform([1, 0, 0, 1, 3, -4]));
    it.points.forEach((value, k) => assert.equal(moved.points[k], value + (k % 2 === 0 ? 3 : -4), "every point moves alike"));
    return it;
  },
  (it) => {
    void [it.curve.length(), it.curve.bounds(), it.curve.nearest(50, 50), it.curve.flatten(0.1), it.curve.toPathD().d];
    return it;
  },
  (it) => modelled(fromJSON(JSON.parse(JSON.stringify(it.curve))) as HermiteCurve),
  () => fresh(),
];

/** Rarer and heavier: an engine each. */
function heavy(it: Modelled): void {
  const through = new InterpolatingCurve({ points: it.points });
  assert.equal(through.refine(1).points.length, 2 * it.points.length);
  assert.ok(fitSparse(it.curve.sample(60), { degree: 1, smoothing: 0.4 }).knots.length > 0);
}

test("fifteen thousand edits agree with plain arrays, and no engine's memory grows after the first three thousand", (t) => {
  const live = Array.from({ length: 60 }, fresh);
  let settled = 0;
  for (let edit = 1; edit <= 15_000; edit += 1) {
    const which = below(live.length);
    const before = live[which] as Modelled;
    live[which] = (EDITS[below(EDITS.length)] as (typeof EDITS)[number])(before);
    if (edit % 500 === 0) {
      heavy(live[which] as Modelled);
      for (const { curve, points, tangents } of live) {
        assert.deepEqual(Array.from(curve.points), points);
        assert.deepEqual(Array.from(curve.tangents), tangents);
        assert.deepEqual((fromJSON(curve.toJSON()) as HermiteCurve).sample(9), curve.sample(9), "made anew it is the same curve");
      }
    }
    if (edit === 3000) settled = pages();
  }
  assert.ok(settled > 0 && memories.length === 3, "three engines: curves, curves of any roots, fits");
  assert.ok(pages() <= settled + 2, `${pages()} pages of 64 kB, ${settled} before`);
  t.diagnostic(`${pages()} pages of 64 kB in ${memories.length} engines after 15,000 edits`);
});
