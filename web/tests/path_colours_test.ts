// What colour a stretch of the path has, and where the scale ends.
import assert from "node:assert/strict";
import { test } from "node:test";
import { RunKind, type Plan } from "../src/plan/plan.ts";
import { Pyramid } from "../src/plan/pyramid.ts";
import { colouringOf, innerColumns } from "../src/views/path_colours.ts";
import { planOf } from "./helper.ts";

test("a long stretch is coloured by what is between its ends, a short one by all of it", () => {
  assert.deepEqual(innerColumns(26, 10002), [90, 9938]);
  assert.deepEqual(innerColumns(100, 140), [110, 130]);
  assert.deepEqual(innerColumns(7, 10), [7, 10]);
});

const LIGHT = { rgb: [1, 1, 1], dark: false } as const;

test("a stretch is coloured by the feed that it has on the average: a short ramp at its end is not half of it", () => {
  const feed = [...Array.from({ length: 1000 }, () => 50), ...Array.from({ length: 20 }, (_, i) => 50 - 2.5 * (i + 1))];
  const plan = planOf(feed.map((_, i) => ({ ticks: 1, line: i + 1, kind: RunKind.cut })), null, { "path.v": feed });
  feed.forEach((v, i) => (plan.path!.xyz[0][i + 1] = plan.path!.xyz[0][i]! + v * plan.period_s));
  const colouring = colouringOf(plan, plan.path!, "feed", LIGHT);
  assert.equal(colouring.legend.kind === "scale" && colouring.legend.most, 50);
  const mean = (from: number, to: number): number => feed.slice(from, to).reduce((sum, one) => sum + one, 0) / (to - from) / 50;
  for (const [from, to] of [[0, 1020], [0, 1000], [1000, 1020], [990, 1010], [1019, 1020]] as const) {
    assert.ok(Math.abs(colouring.valueOf(from, to) - mean(from, to)) < 1e-6, `${from} to ${to}: ${colouring.valueOf(from, to)}`);
  }
});

// A rapid at 250 mm/s, then cuts and rapids in turn, in columns of 4 ticks.
function coarsePlan(cuts: readonly { ticks: number; feed: number }[]): Plan {
  const ways = [{ ticks: 10, feed: 250, rapid: 1 }, ...cuts.flatMap((cut) => [{ ...cut, rapid: 0 }, { ticks: 10, feed: 250, rapid: 1 }])];
  const plan = planOf(ways.map(({ ticks, rapid }, i) => ({ ticks, line: i + 1, kind: rapid === 1 ? RunKind.rapid : RunKind.cut })));
  const { path } = plan.motion!;
  ways.forEach(({ ticks, feed, rapid }, i) => {
    path.rapid[i + 1] = rapid;
    path.xyz[0][i + 1] = path.xyz[0][i]! + ticks * feed * plan.period_s;
  });
  const ticksPerColumn = 4;
  const feeds = ways.flatMap(({ ticks, feed }) => Array.from({ length: ticks }, () => feed));
  const columns = Math.ceil(feeds.length / ticksPerColumn);
  const of = (end: (...values: number[]) => number): Float32Array => Float32Array.from({ length: columns }, (_, i) => end(...feeds.slice(i * ticksPerColumn, (i + 1) * ticksPerColumn)));
  Object.assign(plan.motion!, { ticksPerColumn, columns });
  const series = new Pyramid(of(Math.min), of(Math.max));
  plan.series = () => series;
  return plan;
}

test("the scale of feeds ends at the largest feed that is no rapid's, also where a column has some ticks of both", () => {
  for (const [cut, ticks] of [["of some columns", 17], ["within a column", 1]] as const) {
    const plan = coarsePlan([{ ticks, feed: 20 }]);
    const { legend } = colouringOf(plan, plan.path!, "feed", LIGHT);
    assert.ok(legend.kind === "scale" && Math.abs(legend.most - 20) < 1e-6, `a cut ${cut}: ${legend.kind === "scale" && legend.most}`);
  }
});

test("a cut between rapids is coloured by its own feed, also where a column has some ticks of both", () => {
  const plan = coarsePlan([{ ticks: 17, feed: 20 }, { ticks: 9, feed: 5 }, { ticks: 1, feed: 10 }]);
  const colouring = colouringOf(plan, plan.path!, "feed", LIGHT);
  for (const [from, share] of [[1, 1], [3, 0.25], [5, 0.5]] as const) {
    assert.ok(Math.abs(colouring.valueOf(from, from + 1) - share) < 1e-6, `from point ${from}: ${colouring.valueOf(from, from + 1)}`);
  }
});
