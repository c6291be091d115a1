// The data of a report, tick by tick beside the trace that kerf writes of the same program.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { deflateSync, inflateSync } from "node:zlib";
import { accountOf } from "../src/plan/account.ts";
import { decodePlan, type Decoded } from "../src/plan/decode.ts";
import { Plan } from "../src/plan/plan.ts";
import { sourceIn } from "../src/plan/source_text.ts";
import { numbersOf } from "./helper.ts";
import { SOURCE, kerf, makeReport, programFile, traceOf } from "./report.ts";

function decodedIn(file: string): Decoded {
  const [, text] = /<script type="application\/x-kerf-plan">([^<]*)<\/script>/.exec(readFileSync(file, "utf8"))!;
  return decodePlan(inflateSync(Buffer.from(text!, "base64")));
}

const planIn = (file: string): Plan => new Plan(decodedIn(file));

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
    assert.deepEqual(new Map(numbersOf(accountOf(plan).lines)), new Map([...ticks].sort((a, b) => a[0] - b[0])), "what each line takes");
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
    assert.ok(off <= values[tick]! + 1e-6, `tick ${tick}: ${off} mm off, said ${values[tick]}`); // the trace is rounded
    // Far from the corners nothing is rounded.
    if (Math.abs(xyz[0]! - 10) < 1 || Math.abs(xyz[1]! - 10) < 1) assert.equal(values[tick], 0);
  });
  assert.ok(Math.abs(Math.max(...values) - deviation.max_mm) <= 1e-6 * deviation.max_mm + 1e-9);
  assert.ok(deviation.max_mm > 0.05 && deviation.max_mm <= 0.1);
  // Three corners are rounded: three times it begins.
  assert.equal(values.filter((value, tick) => value > 0 && !(values[tick - 1]! > 0)).length, 3);
});

test("of short lines that become curves no tick is farther from them than is said", () => {
  const corners = Array.from({ length: 400 }, (_, i) => [0.5 * i, 3 * Math.sin(i / 15)] as const);
  const program = programFile(`G21 G90 G64 P0.02 Q0.02 F3000\n${corners.map(([x, y]) => `G1 X${x.toFixed(3)} Y${y.toFixed(3)}`).join("\n")}\nM2\n`);
  const plan = planIn(makeReport([program]));
  const points = corners.map(([x, y]) => [Number(x.toFixed(3)), Number(y.toFixed(3))] as const);
  const away = ([x, y]: readonly number[]): number => {
    let least = Infinity;
    for (let i = 1; i < points.length; ++i) {
      const [[ax, ay], [bx, by]] = [points[i - 1]!, points[i]!];
      const share = Math.min(1, Math.max(0, ((x! - ax) * (bx - ax) + (y! - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)));
      least = Math.min(least, Math.hypot(x! - ax - share * (bx - ax), y! - ay - share * (by - ay)));
    }
    return least;
  };
  let most = 0;
  traceOf(program).forEach(({ xyz }, tick) => {
    const off = away(xyz);
    most = Math.max(most, off);
    assert.ok(off <= plan.valueAt("deviation", tick).max + 1e-6, `tick ${tick}: ${off} mm off, said ${plan.valueAt("deviation", tick).max}`);
  });
  assert.ok(most > 1e-3, "lines have become curves");
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

test("the path of a program that leaves the travel is there, with its corners and where it leaves", () => {
  const plan = planIn(makeReport([programFile("G21 G90 G61 F6000\nG0 X-100\nG1 X520 Y30\nG1 X400 Y-20\nM30\n")]));
  assert.equal(plan.motion, null);
  const { xyz, tick, rapid } = plan.path!;
  const corners = [...tick].map((_, i) => [xyz[0][i], xyz[1][i], xyz[2][i]]);
  // X ends at 500: 600 of 620 mm on the way out, 20 of 120 mm on the way back.
  const wanted = [[0, 0, 0], [-100, 0, 0], [500, (30 * 600) / 620, 0], [520, 30, 0], [500, 30 - (50 * 20) / 120, 0], [400, -20, 0]];
  assert.equal(corners.length, wanted.length);
  wanted.forEach((corner, i) => corner.forEach((mm, k) => assert.ok(Math.abs(corners[i]![k]! - mm) < 1e-9, `corner ${i}`)));
  assert.deepEqual([...rapid].slice(1), [1, 0, 0, 0, 0]);
  const length_mm = 100 + Math.hypot(620, 30) + Math.hypot(120, 50);
  assert.ok(Math.abs(tick[5]! * 1e-6 - length_mm) < 1e-5);
});

function textIn(decoded: Decoded): Uint8Array {
  const steps = sourceIn(decoded);
  for (let step = steps.next(); ; step = steps.next()) if (step.done) return step.value;
}

test("the text of a long program is the one that was read, to the byte", () => {
  const odd = ["X01 Y.5 Z-0.00", "X1. y-7. z+3", "(at X1.5, \u00b0 and \u4e16)", "X123456789012345678 Y0.123456789", "G1X-0.0005Y12.50 \t", "X12345678.12345678 X-999999.999999999", "#1=5 X#1 X[1.5+2] N00", "\u0000 X5"];
  const lines = Array.from({ length: 6000 }, (_, i) => `N${10 * i} G1 X${(100 * Math.sin(i)).toFixed(i % 8)} Y${-i / 8} ${odd[i % 50] ?? ""}\r`);
  for (const text of [lines.join("\n"), `${lines.join("\n")} (\u0003)`]) {
    const program = programFile(text);
    assert.ok(readFileSync(program).equals(textIn(decodedIn(makeReport([program])))));
  }
});

for (const [name, end] of Object.entries({ LF: "\n", CR: "\r", CRLF: "\r\n", LFCR: "\n\r", LFCRCR: "\n\r\r", LFCRLF: "\n\r\n" })) {
  test(`a program whose lines end with ${name} has the lines that kerf counts`, () => {
    const { source, motion } = planIn(makeReport([programFile(["G21 G90 F6000", "(first)", "G1 X10", "G1 X20", "M2", ""].join(end))]));
    const lines = source!.split("\n");
    assert.deepEqual([...new Set(motion!.runs.line)].map((line) => lines[line - 1]).filter((line) => line!.startsWith("G1")), ["G1 X10", "G1 X20"]);
  });
}

test("numbers of a long program take little room", () => {
  const lines = Array.from({ length: 20_000 }, (_, i) => `N${10 * i} G1 X${(80 * Math.cos(i / 9) + i / 1e3).toFixed(4)} Y${(60 * Math.sin(i / 7)).toFixed(4)}`);
  const text = lines.join("\n");
  const made = readFileSync(makeReport([programFile(`M100\n${text}\n`)]), "utf8"); // an error: nothing but the text is in it
  const [, packed] = /<script type="application\/x-kerf-plan">([^<]*)<\/script>/.exec(made)!;
  const plain = deflateSync(text).length;
  assert.ok(packed!.length * 0.75 < 0.75 * plain, `${packed!.length * 0.75} bytes, as text ${plain}`);
});
