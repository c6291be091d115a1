// What is said of the lines of a plan that is on its way.
import assert from "node:assert/strict";
import { test } from "node:test";
import { ExpectedLines } from "../src/plan/expected_lines.ts";
import type { Plan } from "../src/plan/plan.ts";
import { roughTime } from "../src/units.ts";

// Of a line its number, its seconds by feedrate, where along the path it ends.
type Line = [line: number, seconds: number, end_mm: number];
function expected(lines: Line[], known: [line: number, ticks: number][], path_mm: number, left_s: number | null): [line: number, ticks: number][] {
  const column = (k: 0 | 1 | 2): Float64Array => Float64Array.from(lines, (line) => line[k]);
  const plan = { period_s: 0.001, nominal: { line: column(0), seconds: column(1), end_mm: column(2) } } as unknown as Plan;
  const found: [number, number][] = [];
  const ticks = known.reduce((sum, [, one]) => sum + one, 0);
  new ExpectedLines(plan).at({ ticks, path_mm, left_s, line: 0, lines: new Map(known) }).forEach((one, line) => found.push([line, one]));
  return found;
}

const THREE: Line[] = [[2, 1, 10], [3, 2, 30], [5, 3, 60]];

test("lines that are not planned share what is left as their feedrates have it", () => {
  assert.deepEqual(expected(THREE, [], 0, 12), [[2, 2000], [3, 4000], [5, 6000]]);
  assert.deepEqual(expected(THREE, [[2, 1500]], 10.5, 10), [[3, 4000], [5, 6000]]);
});

test("a line that goes on has its estimate, whatever of it is planned", () => {
  assert.deepEqual(expected(THREE, [[2, 1500], [3, 1000]], 20, 9), [[3, 4000], [5, 6000]]);
  // A loop of lines 2 and 3, once through: line 5 behind it takes no more than its share.
  const loop: Line[] = [[2, 50, 990], [3, 50, 1000], [5, 1, 1050]];
  assert.deepEqual(expected(loop, [[2, 1000], [3, 1000]], 20, 200), [[2, 100_000], [3, 100_000], [5, 2000]]);
});

test("no line is expected to take time where nothing is known of the whole, or all are planned", () => {
  assert.deepEqual(expected(THREE, [], 0, null), []);
  assert.deepEqual(expected(THREE, [[2, 1], [3, 1], [5, 1]], 61, 0.5), []);
});

test("the time of a line that is not planned has two digits", () => {
  const texts = [0.0123, 0.0996, 0.456, 0.996, 1.234, 9.96, 34.5, 59.6, 125].map(roughTime);
  assert.deepEqual(texts, ["≈0.012", "≈0.10", "≈0.46", "≈1.0", "≈1.2", "≈10", "≈35", "≈1:00", "≈2:05"]);
});
