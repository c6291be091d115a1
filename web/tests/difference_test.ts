import assert from "node:assert/strict";
import { test } from "node:test";
import { accountOf } from "../src/plan/account.ts";
import { largestFirst, lineRows, pairLines, type LinePair, type Ran } from "../src/plan/difference.ts";
import { RunKind } from "../src/plan/plan.ts";
import { difference } from "../src/units.ts";
import { planOf, type MadeRun } from "./helper.ts";

const ran = (runs: readonly MadeRun[], source: string | null = null): Ran => {
  const plan = planOf(runs, source);
  return { plan, account: accountOf(plan) };
};
// "2", "2-4", nothing of no lines; of both texts.
const spans = ({ base, baseLast, other, otherLast }: LinePair): [string, string] => {
  const of = (first: number, last: number): string => (last < first ? "" : first === last ? `${first}` : `${first}-${last}`);
  return [of(base, baseLast), of(other, otherLast)];
};
const cut = (line: number, ticks: number): MadeRun => ({ line, ticks, kind: RunKind.cut });

test("lines of the same number are compared where the programs are the same", () => {
  const text = "G1 X1\nG1 X2\nG1 X3\n";
  const rows = lineRows(ran([cut(1, 100), cut(2, 50), cut(3, 7)], text), ran([cut(1, 90), cut(2, 80), cut(3, 7)], text));
  assert.deepEqual(rows.map(({ base, other, text, base_s, other_s }) => [base, other, text, base_s, other_s]), [
    [1, 1, "G1 X1", 0.1, 0.09],
    [2, 2, "G1 X2", 0.05, 0.08],
    [3, 3, "G1 X3", 0.007, 0.007],
  ]);
  assert.deepEqual(largestFirst(rows).map((row) => row.base), [2, 1, 3]);
});

test("lines that a post has put in, taken out or numbered anew leave the others where they are", () => {
  const before = "N10 G1 X1\nN20 G1 X2\nN30 G1 X3\nN40 M2\n";
  const after = "N5 (new head)\nN10 G1 X1\nN15 G0  x2\nN20 G1 X3\nN25 G1 X4\nN30 M2\n";
  assert.deepEqual(pairLines(before, after).map(spans), [["", "1"], ["1", "2"], ["2", "3"], ["3", "4"], ["", "5"], ["4", "6"]]);
  const rows = lineRows(ran([cut(1, 10), cut(2, 20)], before), ran([cut(2, 10), cut(3, 5), cut(5, 1)], after));
  assert.deepEqual(rows.map((row) => [...spans(row), row.base_s, row.other_s]), [["1", "2", 0.01, 0.01], ["2", "3", 0.02, 0.005], ["", "5", 0, 0.001]]);
});

test("lines between those that are found in both stand together where one text has more of them", () => {
  const before = "G21\nX1 F1000\nX2 F1000\nX3 F1000\nM2\n";
  const after = "G21\nX1 F1200\nG4 P0.1\nX2 F1200\nX3 F1200\nM2\n";
  assert.deepEqual(pairLines(before, after).map(spans), [["1", "1"], ["2-4", "2-5"], ["5", "6"]]);
  const rows = lineRows(ran([cut(2, 10), cut(3, 20), cut(4, 30)], before), ran([cut(2, 9), cut(3, 100), cut(4, 18), cut(5, 27)], after));
  assert.deepEqual(rows.map((row) => [...spans(row), row.text, row.base_s, row.other_s]), [["2-4", "2-5", "X1 F1200", 0.06, 0.154]]);
});

test("comments, blanks, numbers and small letters do not make a line another one, a slash does", () => {
  const meant = ["G1 X1 (now; X2", "/2 N7 G1 X1", "/N8 x5", "G1 (a(b) Y2; Z3", "N3", "M2"];
  const same = ["N1 g1\tx1;(", "/2g1x1(skipped)", "/ X5", "G1Y2", "(nothing)", "n9 M2 ; end"];
  assert.deepEqual(pairLines(["X9", ...meant].join("\n"), [...same, "X9"].join("\n")).map(spans), [["1", ""], ...meant.map((_, i) => [`${i + 2}`, `${i + 1}`]), ["", "7"]]);
  assert.deepEqual(pairLines("N1 X1\nX4", "/N1 X1\nX2\nX4\n").map(spans), [["1", "1-2"], ["2", "3"]]);
});

// Each line is in exactly one pair, both sides rise, and equal texts pair all lines.
test("pairs of random texts leave no line out and keep both orders", () => {
  let seed = 11;
  const random = (below: number): number => (seed = (seed * 16807) % 2147483647) % below;
  for (let trial = 0; trial < 200; ++trial) {
    const a = Array.from({ length: random(60) }, () => `G1 X${random(12)}`);
    const b = a.flatMap((line) => (random(5) === 0 ? [] : random(5) === 0 ? [line, `G1 Y${random(12)}`] : [line]));
    const pairs = pairLines(a.join("\n"), b.join("\n"));
    for (const [side, lines] of [["base", a], ["other", b]] as const) {
      const numbers = pairs.flatMap((pair) => Array.from({ length: pair[`${side}Last`] + 1 - pair[side] }, (_, i) => pair[side] + i));
      assert.deepEqual(numbers, Array.from({ length: Math.max(1, lines.length) }, (_, i) => i + 1), `trial ${trial}`);
    }
    assert.ok(pairLines(a.join("\n"), a.join("\n")).every((pair) => pair.base === pair.other));
  }
});

test("a hundred thousand lines with one line more are paired, and that line alone is new", () => {
  const lines = Array.from({ length: 100_000 }, (_, i) => `G1 X${i % 977} Y${i % 313}`);
  const other = [...lines.slice(0, 40_000), "G1 Z5", ...lines.slice(40_000)];
  const pairs = pairLines(lines.join("\n"), other.join("\n"));
  assert.deepEqual(pairs.map(spans).filter(([base, other]) => base === "" || other === ""), [["", "40001"]]);
});

test("without the programs' texts lines of one number are one", () => {
  const rows = lineRows(ran([cut(4, 10)]), ran([cut(9, 20)], "G1 X1\n"));
  assert.deepEqual(rows.map((row) => [row.base, row.other, row.base_s, row.other_s]), [[4, 4, 0.01, 0], [9, 9, 0, 0.02]]);
});

test("a difference has its sign and its share of the base", () => {
  assert.equal(difference(10, 9.5), "\u22120.500 s, 5.00\u00a0%");
  assert.equal(difference(10, 70), "+1:00.00, 600\u00a0%");
  assert.equal(difference(0, 2), "+2.000 s");
  assert.equal(difference(3, 3), "");
});
