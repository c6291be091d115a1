// A path that leaves the travel, with points where it does.
import type { AxisData } from "./decode.ts";
import type { Path } from "./plan.ts";

// At which shares of the way from point i - 1 to i it crosses the end of an axis' travel, in order.
function crossings(path: Path, i: number, axes: readonly AxisData[]): number[] {
  const shares = path.xyz.flatMap((axis, k) => {
    const [from, to] = [axis[i - 1]!, axis[i]!];
    return axes[k]!.travel.flatMap((end) => (end !== null && (from < end) !== (to < end) && from !== end && to !== end ? [(end - from) / (to - from)] : []));
  });
  return shares.sort((a, b) => a - b);
}

// Each way lies within the travel of X, Y and Z, or outside it, as a whole.
export function cutAtTravel(path: Path, axes: readonly AxisData[]): Path {
  const tick: number[] = [];
  const xyz: [number[], number[], number[]] = [[], [], []];
  const rapid: number[] = [];
  for (let i = 0; i < path.tick.length; ++i) {
    const add = (share: number): void => {
      const at = (values: Float64Array): number => (share === 1 ? values[i]! : values[i - 1]! + share * (values[i]! - values[i - 1]!));
      tick.push(at(path.tick));
      xyz.forEach((values, k) => values.push(at(path.xyz[k]!)));
      rapid.push(path.rapid[i]!);
    };
    if (i > 0) crossings(path, i, axes).forEach(add);
    add(1);
  }
  if (tick.length === path.tick.length) return path;
  const [x, y, z] = xyz;
  return { tick: Float64Array.from(tick), xyz: [Float64Array.from(x), Float64Array.from(y), Float64Array.from(z)], rapid: Uint8Array.from(rapid) };
}
