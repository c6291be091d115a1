// The data of a report, tick by tick beside the trace that kerf writes of the same program.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inflateSync } from "node:zlib";
import { accountOf } from "../src/plan/account.ts";
import { decodePlan } from "../src/plan/decode.ts";
import { Plan } from "../src/plan/plan.ts";
import { SOURCE, kerf, makeReport, programFile, traceOf } from "./report.ts";

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

// How far a place is from a square of 20 mm whose lower left corner is the zero.
function fromSquare([x, y]: readonly number[]): number {
  const out = Math.hypot(Math.max(0, -x!, x! - 20), Math.max(0, -y!, y! - 20));
  return out > 0 ? out : Math.min(x!, 20 - x!, y!, 20 - y!);
}

test("the deviation of each tick bounds how far the tool is from the program, and is none on what is kept", () => {
  const program = programFile("G21 G90 G64 P0.1 Q0 F3000\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM2\n");
  const plan = planIn(makeReport([program]));
  const { deviation } = JSON.parse(kerf("dry-run", "--json", program).out);
  const trace = traceOf(program);
  const values = trace.map((_, tick) => plan.valueAt("deviation", tick).max);
  trace.forEach(({ xyz }, tick) => {
    const off = fromSquare(xyz);
    assert.ok(off <= values[tick]! + 2e-6, `tick ${tick}: ${off} mm off, said ${values[tick]}`);
    // Ten millimetres from each corner nothing is rounded.
    if (Math.abs(xyz[0]! - 10) < 1 || Math.abs(xyz[1]! - 10) < 1) assert.equal(values[tick], 0);
  });
  assert.ok(Math.abs(Math.max(...values) - deviation.max_mm) <= 1e-6 * deviation.max_mm + 1e-9);
  assert.ok(deviation.max_mm > 0.05 && deviation.max_mm <= 0.1);
  // Three corners are rounded: three times it begins.
  assert.equal(values.filter((value, tick) => value > 0 && !(values[tick - 1]! > 0)).length, 3);
});

test("the path of a program that leaves the travel is there, with its corners", () => {
  const plan = planIn(makeReport([programFile("G21 G90 G61 F6000\nG0 X-100\nG1 X520 Y30\nG1 X400 Y-20\nM30\n")]));
  assert.equal(plan.motion, null);
  const { xyz, tick, rapid } = plan.path!;
  const corners = [...tick].map((_, i) => [xyz[0][i], xyz[1][i], xyz[2][i]]);
  assert.deepEqual(corners, [[0, 0, 0], [-100, 0, 0], [520, 30, 0], [400, -20, 0]]);
  assert.deepEqual([...rapid].slice(1), [1, 0, 0]);
  const length_mm = 100 + Math.hypot(620, 30) + Math.hypot(120, 50);
  assert.ok(Math.abs(tick[3]! * 1e-6 - length_mm) < 1e-5);
});

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
