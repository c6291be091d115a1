// The path of a plan as what is drawn.
import { mixed, rgbOf } from "../colours.ts";
import { lastAtOrBefore, type Path, type Plan } from "../plan/plan.ts";
import type { Ground } from "./ground.ts";

export type Triple = [number, number, number];

// Straight, of one colour each.
export interface Stretches {
  readonly a: Float32Array; // x, y, z of each begin
  readonly b: Float32Array;
  readonly tint: Uint8Array; // r, g, b
  readonly dashed: Uint8Array;
  readonly along: Float32Array; // mm from where the dashes begin to the stretch
}

export const countOf = (stretches: Stretches): number => stretches.dashed.length;

export function emptyStretches(count: number): Stretches {
  return { a: new Float32Array(3 * count), b: new Float32Array(3 * count), tint: new Uint8Array(3 * count), dashed: new Uint8Array(count), along: new Float32Array(count) };
}

// How far a rapid has come at each point.
export function rapidWays({ xyz: [x, y, z], rapid }: Path): Float32Array {
  const ways = new Float32Array(rapid.length);
  for (let i = 1; i < ways.length; ++i) {
    if (rapid[i] === 1) ways[i] = (rapid[i - 1] === 1 ? ways[i - 1]! : 0) + Math.hypot(x[i]! - x[i - 1]!, y[i]! - y[i - 1]!, z[i]! - z[i - 1]!);
  }
  return ways;
}

// The lines between some points of the path, each as `tint` says of the two; those of no length are left out.
export function linesBetween(path: Path, points: ArrayLike<number>, ways: Float32Array, tint: (from: number, to: number, into: Uint8Array, at: number) => void): Stretches {
  const lines = emptyStretches(Math.max(0, points.length - 1));
  const [x, y, z] = path.xyz;
  let count = 0;
  for (let k = 1; k < points.length; ++k) {
    const [i, j] = [points[k - 1]!, points[k]!];
    if (x[i] === x[j] && y[i] === y[j] && z[i] === z[j]) continue;
    lines.a.set([x[i]!, y[i]!, z[i]!], 3 * count);
    lines.b.set([x[j]!, y[j]!, z[j]!], 3 * count);
    tint(i, j, lines.tint, 3 * count);
    lines.dashed[count] = path.rapid[j]!;
    lines.along[count] = path.rapid[i] === 1 ? ways[i]! : 0;
    ++count;
  }
  const { a, b, tint: tints, dashed, along } = lines;
  return { a: a.subarray(0, 3 * count), b: b.subarray(0, 3 * count), tint: tints.subarray(0, 3 * count), dashed: dashed.subarray(0, count), along: along.subarray(0, count) };
}

// Where the path goes: its stretches that are no rapids, or all if there are only rapids.
export function boxOfCut({ xyz: [x, y, z], rapid }: Path): { min: Triple; max: Triple } {
  const box = (rapids: boolean): { min: Triple; max: Triple } => {
    const min: Triple = [Infinity, Infinity, Infinity];
    const max: Triple = [-Infinity, -Infinity, -Infinity];
    for (let i = 1; i < rapid.length; ++i) {
      if (rapid[i] === 1 && !rapids) continue;
      // A rest at the place where a rapid begins is no cut.
      if (!rapids && x[i] === x[i - 1] && y[i] === y[i - 1] && z[i] === z[i - 1]) continue;
      for (let end = i - 1; end <= i; ++end) {
        const at = [x[end]!, y[end]!, z[end]!];
        for (let k = 0; k < 3; ++k) {
          if (at[k]! < min[k]!) min[k] = at[k]!;
          if (at[k]! > max[k]!) max[k] = at[k]!;
        }
      }
    }
    return { min, max };
  };
  const cut = box(false);
  if (cut.min[0] <= cut.max[0]) return cut;
  const all = box(true);
  return all.min[0] <= all.max[0] ? all : { min: [0, 0, 0], max: [0, 0, 0] };
}

// How long the way to each point is.
function lengthsBefore(points: readonly Triple[]): Float32Array {
  const lengths = new Float32Array(points.length);
  for (let i = 1; i < points.length; ++i) {
    lengths[i] = lengths[i - 1]! + Math.hypot(...points[i]!.map((at, k) => at - points[i - 1]![k]!));
  }
  return lengths;
}

export const MOST_OF_MARK = 4_000; // stretches: a line of more is marked by every second, third ... point

// Those of some runs of a line, in one colour.
export function markOf(plan: Plan, runs: { first: number; last: number }, ground: Ground): Stretches {
  const { path } = plan.motion!;
  const begin = plan.motion!.runs.tick[runs.first]!;
  const end = plan.runEnd(runs.last);
  const from = Math.max(0, lastAtOrBefore(path.tick, begin));
  const to = Math.min(path.tick.length - 1, lastAtOrBefore(path.tick, end) + 1);
  const points: Triple[] = [plan.positionAt(begin)];
  const isRapid: number[] = [];
  const step = Math.ceil((to - from) / MOST_OF_MARK) || 1;
  for (let i = from + 1; i < to; i += step) {
    if (path.tick[i]! <= begin || path.tick[i]! >= end) continue;
    points.push([path.xyz[0][i]!, path.xyz[1][i]!, path.xyz[2][i]!]);
    isRapid.push(path.rapid[i]!);
  }
  points.push(plan.positionAt(end));
  isRapid.push(path.rapid[to]!);
  const count = points.length - 1;
  const rgb = mixed(ground.rgb, rgbOf(ground.accent), ground.dark ? 0.45 : 0.3).map((part) => Math.round(255 * part));
  return {
    a: new Float32Array(points.slice(0, count).flat()),
    b: new Float32Array(points.slice(1, count + 1).flat()),
    tint: new Uint8Array(3 * count).map((_, i) => rgb[i % 3]!),
    dashed: Uint8Array.from(isRapid.slice(0, count)),
    along: lengthsBefore(points).subarray(0, count),
  };
}
