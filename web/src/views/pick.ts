// Which instant of a path is at a place of the view.
import type { Path } from "../plan/plan.ts";

// Pixels from the pointer, of a point in millimetres: u = u0 + ux x + uy y + uz z, and so v.
export interface Pointing {
  readonly u: readonly [number, number, number, number]; // u0, ux, uy, uz
  readonly v: readonly [number, number, number, number];
}

// The projection of the view (column by column, as WebGL has it, to -1 ... 1), its size, and the pointer from its left top.
export function pointingOf(m: ArrayLike<number>, size: { width: number; height: number }, pointer: { x: number; y: number }): Pointing {
  const [w, h] = [size.width / 2, size.height / 2];
  return {
    u: [m[12]! * w - (pointer.x - w), m[0]! * w, m[4]! * w, m[8]! * w],
    v: [m[13]! * h - (h - pointer.y), m[1]! * h, m[5]! * h, m[9]! * h],
  };
}

const CHUNK = 512; // ways between two points that are passed over at once where they are far away

// Of each chunk of ways: the middle of its box, and half of its size.
interface Boxes {
  readonly middle: readonly Float64Array[];
  readonly half: readonly Float64Array[];
}
const boxesOf = new WeakMap<Path, Boxes>();

function boxes(path: Path): Boxes {
  const known = boxesOf.get(path);
  if (known) return known;
  const count = Math.ceil(Math.max(0, path.tick.length - 1) / CHUNK);
  const middle = path.xyz.map(() => new Float64Array(count));
  const half = path.xyz.map(() => new Float64Array(count));
  path.xyz.forEach((axis, k) => {
    for (let chunk = 0; chunk < count; ++chunk) {
      let low = Infinity;
      let high = -Infinity;
      for (let i = chunk * CHUNK; i <= Math.min((chunk + 1) * CHUNK, axis.length - 1); ++i) {
        low = Math.min(low, axis[i]!);
        high = Math.max(high, axis[i]!);
      }
      middle[k]![chunk] = 0.5 * (low + high);
      half[k]![chunk] = 0.5 * (high - low);
    }
  });
  const made = { middle, half };
  boxesOf.set(path, made);
  return made;
}

// The tick at which the tool passes nearest to the pointer; null: not within so many pixels.
export function tickNear(path: Path, pointing: Pointing, pixels: number): number | null {
  const [u0, ux, uy, uz] = pointing.u;
  const [v0, vx, vy, vz] = pointing.v;
  const [xs, ys, zs] = path.xyz;
  const { middle, half } = boxes(path);
  let best = pixels ** 2;
  let found: number | null = null;
  for (let chunk = 0; chunk < middle[0]!.length; ++chunk) {
    const [x, y, z] = middle.map((axis) => axis[chunk]!) as [number, number, number];
    const [hx, hy, hz] = half.map((axis) => axis[chunk]!) as [number, number, number];
    const awayU = Math.abs(u0 + ux * x + uy * y + uz * z) - Math.abs(ux) * hx - Math.abs(uy) * hy - Math.abs(uz) * hz;
    const awayV = Math.abs(v0 + vx * x + vy * y + vz * z) - Math.abs(vx) * hx - Math.abs(vy) * hy - Math.abs(vz) * hz;
    if (Math.max(awayU, 0) ** 2 + Math.max(awayV, 0) ** 2 >= best) continue;
    let lastU = 0;
    let lastV = 0;
    const first = chunk * CHUNK;
    for (let i = first; i <= Math.min(first + CHUNK, xs.length - 1); ++i) {
      const u = u0 + ux * xs[i]! + uy * ys[i]! + uz * zs[i]!;
      const v = v0 + vx * xs[i]! + vy * ys[i]! + vz * zs[i]!;
      if (i > first) {
        const du = u - lastU;
        const dv = v - lastV;
        const square = du * du + dv * dv;
        const share = square > 0 ? Math.min(1, Math.max(0, -(lastU * du + lastV * dv) / square)) : 0;
        const nearU = lastU + share * du;
        const nearV = lastV + share * dv;
        const distance = nearU * nearU + nearV * nearV;
        if (distance < best) {
          best = distance;
          found = path.tick[i - 1]! + share * (path.tick[i]! - path.tick[i - 1]!);
        }
      }
      lastU = u;
      lastV = v;
    }
  }
  return found === null ? null : Math.floor(found);
}
