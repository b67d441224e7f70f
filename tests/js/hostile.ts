// What every hostile case must leave behind: a clear error or a finite answer, and a package that works as before.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";

import { ExplineError, HermiteCurve } from "expline";

/** What a refusal must say. */
export interface Refusal {
  code: ExplineError["code"];
  /** The argument at fault; the message names it. */
  arg?: string;
  index?: number;
  /** Part of the bound that is named. */
  bound?: string;
  limit?: string;
  path?: string;
  reason?: string;
}

/** One row of the table. */
export interface Case {
  id: string;
  what: string;
  /** What is called; its value is looked at for numbers that are not finite. */
  run?: () => unknown;
  refuses?: Refusal;
  /** What a result must be like. */
  gives?: (result: never) => void;
  /** Why the case has no meaning here; then it has no call. */
  senseless?: string;
}

const MESSAGE = /^[\w.]+: .{3,260} \[E_[A-Z_]+\]$/;

/** A fixed piece of work of every kind, as one hash. */
export function reference(): string {
  const hash = createHash("sha256");
  const curve = HermiteCurve.ellipse({ center: [1, 2], radii: [5, 3], rotation: 0.3, count: 5 });
  for (const numbers of [
    curve.sample(100),
    curve.evaluate(Float64Array.of(0.1, 2.5, -7.3), 2),
    curve.insert(0.3).bezierPoints(),
    curve.flatten(0.01),
    Float64Array.of(curve.length(), curve.area(), curve.nearest(9, 9).t),
  ]) {
    hash.update(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength));
  }
  return hash.update(curve.toPathD({ arcs: false }).d).digest("hex");
}

function numbersOf(value: unknown): number[] {
  if (typeof value === "number") return [value];
  if (value instanceof Float64Array) return Array.from(value);
  if (value instanceof HermiteCurve) return numbersOf(value.toJSON());
  if (typeof value === "object" && value !== null) return Object.values(value).flatMap(numbersOf);
  return [];
}

function checkRefusal(error: unknown, expected: Refusal): void {
  assert.ok(error instanceof ExplineError, `not an ExplineError: ${String(error)}`);
  assert.equal(error.code, expected.code, error.message);
  assert.match(error.message, MESSAGE);
  assert.ok(error.message.endsWith(`[${expected.code}]`), error.message);
  assert.equal(error.fatal, false, "a refusal is no fault of the engine");
  if (expected.arg !== undefined) {
    assert.equal(error.arg, expected.arg, error.message);
    assert.ok(error.message.includes(error.argument ?? expected.arg), `${error.message} names no ${expected.arg}`);
  }
  for (const field of ["index", "limit", "path", "reason"] as const) {
    if (expected[field] !== undefined) assert.equal(error[field], expected[field], `${field} of ${error.message}`);
  }
  if (expected.bound !== undefined) assert.ok(error.bound?.includes(expected.bound), `${error.bound} has no ${expected.bound}`);
}

/** Registers every row as a test, and one that says how many there are and which have no meaning. */
export function testCases(title: string, cases: readonly Case[]): void {
  const before = reference();
  for (const { id, what, run, refuses, gives, senseless } of cases) {
    if (senseless !== undefined) continue;
    test(`${id}: ${what}`, () => {
      assert.ok(run !== undefined && (refuses !== undefined) !== (gives !== undefined), `${id} is not a whole row`);
      const keys = Object.getOwnPropertyNames(Object.prototype).length;
      if (refuses !== undefined) {
        assert.throws(run, (error) => (checkRefusal(error, refuses), true));
      } else {
        const result = run();
        for (const number of numbersOf(result)) assert.ok(Number.isFinite(number), `${number} in the result`);
        gives?.(result as never);
      }
      assert.equal(Object.getOwnPropertyNames(Object.prototype).length, keys, "Object.prototype has changed");
      assert.equal(reference(), before, "a later call gives other bits");
    });
  }
  test(`${title}: every id is there once`, (t) => {
    const ids = cases.map(({ id }) => id);
    assert.equal(new Set(ids).size, ids.length);
    const without = cases.filter(({ senseless }) => senseless !== undefined);
    t.diagnostic(`${title}: ${cases.length - without.length} cases run, ${without.length} have no meaning here`);
    for (const reason of new Set(without.map(({ senseless }) => senseless))) {
      const which = without.filter(({ senseless }) => senseless === reason).map(({ id }) => id);
      t.diagnostic(`  ${which.join(", ")}: ${reason}`);
    }
  });
}
