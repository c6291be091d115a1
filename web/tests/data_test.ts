// The data of a report, tick by tick beside the trace that kerf writes of the same program.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inflateSync } from "node:zlib";
import { accountOf } from "../src/plan/account.ts";
import { decodePlan } from "../src/plan/decode.ts";
import { Plan } from "../src/plan/plan.ts";
import { SOURCE, makeReport, programFile, traceOf } from "./report.ts";

function planIn(file: string): Plan {
  const [, text] = /<script type="application\/x-kerf-plan">([^<]*)<\/script>/.exec(readFileSync(file, "utf8"))!;
  return new Plan(decodePlan(inflateSync(Buffer.from(text!, "base64"))));
}

for (const name of readdirSync(join(SOURCE, "programs")).filter((one) => one.endsWith(".ngc"))) {
  test(`each tick of ${name} has the line, the place, the feed and the limit of the trace`, () => {
    const program = join(SOURCE, "programs", name);
    const plan = planIn(makeReport([program]));
    const trace = traceOf(program);
    const { motion, header } = plan;
    assert.equal(motion!.ticksPerColumn, 1);
    assert.equal(motion!.lastTick, trace.length - 1);
    const tolerance_mm = header.path_tolerance_mm! + 2e-6; // and both are rounded
    const fastest = Math.max(...trace.map((row) => row.v));
    trace.forEach((row, tick) => {
      const at = plan.positionAt(tick);
      row.xyz.forEach((mm, k) => assert.ok(Math.abs(at[k]! - mm) <= tolerance_mm, `tick ${tick}: ${at[k]} mm, by the trace ${mm}`));
      assert.ok(Math.abs(plan.valueAt("path.v", tick).max - row.v) <= 1e-6 * fastest + 1e-6, `tick ${tick}: feed`);
      assert.equal(header.constraints[motion!.limit[tick]!]!.key, row.limit, `tick ${tick}: limit`);
      assert.equal(motion!.runs.line[plan.runAt(tick)], row.line, `tick ${tick}: line`);
    });
    const ticks = new Map<number, number>();
    for (const row of trace.slice(0, -1)) ticks.set(row.line, (ticks.get(row.line) ?? 0) + 1);
    assert.deepEqual(new Map([...accountOf(plan).lines].sort((a, b) => a[0] - b[0])), new Map([...ticks].sort((a, b) => a[0] - b[0])), "what each line takes");
  });
}

test("of more ticks than a report has columns each column has the smallest and largest of its ticks", () => {
  const program = programFile(`G21 G90 G61 F600\n${Array.from({ length: 40 }, (_, i) => `G1 X${i % 2 === 0 ? 80 : 0}`).join("\n")}\nM2\n`);
  const plan = planIn(makeReport([program]));
  const trace = traceOf(program);
  const { ticksPerColumn, columns } = plan.motion!;
  assert.ok(trace.length > 200_000 && ticksPerColumn === 2);
  for (let column = 0; column < columns; column += 7) {
    const rows = trace.slice(column * ticksPerColumn, (column + 1) * ticksPerColumn).map((row) => row.v);
    const { min, max } = plan.series("path.v").range(column, column + 1);
    assert.ok(min <= Math.min(...rows) + 1e-6 && min >= Math.min(...rows) - 0.01, `column ${column}`);
    assert.ok(max >= Math.max(...rows) - 1e-6 && max <= Math.max(...rows) + 0.01, `column ${column}`);
  }
});
