// When a chart asks for the ticks of its part, and when it has them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { RunKind, type Plan } from "../src/plan/plan.ts";
import type { Part } from "../src/plan/source.ts";
import { Finer } from "../src/views/finer.ts";
import { planOf } from "./helper.ts";

const TICKS = 4_000_000;
const LONG_MS = 400; // by then it has asked
const BUSY_MS = 1200; // by then once more

function longPlan(): Plan {
  const plan = planOf([{ ticks: 4, line: 1, kind: RunKind.cut }]);
  Object.assign(plan.motion!, { ticksPerColumn: 4, columns: TICKS / 4, lastTick: TICKS - 1 });
  return plan;
}

function planOfPart({ first, last }: Part): Plan {
  const plan = planOf([{ ticks: 4, line: 1, kind: RunKind.cut }]);
  Object.assign(plan.motion!, { firstTick: first, ticksPerColumn: 1, columns: last - first + 1, lastTick: last });
  return plan;
}

// Answers each time when it is told to.
class Kernel {
  readonly asked: Part[] = [];
  readonly answers: ((plan: Plan | null) => void)[] = [];
  readonly refusals: ((why: Error) => void)[] = [];
  readonly partOf = (_plan: Plan, part: Part): Promise<Plan | null> => {
    this.asked.push(part);
    return new Promise((resolve, reject) => {
      this.answers.push(resolve);
      this.refusals.push(reject);
    });
  };
}

const passed = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

function looked(plan: Plan): { finer: Finer; kernel: Kernel; changes: () => number } {
  let changes = 0;
  const finer = new Finer(() => ++changes);
  const kernel = new Kernel();
  finer.show(plan, kernel.partOf);
  return { finer, kernel, changes: () => changes };
}

test("a chart whose pixels are wider than columns asks for nothing", async () => {
  const { finer, kernel } = looked(longPlan());
  finer.see({ from: 0, to: 4001 }, 1000);
  await passed(LONG_MS);
  assert.deepEqual(kernel.asked, []);
});

test("a plan whose columns are ticks, or that nobody plans, has no finer ones", async () => {
  const { finer, kernel } = looked(planOf([{ ticks: 100, line: 1, kind: RunKind.cut }]));
  assert.equal(finer.canAsk, false);
  finer.see({ from: 0, to: 10 }, 1000);
  const report = new Finer(() => undefined);
  report.show(longPlan(), null);
  assert.equal(report.canAsk, false);
  report.see({ from: 0, to: 10 }, 1000);
  await passed(LONG_MS);
  assert.deepEqual(kernel.asked, []);
});

test("the last of several spans is asked for, and seen where it reaches", async () => {
  const plan = longPlan();
  const { finer, kernel, changes } = looked(plan);
  finer.see({ from: 1_000_000, to: 1_003_000 }, 1000);
  finer.see({ from: 1_000_000, to: 1_000_100 }, 1000);
  await passed(LONG_MS);
  assert.deepEqual(kernel.asked, [{ first: 950_000, last: 1_050_100 }]);
  assert.equal(finer.within({ from: 1_050_000, to: 1_050_101 }), "coming");
  assert.equal(finer.within({ from: 0, to: TICKS - 1 }), "nearer");
  assert.equal(finer.in({ from: 1_000_000, to: 1_000_100 }), plan);
  finer.see({ from: 1_000_100, to: 1_000_200 }, 1000);
  await passed(LONG_MS);
  assert.equal(kernel.asked.length, 1, "it is on its way already");
  const part = planOfPart(kernel.asked[0]!);
  kernel.answers[0]!(part);
  await passed(0);
  assert.equal(finer.within({ from: 1_000_000, to: 1_000_100 }), "seen");
  assert.equal(changes(), 2);
  for (const [from, to, isPart] of [
    [950_000, 950_001, true],
    [1_050_000, 1_050_101, true],
    [949_999, 950_001, false],
    [1_050_000, 1_050_102, false],
  ] as const) {
    assert.equal(finer.in({ from, to }), isPart ? part : plan, `${from} to ${to}`);
  }
  finer.see({ from: 1_020_000, to: 1_020_100 }, 1000);
  await passed(LONG_MS);
  assert.equal(kernel.asked.length, 1, "it is there already");
});

test("a part at either end of the run is within it", async () => {
  const { finer, kernel } = looked(longPlan());
  finer.see({ from: 0, to: 8 }, 1000);
  await passed(LONG_MS);
  finer.see({ from: TICKS - 9, to: TICKS - 1 }, 1000);
  await passed(LONG_MS);
  assert.deepEqual(kernel.asked, [
    { first: 0, last: 50_008 },
    { first: TICKS - 50_009, last: TICKS - 1 },
  ]);
});

test("an answer to an older question, or to one about another plan, is not taken", async () => {
  const { finer, kernel } = looked(longPlan());
  finer.see({ from: 0, to: 8 }, 1000);
  await passed(LONG_MS);
  finer.see({ from: 500_000, to: 500_008 }, 1000);
  await passed(LONG_MS);
  kernel.answers[0]!(planOfPart(kernel.asked[0]!));
  await passed(0);
  assert.equal(finer.within({ from: 500_000, to: 500_008 }), "coming");
  const other = longPlan();
  finer.show(other, kernel.partOf);
  kernel.answers[1]!(planOfPart(kernel.asked[1]!));
  await passed(0);
  assert.equal(finer.in({ from: 0, to: 8 }), other);
  assert.equal(finer.in({ from: 500_000, to: 500_008 }), other);
});

test("a kernel that has something else to do is asked again", async () => {
  const { finer, kernel } = looked(longPlan());
  const span = { from: 0, to: 8 };
  finer.see(span, 1000);
  await passed(LONG_MS);
  kernel.answers[0]!(null);
  await passed(0);
  assert.equal(finer.within(span), "coming");
  finer.see(span, 1000);
  await passed(BUSY_MS);
  assert.equal(kernel.asked.length, 2);
  kernel.answers[1]!(planOfPart(kernel.asked[1]!));
  await passed(0);
  assert.equal(finer.within(span), "seen");
});

test("what is refused is told, and not asked for again", async () => {
  const { finer, kernel } = looked(longPlan());
  finer.see({ from: 0, to: 8 }, 1000);
  await passed(LONG_MS);
  kernel.refusals[0]!(new Error("too little memory"));
  await passed(0);
  assert.equal(finer.within({ from: 0, to: 8 }), "refused");
  finer.see({ from: 10, to: 18 }, 1000);
  await passed(BUSY_MS);
  assert.equal(kernel.asked.length, 1);
  finer.see({ from: 3_000_000, to: 3_000_008 }, 1000);
  await passed(LONG_MS);
  assert.equal(kernel.asked.length, 2, "another part may be planned");
});
