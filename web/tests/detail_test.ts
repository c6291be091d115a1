import assert from "node:assert/strict";
import { test } from "node:test";
import type { Path } from "../src/plan/plan.ts";
import { NOT_SEEN, chunksOf, joinsRests, levelsFor, type Sight } from "../src/views/path_detail.ts";
import { PathPaint, MOST_STRETCHES } from "../src/views/path_paint.ts";
import { boxOfCut, linesBetween, rapidWays } from "../src/views/stretches.ts";

let seed = 5;
const random = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;

// A point a tick.
function pathOf(count: number, at: (i: number) => readonly [number, number, number], isRapid: (i: number) => boolean = () => false): Path {
  const xyz = [0, 1, 2].map((k) => Float64Array.from({ length: count }, (_, i) => at(i)[k as 0 | 1 | 2])) as unknown as Path["xyz"];
  return { tick: Float64Array.from({ length: count }, (_, i) => i), xyz, rapid: Uint8Array.from({ length: count }, (_, i) => Number(isRapid(i))) };
}
const wave = (i: number): [number, number, number] => [100 * Math.cos(i / 500), 80 * Math.sin(i / 370), 0.1 * Math.sin(i / 3)];
const noise = (): [number, number, number] => [300 * random(), 200 * random(), 50 * random()];

// All of 400 by 200 mm about the zero, in a view of so many pixels a millimetre.
const whole = (pixelsPerMm: number): Sight => ({ projection: [1 / 400, 0, 0, 0, 0, 1 / 200, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], pixelsPerMm });

for (const [name, at] of [["smooth", wave], ["wild", noise]] as const) {
  test(`each level of a ${name} path reaches as far as the path, and is off by what it says`, () => {
    const path = pathOf(1100, at);
    for (const chunk of chunksOf(path)) {
      for (const { points, error_mm } of chunk.levels) {
        const [first, last] = [points[0]!, points[points.length - 1]!];
        for (const axis of path.xyz) {
          const [all, kept] = [axis.slice(first, last + 1), Float64Array.from(points, (i) => axis[i]!)];
          assert.deepEqual([Math.min(...kept), Math.max(...kept)], [Math.min(...all), Math.max(...all)]);
        }
        // Each point from the line between the kept ones about it, in steps along that line.
        for (let k = 1; k < points.length; ++k) {
          const [a, b] = [points[k - 1]!, points[k]!];
          const size = Math.hypot(...path.xyz.map((axis) => axis[b]! - axis[a]!));
          for (let i = a + 1; i < b; ++i) {
            let nearest = Infinity;
            for (let step = 0; step <= 50; ++step) nearest = Math.min(nearest, Math.hypot(...path.xyz.map((axis) => axis[a]! + (step / 50) * (axis[b]! - axis[a]!) - axis[i]!)));
            assert.ok(nearest <= error_mm + size / 100, `${nearest} mm, said ${error_mm}`);
          }
        }
      }
      assert.ok(chunk.levels.length > 2);
    }
  });
}

test("no line leads over a rest or over the end of a rapid while any other level is left", () => {
  const path = pathOf(4000, (i) => wave(i % 100 < 50 ? i - (i % 50) : i), (i) => i % 1000 < 200);
  for (const { levels } of chunksOf(path)) {
    for (const { points } of levels.filter((level) => level.keepsRests)) {
      for (let k = 1; k < points.length; ++k) {
        for (let i = points[k - 1]! + 1; i < points[k]!; ++i) {
          assert.equal(path.rapid[i], path.rapid[points[k]!], `rapids are not joined with others at ${i}`);
          const rests = (j: number): boolean => path.xyz.every((axis) => axis[j] === axis[j - 1]);
          assert.equal(rests(i), rests(i + 1), `a rest ends at ${i}`);
        }
      }
    }
  }
});

test("a view has no more stretches than it may, of any path, and none where nothing is seen", () => {
  for (const [name, path] of [
    ["smooth", pathOf(150_000, wave)],
    ["wild", pathOf(150_000, noise)],
    ["rapids at each second point", pathOf(150_000, noise, (i) => i % 2 === 0)],
  ] as const) {
    const chunks = chunksOf(path);
    for (const pixelsPerMm of [0.01, 2, 1e5]) {
      const levels = levelsFor(chunks, whole(pixelsPerMm), MOST_STRETCHES);
      const stretches = chunks.reduce((sum, chunk, i) => sum + (levels[i] === NOT_SEEN ? 0 : chunk.levels[levels[i]!]!.points.length - 1), 0);
      assert.ok(stretches > 100 && stretches <= MOST_STRETCHES, `${name}: ${stretches} stretches at ${pixelsPerMm} pixels a millimetre`);
      assert.equal(joinsRests(chunks, levels), name.startsWith("rapids"), `${name} at ${pixelsPerMm} pixels a millimetre`);
    }
    const aside = levelsFor(chunks, { projection: [1 / 400, 0, 0, 0, 0, 1 / 200, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1], pixelsPerMm: 1 }, MOST_STRETCHES);
    assert.ok(aside.every((level) => level === NOT_SEEN));
  }
});

test("what is near is drawn as it is, and what is far as nobody sees it otherwise", () => {
  const path = pathOf(50_000, wave);
  const chunks = chunksOf(path);
  const near = levelsFor(chunks, whole(1e4), MOST_STRETCHES);
  assert.ok(near.every((level) => level === 0));
  const far = levelsFor(chunks, whole(0.5), MOST_STRETCHES);
  far.forEach((level, i) => assert.ok(chunks[i]!.levels[level]!.error_mm * 0.5 <= 0.35));
  assert.ok(far.every((level) => level > 0));
});

test("on a straight line, too, each stretch is even in time to what nobody sees: ramps keep their colours", () => {
  // 300 mm: the tool speeds up for 30 ticks, goes evenly for 200, and slows down.
  const ramp = (i: number): number => (i * i) / 60;
  const at = (i: number): number => (i < 30 ? ramp(i) : i < 230 ? ramp(30) + (i - 30) : 2 * ramp(30) + 200 - ramp(260 - i));
  const even = pathOf(261, (i) => [at(i), 0, 0]);
  const keep = (axis: Float64Array): Float64Array => axis.filter((_, i) => i <= 30 || i >= 230); // as a report has them
  const path: Path = { tick: keep(even.tick), xyz: [keep(even.xyz[0]), keep(even.xyz[1]), keep(even.xyz[2])], rapid: new Uint8Array(62) };
  const chunks = chunksOf(path);
  for (const pixelsPerMm of [0.5, 2, 10]) {
    const levels = levelsFor(chunks, whole(pixelsPerMm), MOST_STRETCHES);
    chunks.forEach((chunk, c) => {
      const { points } = chunk.levels[levels[c]!]!;
      for (let k = 1; k < points.length; ++k) {
        const [a, b] = [points[k - 1]!, points[k]!];
        for (let i = a + 1; i < b; ++i) {
          const share = (path.tick[i]! - path.tick[a]!) / (path.tick[b]! - path.tick[a]!);
          const off = Math.abs(path.xyz[0][a]! + share * (path.xyz[0][b]! - path.xyz[0][a]!) - path.xyz[0][i]!);
          assert.ok(off * pixelsPerMm <= 0.35, `${off * pixelsPerMm} pixels between points ${a} and ${b} at ${pixelsPerMm} a millimetre`);
        }
      }
    });
  }
});

test("each stretch has the colour of all the ticks that it stands for", () => {
  const path = pathOf(5000, wave);
  const paint = new PathPaint(path);
  const asked: [number, number][] = [];
  const colouring = { legend: { kind: "scale", title: "", quantity: "share", most: 1 } as const, valueOf: (from: number, to: number) => (asked.push([from, to]), 1), rgbOf: (share: number) => [share, 0, 0] as const };
  const leavesNoneOut = (): void => {
    assert.deepEqual([asked[0]![0], asked[asked.length - 1]![1]], [0, 4999]);
    for (let k = 1; k < asked.length; ++k) assert.equal(asked[k]![0], asked[k - 1]![1]);
    asked.length = 0;
  };
  paint.colour(colouring, null, { rgb: [1, 1, 1], dark: false, accent: "#000000", faint: "#000000", text: "" });
  leavesNoneOut(); // the coarsest
  const painted = paint.paintFor(whole(0.5), Infinity)!;
  assert.ok(painted.isWhole);
  assert.ok(painted.parts.every((part) => part.tint.every((byte, i) => byte === (i % 3 === 0 ? 255 : 0))));
  assert.equal(paint.paintFor(whole(0.5), Infinity), null, "nothing changes");
  const hasty = paint.paintFor(whole(1e4), -Infinity)!;
  assert.ok(!hasty.isWhole && hasty.parts.length === painted.parts.length, "without time it stays coarser");
  asked.length = 0;
  assert.ok(paint.paintFor(whole(1e4), Infinity)!.isWhole);
  leavesNoneOut(); // the finest
});

test("lines that are made between frames are there for the next one", () => {
  const paint = new PathPaint(pathOf(5000, wave));
  let asked = 0;
  const colouring = { legend: { kind: "scale", title: "", quantity: "share", most: 1 } as const, valueOf: () => (++asked, 1), rgbOf: () => [1, 0, 0] as const };
  paint.colour(colouring, null, { rgb: [1, 1, 1], dark: false, accent: "#000000", faint: "#000000", text: "" });
  assert.ok(!paint.makeFor(whole(1e4), -Infinity), "without time the view lacks some");
  assert.ok(!paint.paintFor(whole(1e4), -Infinity)!.isWhole);
  assert.ok(paint.makeFor(whole(1e4), Infinity));
  asked = 0;
  assert.ok(paint.paintFor(whole(1e4), -Infinity)!.isWhole, "and a frame needs no time for them");
  assert.equal(asked, 0);
});

test("while nothing but the instant moves no chunk of the path is looked at", () => {
  const paint = new PathPaint(pathOf(5000, wave));
  const colouring = { legend: { kind: "scale", title: "", quantity: "share", most: 1 } as const, valueOf: () => 1, rgbOf: () => [1, 0, 0] as const };
  paint.colour(colouring, null, { rgb: [1, 1, 1], dark: false, accent: "#000000", faint: "#000000", text: "" });
  let reads = 0;
  const { projection, pixelsPerMm } = whole(0.5);
  const counted = new Proxy(projection as number[], { get: (target, name) => (++reads, Reflect.get(target, name)) });
  const sight: Sight = { projection: counted, pixelsPerMm };
  assert.ok(paint.paintFor(sight, Infinity));
  const first = reads;
  reads = 0;
  assert.equal(paint.paintFor(sight, Infinity), null);
  assert.ok(reads < first / 2, `${reads} numbers of the view read, ${first} for the first frame`);
});

test("dashes of a rapid go on over its points and begin anew with the next", () => {
  const path = pathOf(6, (i) => [10 * i, 0, 0], (i) => i !== 3);
  const lines = linesBetween(path, [0, 1, 2, 3, 4, 5], rapidWays(path), () => undefined);
  assert.deepEqual([...lines.dashed], [1, 1, 0, 1, 1]);
  assert.deepEqual([...lines.along], [0, 10, 20, 0, 10]);
});

test("what is fitted into view is where the tool cuts, not its way from machine zero", () => {
  // A rest before the first cut is none.
  const points = [[0, 0, 0], [300, 200, 50], [300, 200, 50], [310, 200, -2], [310, 220, -2], [0, 0, 100]] as const;
  const at = (i: number): readonly [number, number, number] => points[i]!;
  assert.deepEqual(boxOfCut(pathOf(points.length, at, (i) => [1, 5].includes(i))), { min: [300, 200, -2], max: [310, 220, 50] });
  assert.deepEqual(boxOfCut(pathOf(points.length, at, () => true)), { min: [0, 0, -2], max: [310, 220, 100] });
});
