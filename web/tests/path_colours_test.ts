// What colour a stretch of the path has, and where the scale ends.
import assert from "node:assert/strict";
import { test } from "node:test";
import { RunKind } from "../src/plan/plan.ts";
import { Pyramid } from "../src/plan/pyramid.ts";
import { colouringOf, innerColumns } from "../src/views/path_colours.ts";
import { planOf } from "./helper.ts";

test("a long stretch is coloured by what is between its ends, a short one by all of it", () => {
  assert.deepEqual(innerColumns(26, 10002), [90, 9938]);
  assert.deepEqual(innerColumns(100, 140), [110, 130]);
  assert.deepEqual(innerColumns(7, 10), [7, 10]);
});

test("a stretch is coloured by the feed that it has on the average: a short ramp at its end is not half of it", () => {
  const feed = [...Array.from({ length: 1000 }, () => 50), ...Array.from({ length: 20 }, (_, i) => 50 - 2.5 * (i + 1))];
  const plan = planOf([{ ticks: 1020, line: 1, kind: RunKind.cut }], null, { "path.v": feed });
  const colouring = colouringOf(plan, plan.path!, "feed", { rgb: [1, 1, 1], dark: false });
  assert.equal(colouring.legend.kind === "scale" && colouring.legend.most, 50);
  const mean = (from: number, to: number): number => feed.slice(from, to).reduce((sum, one) => sum + one, 0) / (to - from) / 50;
  for (const [from, to] of [[0, 1020], [0, 1000], [1000, 1020], [990, 1010], [1019, 1020]] as const) {
    assert.ok(Math.abs(colouring.valueOf(from, to) - mean(from, to)) < 1e-6, `${from} to ${to}: ${colouring.valueOf(from, to)}`);
  }
});

test("the scale of feeds ends at the largest feed that is no rapid's, also where a column has some ticks of both", () => {
  const ticksPerColumn = 4;
  for (const [cut, count] of [["of some columns", 17], ["within a column", 1]] as const) {
    const feed = [10, count, 10].flatMap((ticks, part) => Array.from({ length: ticks }, () => (part === 1 ? 20 : 250)));
    const plan = planOf([{ ticks: 10, line: 1, kind: RunKind.rapid }, { ticks: count, line: 2, kind: RunKind.cut }, { ticks: 10, line: 3, kind: RunKind.rapid }]);
    const { path } = plan.motion!;
    path.rapid.set([0, 1, 0, 1]); // of the way to each point
    path.xyz[0].set([0, 2.5, 2.5 + 0.02 * count, 5 + 0.02 * count]);
    const columns = Math.ceil(feed.length / ticksPerColumn);
    const of = (end: (...values: number[]) => number): Float32Array => Float32Array.from({ length: columns }, (_, i) => end(...feed.slice(i * ticksPerColumn, (i + 1) * ticksPerColumn)));
    Object.assign(plan.motion!, { ticksPerColumn, columns });
    const series = new Pyramid(of(Math.min), of(Math.max));
    plan.series = () => series;
    const { legend } = colouringOf(plan, path, "feed", { rgb: [1, 1, 1], dark: false });
    assert.ok(legend.kind === "scale" && Math.abs(legend.most - 20) < 1e-6, `a cut ${cut}: ${legend.kind === "scale" && legend.most}`);
  }
});
