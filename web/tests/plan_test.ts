import assert from "node:assert/strict";
import { test } from "node:test";
import { accountOf, fitsOf } from "../src/plan/account.ts";
import { ByLine } from "../src/plan/by_line.ts";
import { decodePlan, unpackNumbers } from "../src/plan/decode.ts";
import { Plan, RunKind, lastAtOrBefore, type Path } from "../src/plan/plan.ts";
import { Pyramid } from "../src/plan/pyramid.ts";
import { operationsOf, splitOf, toolsOf } from "../src/plan/split.ts";
import { cutAtTravel } from "../src/plan/cut_path.ts";
import { drawnColumns, drawnLimits, finenessText } from "../src/views/columns.ts";
import { pointingOf, tickNear, type Pointing } from "../src/views/pick.ts";
import { numbersOf, planOf } from "./helper.ts";

// 0, 1, -1, 64, then back to 0: steps 0, 1, -2, 65, -64 as zigzag 0, 2, 3, 130 (two bytes), 127.
test("numbers are packed as differences of seven bits a byte", () => {
  const bytes = Uint8Array.from([0, 2, 3, 0x82, 0x01, 127]);
  assert.deepEqual([...unpackNumbers(bytes, 5, 0.5)], [0, 0.5, -0.5, 32, 0]);
  assert.throws(() => unpackNumbers(bytes.subarray(0, 4), 5, 1), /end early/);
});

test("numbers beyond 32 bits keep every bit", () => {
  // 2^40 as zigzag is 2^41: five bytes of nothing and 2^41 / 2^35 = 64.
  assert.deepEqual([...unpackNumbers(Uint8Array.from([0x80, 0x80, 0x80, 0x80, 0x80, 64]), 1, 1)], [2 ** 40]);
});

function made(magic: string, header: object, data: number[] = []): Uint8Array {
  const text = new TextEncoder().encode(JSON.stringify(header));
  return Uint8Array.from([...new TextEncoder().encode(magic), text.length & 255, text.length >> 8, 0, 0, ...text, ...data]);
}

test("what is no plan, or of another version, is refused", () => {
  assert.throws(() => decodePlan(made("KERFPLAY", {})), /no plan/);
  assert.throws(() => decodePlan(made("KERFPLAN", { version: 99, sections: [] })), /version 99/);
  assert.throws(() => decodePlan(made("KERFPLAN", { version: 2, sections: [{ name: "x", coding: "bytes", count: 5, bytes: 5 }] })), /ends early/);
  assert.equal(decodePlan(made("KERFPLAN", { version: 2, sections: [] })).header.version, 2);
});

test("a section of numbers is unpacked when it is asked for, and only then does it end early", () => {
  const section = (name: string, count: number): object => ({ name, coding: "differences", unit: 0.5, count, bytes: 2 });
  const { numbers } = decodePlan(made("KERFPLAN", { version: 2, sections: [section("whole", 2), section("short", 3)] }, [2, 4, 2, 4]));
  assert.deepEqual([...numbers.keys()], ["whole", "short"]);
  assert.deepEqual([...numbers.get("whole")!], [0.5, 1.5]);
  assert.equal(numbers.get("whole"), numbers.get("whole"));
  assert.throws(() => numbers.get("short"), /end early/);
  assert.equal(numbers.get("none"), undefined);
});

test("the text of a long program is made when it is asked for, at once or in steps", () => {
  const sections = [{ name: "source.text", coding: "bytes", count: 5, bytes: 5 }, { name: "source.X1", coding: "differences", count: 2, bytes: 2 }];
  const planOfText = (lineEnd = 0x0d): { plan: Plan; asked: string[] } => {
    const decoded = decodePlan(made("KERFPLAN", { version: 2, sections }, [0x58, 2, lineEnd, 0x58, 2, 30, 5])); // X 1.5, X 1.2
    const asked: string[] = [];
    const numbers = { has: (name: string) => decoded.numbers.has(name), keys: () => decoded.numbers.keys(), get: (name: string) => (asked.push(name), decoded.numbers.get(name)) };
    return { plan: new Plan({ ...decoded, numbers }), asked };
  };
  const { plan, asked } = planOfText();
  assert.ok(plan.hasSource && asked.length === 0);
  assert.equal(plan.source, "X1.5\nX1.2");
  assert.deepEqual(asked, ["source.X1"]);
  const begun = planOfText().plan;
  assert.equal(begun.sourceSteps.next().done, false);
  assert.equal(begun.source, "X1.5\nX1.2");
  assert.equal(begun.sourceSteps.next().done, true);
  assert.deepEqual([...planOfText(0x0a).plan.sourceSteps], ["", "X1.5"]); // its whole lines
});

test("a pyramid finds minimum and maximum of every range as a look at all values does", () => {
  let seed = 7;
  const random = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (const size of [1, 3, 4, 5, 64, 257, 1000]) {
    const low = Float32Array.from({ length: size }, random);
    const high = low.map((value) => value + random());
    const pyramid = new Pyramid(low, high);
    for (let trial = 0; trial < 200; ++trial) {
      const from = Math.floor(random() * size);
      const to = from + 1 + Math.floor(random() * (size - from));
      assert.deepEqual(pyramid.range(from, to), { min: Math.min(...low.subarray(from, to)), max: Math.max(...high.subarray(from, to)) }, `${from} to ${to} of ${size}`);
    }
    assert.deepEqual(pyramid.range(-5, size + 5), { min: Math.min(...low), max: Math.max(...high) });
    assert.ok(Number.isNaN(pyramid.range(size, size + 1).max));
  }
});

test("the last value at or before another is found", () => {
  const values = Float64Array.from([0, 3, 3, 10]);
  assert.deepEqual([-1, 0, 2, 3, 9, 10, 99].map((value) => lastAtOrBefore(values, value)), [-1, 0, 0, 2, 2, 3, 3]);
});

test("a line has the time of all its runs, and begins with the first", () => {
  const account = accountOf(
    planOf([
      { ticks: 10, line: 1, kind: RunKind.rapid },
      { ticks: 501, line: 2, kind: RunKind.rest },
      { ticks: 70, line: 3, kind: RunKind.cut },
      { ticks: 30, line: 4, kind: RunKind.rest },
      { ticks: 5, line: 3, kind: RunKind.cut },
    ]),
  );
  assert.deepEqual(numbersOf(account.lines), [[1, 10], [2, 501], [3, 75], [4, 30]]);
  assert.equal(account.firstTick.get(3), 511);
});

test("time is split as the report has it, without parts that take none", () => {
  const [rough, idle] = [{ cutting_s: 3, rapid_s: 1, rest_s: 0.5, tool_change_s: 2 }, { cutting_s: 0, rapid_s: 0, rest_s: 0, tool_change_s: 0 }];
  const { report } = planOf([], null, {}, {
    time_split: rough,
    time_by_tool: [{ tool: "no tool", ...idle }, { tool: "T4", ...rough }],
    time_by_operation: [{ operation: "rough", ...rough }, { operation: "nothing moves here", ...idle }],
  }).header;
  const split = { cut: 3, rapid: 1, rest: 0.5, toolChange: 2 };
  assert.deepEqual(splitOf(report), split);
  assert.deepEqual(toolsOf(report), [{ name: "T4", split }]);
  assert.deepEqual(operationsOf(report), [{ name: "rough", split }]);
});

test("a line without a number has none, and 0 is one", () => {
  const lines = new ByLine(4);
  lines.set(3, 0);
  lines.set(1, 7.5);
  assert.deepEqual([-1, 0, 1, 2, 3, 4, 5].map((line) => lines.get(line)), [undefined, undefined, 7.5, undefined, 0, undefined, undefined]);
  assert.deepEqual(numbersOf(lines), [[1, 7.5], [3, 0]]);
});

// What kerf makes of each: tests/parser/text/line_splitter_test.cpp.
test("a text has one line end for each that kerf counts, whatever it is made of", () => {
  const linesOf = (text: string): string[] => planOf([], text).source!.split("\n");
  assert.deepEqual(linesOf("a\nb\n\nc"), ["a", "b", "", "c"]);
  assert.deepEqual(linesOf("a\rb\r\rc\r"), ["a", "b", "", "c", ""]);
  assert.deepEqual(linesOf("a\r\nb\r\n\r\nc\r\n"), ["a", "b", "", "c", ""]);
  assert.deepEqual(linesOf("a\n\rb\n\r\n\rc\n\r"), ["a", "b", "", "c", ""]);
  assert.deepEqual(linesOf("a\r\nb\n\rc\rd"), ["a", "b", "c", "d"]);
  assert.deepEqual(linesOf("a\n\r\nb"), ["a", "", "b"]);
  assert.deepEqual(linesOf("a\n\r\r\rb"), ["a", "b"]);
});

test("the box of the program stands beside the travel, with what the report says of them", () => {
  const plan = planOf([{ ticks: 1, line: 1, kind: RunKind.cut }]);
  assert.deepEqual(fitsOf(plan)[0], { axis: "x", min: 0, max: 50, travel: [-100, 300], over: 0 });
  Object.assign(plan.header.report, { fit: { axes: { y: { over_mm: 12 } }, work_offsets: [] } });
  assert.deepEqual(fitsOf(plan).map((fit) => fit.over), [0, 12, 0]);
});

test("between two points of the path the tool goes evenly", () => {
  const plan = planOf([
    { ticks: 10, line: 1, kind: RunKind.cut },
    { ticks: 4, line: 2, kind: RunKind.rest },
  ]);
  assert.deepEqual(plan.positionAt(2.5), [2.5, 0, 0]);
  assert.deepEqual(plan.positionAt(12), [10, 0, 0]);
  assert.deepEqual(plan.positionAt(99), [10, 0, 0]);
});

test("a chart has every peak at any width", () => {
  const plan = planOf([{ ticks: 1000, line: 1, kind: RunKind.cut }]);
  const values = new Float32Array(1000);
  values[637] = 5;
  values[638] = -3;
  plan.series = () => new Pyramid(values, values);
  for (const pixels of [1, 7, 100, 640, 2000]) {
    const drawn = drawnColumns(plan, "path.v", { from: 0, to: 1000 }, pixels);
    assert.equal(Math.max(...drawn.max), 5, `${pixels} pixels`);
    assert.equal(Math.min(...drawn.min), -3, `${pixels} pixels`);
    assert.ok(drawn.tick.length <= Math.min(pixels, 1000));
  }
  const near = drawnColumns(plan, "path.v", { from: 630, to: 640 }, 500);
  assert.deepEqual([...near.tick], [630, 631, 632, 633, 634, 635, 636, 637, 638, 639, 640]);
  assert.equal(near.max[7], 5);
});

test("a column of several ticks has its values from its begin to its end in a chart that is near", () => {
  const plan = planOf([{ ticks: 1000, line: 1, kind: RunKind.cut }]);
  Object.assign(plan.motion!, { ticksPerColumn: 4, columns: 250 });
  const series = new Pyramid(Float32Array.from({ length: 250 }, (_, i) => i % 3), Float32Array.from({ length: 250 }, (_, i) => 5 + (i % 7)));
  plan.series = () => series;
  const near = drawnColumns(plan, "path.v", { from: 630, to: 640 }, 500);
  assert.deepEqual([...near.tick], [628, 632, 632, 636, 636, 640, 640, 644]);
  near.tick.forEach((tick, i) => {
    const { min, max } = plan.valueAt("path.v", i % 2 === 0 ? tick : tick - 1);
    assert.deepEqual([near.min[i], near.max[i]], [min, max], `tick ${tick}`);
  });
  assert.equal(drawnColumns(plan, "path.v", { from: 0, to: 1000 }, 100).tick.length, 100, "from afar one point a pixel");
});

test("columns that begin later stand where their ticks are", () => {
  const plan = planOf([{ ticks: 100, line: 1, kind: RunKind.cut }], null, { "path.v": Array.from({ length: 100 }, (_, i) => i) });
  Object.assign(plan.motion!, { firstTick: 5000 });
  plan.motion!.limit.fill(1, 0, 50).fill(2, 50);
  const near = drawnColumns(plan, "path.v", { from: 5010, to: 5013 }, 500);
  assert.deepEqual([[...near.tick], [...near.max]], [[5010, 5011, 5012, 5013], [10, 11, 12, 13]]);
  assert.deepEqual([...drawnLimits(plan, { from: 5040, to: 5060 }, 4)], [1, 1, 2, 2]);
  assert.deepEqual([...drawnLimits(plan, { from: 4998, to: 5002 }, 4)], [-1, -1, 1, 1], "nothing before them");
  assert.equal(plan.valueAt("path.v", 5042).max, 42);
});

test("a path that leaves the travel has points where it does", () => {
  const axes = [[-500, 500], [null, 10], [0, 0]].map((travel, k) => ({ name: "xyz"[k]!, unit: "mm" as const, limits: { v: null, a: null, j: null }, travel: travel as [number | null, number | null] }));
  const of = (...values: number[]): Float64Array => Float64Array.from(values);
  const straight = { tick: of(0, 5000), xyz: [of(0, -5000), of(0, 0), of(0, 0)], rapid: Uint8Array.of(0, 1) } as const;
  const cut = cutAtTravel(straight, axes);
  assert.deepEqual([...cut.tick], [0, 500, 5000]);
  assert.deepEqual(cut.xyz.map((values) => [...values]), [[0, -500, -5000], [0, 0, 0], [0, 0, 0]]);
  assert.deepEqual([...cut.rapid], [0, 1, 1]);
  const across = { tick: of(0, 4000), xyz: [of(-1000, 1000), of(0, 20), of(0, 0)], rapid: Uint8Array.of(0, 0) } as const;
  assert.deepEqual([...cutAtTravel(across, axes).xyz[0]], [-1000, -500, 0, 500, 1000], "both ends of X, and Y where X is 0");
  const within = { tick: of(0, 10, 20), xyz: [of(0, 500, 400), of(10, 0, 10), of(0, 0, 0)], rapid: Uint8Array.of(0, 0, 0) } as const;
  assert.equal(cutAtTravel(within, axes), within, "up to the ends of it");
});

test("what of a long run is not known to the tick is told", () => {
  const plan = planOf([{ ticks: 1000, line: 1, kind: RunKind.cut }]);
  assert.equal(finenessText(plan), "");
  Object.assign(plan.motion!, { ticksPerColumn: 4 });
  assert.equal(finenessText(plan), "The finest level here is 4 ticks (0.00400 s) a column; minimum and maximum are kept.");
  assert.equal(finenessText(plan, "nearer"), "A column is 4 ticks (0.00400 s) here, with their minimum and maximum: zoom in to see each tick.");
  assert.equal(finenessText(plan, "seen"), "Each tick is shown here.");
  Object.assign(plan.header, { shortest_run_ticks: 2 });
  assert.match(finenessText(plan), /are kept\. Runs of fewer than 2 ticks may be joined with those before them: times of lines, tools and operations are rough\.$/);
});

test("the band shows what limits most of the time after a pixel", () => {
  const plan = planOf([{ ticks: 12, line: 1, kind: RunKind.cut }]);
  plan.motion!.limit.set([1, 1, 2, 2, 2, 1, 3, 3, 3, 4, 4, 4]);
  assert.deepEqual([...drawnLimits(plan, { from: 0, to: 12 }, 4)], [1, 2, 3, 4]);
  assert.deepEqual([...drawnLimits(plan, { from: 10, to: 14 }, 4)], [4, 4, -1, -1], "nothing after the end");
});

test("the instant at a place of the view is that of the nearest stretch, in pixels", () => {
  const plan = planOf([
    { ticks: 100, line: 1, kind: RunKind.cut },
    { ticks: 50, line: 2, kind: RunKind.rest },
    { ticks: 100, line: 3, kind: RunKind.cut },
  ]);
  // X 0 to 200 mm over a view of 400 by 200 pixels: 2 pixels a millimetre, x = 0 in the middle.
  const projection = [2 / 200, 0, 0, 0, 0, 2 / 100, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const at = (x: number, y: number): number | null => tickNear(plan.motion!.path, pointingOf(projection, { width: 400, height: 200 }, { x, y }), 12);
  assert.equal(at(200 + 2 * 30, 100), 30);
  assert.equal(at(200 + 2 * 30, 109), 30, "9 pixels below it");
  assert.equal(at(200 + 2 * 30, 113), null, "13 pixels below it");
  assert.equal(at(200 + 2 * 150, 100), 200, "after the rest of 50 ticks");
});

test("the instant at a place of a long path is the one that a look at each of its ways finds", () => {
  const points = 5000;
  let seed = 7;
  const random = (): number => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const axis = (): Float64Array => Float64Array.from({ length: points }, () => 100 * random());
  const path: Path = { tick: Float64Array.from({ length: points }, (_, i) => 3 * i), xyz: [axis(), axis(), axis()], rapid: new Uint8Array(points) };
  const [xs, ys, zs] = path.xyz;
  for (let k = 0; k < 50; ++k) {
    const pointing: Pointing = { u: [-60 * random(), 1, 0.2, 0.1], v: [-60 * random(), -0.1, 1, 0.3] };
    const seen = (i: number): [number, number] => [
      pointing.u[0] + pointing.u[1] * xs[i]! + pointing.u[2] * ys[i]! + pointing.u[3] * zs[i]!,
      pointing.v[0] + pointing.v[1] * xs[i]! + pointing.v[2] * ys[i]! + pointing.v[3] * zs[i]!,
    ];
    let nearest = Infinity;
    let tick = -1;
    for (let i = 1; i < points; ++i) {
      const [[u, v], [u1, v1]] = [seen(i - 1), seen(i)];
      const [du, dv] = [u1 - u, v1 - v];
      const share = Math.min(1, Math.max(0, -(u * du + v * dv) / (du * du + dv * dv)));
      const away = Math.hypot(u + share * du, v + share * dv);
      if (away < nearest) [nearest, tick] = [away, Math.floor(3 * (i - 1 + share))];
    }
    assert.equal(tickNear(path, pointing, 1000), tick);
    assert.equal(tickNear(path, pointing, 0.5 * nearest), null);
  }
});
