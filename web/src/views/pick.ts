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

// The tick at which the tool passes nearest to the pointer; null: not within so many pixels.
export function tickNear(path: Path, pointing: Pointing, pixels: number): number | null {
  const [u0, ux, uy, uz] = pointing.u;
  const [v0, vx, vy, vz] = pointing.v;
  const [xs, ys, zs] = path.xyz;
  let best = pixels ** 2;
  let found: number | null = null;
  let lastU = 0;
  let lastV = 0;
  for (let i = 0; i < xs.length; ++i) {
    const u = u0 + ux * xs[i]! + uy * ys[i]! + uz * zs[i]!;
    const v = v0 + vx * xs[i]! + vy * ys[i]! + vz * zs[i]!;
    if (i > 0) {
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
  return found === null ? null : Math.floor(found);
}
