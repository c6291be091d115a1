// What is said of lines that are not planned yet.
import assert from "node:assert/strict";
import { test } from "node:test";
import { expectedLines } from "../src/plan/expected_lines.ts";
import type { Plan } from "../src/plan/plan.ts";
import { roughTime } from "../src/units.ts";

// Lines 2, 3 and 5 with 1, 2 and 3 s by their feedrates.
const plan = { period_s: 0.001, nominal: { line: Float64Array.of(2, 3, 5), seconds: Float64Array.of(1, 2, 3) } } as unknown as Plan;
const expected = (known: [number, number][], left_s: number | null): [number, number][] => {
  const found: [number, number][] = [];
  expectedLines(plan, { lines: new Map(known), left_s }).forEach((ticks, line) => found.push([line, ticks]));
  return found;
};

test("lines that are not planned share what is left as their feedrates have it", () => {
  assert.deepEqual(expected([], 12), [[2, 2000], [3, 4000], [5, 6000]]);
  assert.deepEqual(expected([[2, 1500]], 10), [[3, 4000], [5, 6000]]);
});

test("no line is expected to take time where nothing is known of what is left, or all are planned", () => {
  assert.deepEqual(expected([], null), []);
  assert.deepEqual(expected([[2, 1], [3, 1], [5, 1]], 0.5), []);
});

test("the time of a line that is not planned has two digits", () => {
  const texts = [0.0123, 0.0996, 0.456, 0.996, 1.234, 9.96, 34.5, 59.6, 125].map(roughTime);
  assert.deepEqual(texts, ["≈0.012", "≈0.10", "≈0.46", "≈1.0", "≈1.2", "≈10", "≈35", "≈1:00", "≈2:05"]);
});
