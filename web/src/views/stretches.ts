// The path of a plan as what is drawn.
import { mixed, rgbOf } from "../colours.ts";
import { lastAtOrBefore, type Plan } from "../plan/plan.ts";
import type { Ground } from "./ground.ts";
import type { Colouring } from "./path_colours.ts";
import type { Stretches } from "./thick_lines.ts";

export type Triple = [number, number, number];

// Where the path of a plan goes: of the stretches that are no rapids, or of all if there are only rapids.
export function boxOfCut(plan: Plan): { min: Triple; max: Triple } {
  const { path } = plan.motion!;
  const box = (rapids: boolean): { min: Triple; max: Triple } => {
    const min: Triple = [Infinity, Infinity, Infinity];
    const max: Triple = [-Infinity, -Infinity, -Infinity];
    for (let i = 1; i < path.tick.length; ++i) {
      if (path.rapid[i] === 1 && !rapids) continue;
      // A rest at the place where a rapid begins is no cut.
      if (!rapids && path.xyz.every((axis) => axis[i] === axis[i - 1])) continue;
      for (const end of [i - 1, i]) {
        path.xyz.forEach((axis, k) => {
          min[k] = Math.min(min[k]!, axis[end]!);
          max[k] = Math.max(max[k]!, axis[end]!);
        });
      }
    }
    return { min, max };
  };
  const cut = box(false);
  if (cut.min[0] <= cut.max[0]) return cut;
  const all = box(true);
  return all.min[0] <= all.max[0] ? all : { min: [0, 0, 0], max: [0, 0, 0] };
}

export function stretchesOf(plan: Plan, colouring: Colouring, shown: readonly number[] | null, ground: Ground): Stretches {
  const { path } = plan.motion!;
  const count = Math.max(0, path.tick.length - 1);
  const a = new Float32Array(3 * count);
  const b = new Float32Array(3 * count);
  const tint = new Uint8Array(3 * count);
  const dashed = new Uint8Array(count);
  const along = new Float32Array(count);
  const faint = rgbOf(ground.faint).map((part) => Math.round(255 * part));
  let rapid_mm = 0;
  for (let i = 1; i <= count; ++i) {
    let square = 0;
    for (let k = 0; k < 3; ++k) {
      a[3 * (i - 1) + k] = path.xyz[k]![i - 1]!;
      b[3 * (i - 1) + k] = path.xyz[k]![i]!;
      square += (path.xyz[k]![i]! - path.xyz[k]![i - 1]!) ** 2;
    }
    const part = colouring.part?.[i];
    const dim = shown !== null && part !== undefined && !shown.includes(part);
    tint.set(dim ? faint : colouring.colour.subarray(3 * i, 3 * i + 3), 3 * (i - 1));
    dashed[i - 1] = path.rapid[i]!;
    rapid_mm = path.rapid[i] === 1 && path.rapid[i - 1] === 1 ? rapid_mm : 0;
    along[i - 1] = rapid_mm;
    rapid_mm += Math.sqrt(square);
  }
  return { a, b, tint, dashed, along };
}

// How long the way to each point is.
function lengthsBefore(points: readonly Triple[]): Float32Array {
  const lengths = new Float32Array(points.length);
  for (let i = 1; i < points.length; ++i) {
    lengths[i] = lengths[i - 1]! + Math.hypot(...points[i]!.map((at, k) => at - points[i - 1]![k]!));
  }
  return lengths;
}

const MOST_OF_MARK = 20_000; // stretches: more is no line but the whole program

// Those of some runs of a line, in one colour.
export function markOf(plan: Plan, runs: { first: number; last: number }, ground: Ground): Stretches {
  const { path } = plan.motion!;
  const begin = plan.motion!.runs.tick[runs.first]!;
  const end = plan.runEnd(runs.last);
  const from = Math.max(0, lastAtOrBefore(path.tick, begin));
  const to = Math.min(path.tick.length - 1, lastAtOrBefore(path.tick, end) + 1);
  const points: Triple[] = [plan.positionAt(begin)];
  const isRapid: number[] = [];
  for (let i = from + 1; i < to; ++i) {
    if (path.tick[i]! <= begin || path.tick[i]! >= end) continue;
    points.push([path.xyz[0][i]!, path.xyz[1][i]!, path.xyz[2][i]!]);
    isRapid.push(path.rapid[i]!);
  }
  points.push(plan.positionAt(end));
  isRapid.push(path.rapid[to]!);
  const count = Math.min(points.length - 1, MOST_OF_MARK);
  const rgb = mixed(ground.rgb, rgbOf(ground.accent), ground.dark ? 0.45 : 0.3).map((part) => Math.round(255 * part));
  return {
    a: new Float32Array(points.slice(0, count).flat()),
    b: new Float32Array(points.slice(1, count + 1).flat()),
    tint: new Uint8Array(3 * count).map((_, i) => rgb[i % 3]!),
    dashed: Uint8Array.from(isRapid.slice(0, count)),
    along: lengthsBefore(points).subarray(0, count),
  };
}
