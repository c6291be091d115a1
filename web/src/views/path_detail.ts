// The path at several finenesses. It is cut into chunks, and each chunk is there at levels: a level keeps, of each group of
// points of the level below, the first and those that are smallest and largest in X, Y and Z. So what a view shows of a
// chunk reaches as far as the chunk itself, at any level. No stretch leads over a rest or the end of a rapid, but in levels
// after all others, for views that would have too many stretches else.
import type { Path } from "../plan/plan.ts";

export interface Level {
  readonly points: Uint32Array; // of the path, rising; the first and the last are those of the chunk
  readonly error_mm: number; // how far the tool may be from where it would be if it went straight and evenly between them
  readonly keepsRests: boolean; // and the ends of rapids
}

export interface Chunk {
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
  readonly levels: readonly Level[]; // the finest first
}

const CHUNK = 512; // stretches
const GROUP = 16; // points of which a level keeps few
const FEWEST = 12; // points: a chunk of fewer is not made coarser

// Points that every level keeps: where a rapid begins or ends, and both ends of a rest.
function isFixed({ xyz, rapid }: Path, i: number): boolean {
  const rests = (k: number): boolean => xyz.every((axis) => axis[k] === axis[k - 1]);
  return rapid[i] !== rapid[i + 1] || rests(i) || rests(i + 1);
}

function coarser(path: Path, points: Uint32Array, fixed: (i: number) => boolean): Uint32Array {
  const kept: number[] = [];
  for (let begin = 0; begin < points.length; begin += GROUP) {
    const end = Math.min(begin + GROUP, points.length);
    let places = 1; // a bit for each point of the group: those that are kept
    if (end === points.length) places |= 1 << (end - 1 - begin);
    for (const axis of path.xyz) {
      let [low, high] = [begin, begin];
      for (let i = begin + 1; i < end; ++i) {
        if (axis[points[i]!]! < axis[points[low]!]!) low = i;
        if (axis[points[i]!]! > axis[points[high]!]!) high = i;
      }
      places |= (1 << (low - begin)) | (1 << (high - begin));
    }
    for (let i = begin; i < end; ++i) if (((places >> (i - begin)) & 1) === 1 || fixed(points[i]!)) kept.push(points[i]!);
  }
  return Uint32Array.from(kept);
}

// How far the path's points are from the even ways between those that are kept: a stretch has one colour, and on a straight line a
// ramp of the feed has many.
function errorOf({ tick, xyz: [x, y, z] }: Path, points: Uint32Array): number {
  let most = 0; // squared
  for (let k = 1; k < points.length; ++k) {
    const [a, b] = [points[k - 1]!, points[k]!];
    const [wx, wy, wz] = [x[b]! - x[a]!, y[b]! - y[a]!, z[b]! - z[a]!];
    const ticks = tick[b]! - tick[a]!;
    for (let i = a + 1; i < b; ++i) {
      const share = ticks > 0 ? (tick[i]! - tick[a]!) / ticks : 0;
      const [dx, dy, dz] = [x[i]! - x[a]! - share * wx, y[i]! - y[a]! - share * wy, z[i]! - z[a]! - share * wz];
      most = Math.max(most, dx * dx + dy * dy + dz * dz);
    }
  }
  return Math.sqrt(most);
}

function chunkOf(path: Path, first: number, last: number): Chunk {
  const fixed = (i: number): boolean => i > first && i < last && isFixed(path, i);
  const levels: Level[] = [{ points: Uint32Array.from({ length: last - first + 1 }, (_, i) => first + i), error_mm: 0, keepsRests: true }];
  for (const keepsRests of [true, false]) {
    for (;;) {
      const below = levels[levels.length - 1]!.points;
      const points = below.length > FEWEST ? coarser(path, below, keepsRests ? fixed : () => false) : below;
      if (points.length > 0.75 * below.length) break;
      levels.push({ points, error_mm: errorOf(path, points), keepsRests });
    }
  }
  const ends = path.xyz.map((axis) => {
    let [min, max] = [Infinity, -Infinity];
    for (let i = first; i <= last; ++i) {
      if (axis[i]! < min) min = axis[i]!;
      if (axis[i]! > max) max = axis[i]!;
    }
    return [min, max] as const;
  }) as [readonly [number, number], readonly [number, number], readonly [number, number]];
  return { min: [ends[0][0], ends[1][0], ends[2][0]], max: [ends[0][1], ends[1][1], ends[2][1]], levels };
}

// Neighbours share a point.
export function chunksOf(path: Path): Chunk[] {
  const chunks: Chunk[] = [];
  for (let first = 0; first + 1 < path.tick.length; first += CHUNK) chunks.push(chunkOf(path, first, Math.min(first + CHUNK, path.tick.length - 1)));
  return chunks;
}

// A view: where a point is in it, -1 to 1 in width and height, by the projection column by column, and how many pixels a
// millimetre has.
export interface Sight {
  readonly projection: ArrayLike<number>;
  readonly pixelsPerMm: number;
}

// Whether some of the box may be seen. The corner that lies farthest to a side decides.
function isSeen({ min, max }: Chunk, m: ArrayLike<number>): boolean {
  for (const row of [0, 1]) {
    let low = m[12 + row]!;
    let high = low;
    for (const k of [0, 1, 2] as const) {
      const factor = m[4 * k + row]!;
      low += Math.min(factor * min[k], factor * max[k]);
      high += Math.max(factor * min[k], factor * max[k]);
    }
    if (high < -1 || low > 1) return false;
  }
  return true;
}

export const NOT_SEEN = -1;
const FINE_PIXELS = 0.35; // off by less nobody sees it

// The level of each chunk in this view: as coarse as nobody sees, and coarser where more stretches than so many are left.
export function levelsFor(chunks: readonly Chunk[], { projection, pixelsPerMm }: Sight, most: number): Int8Array {
  const chosen = Int8Array.from(chunks, (chunk) => (isSeen(chunk, projection) ? 0 : NOT_SEEN));
  for (const keepsRests of [true, false]) {
    let isCoarsest = false;
    for (let pixels = FINE_PIXELS; !isCoarsest; pixels *= 2) {
      let stretches = 0;
      isCoarsest = true;
      chunks.forEach(({ levels }, i) => {
        if (chosen[i] === NOT_SEEN) return;
        let level = chosen[i]!;
        const isAllowed = (): boolean => level + 1 < levels.length && (levels[level + 1]!.keepsRests || !keepsRests);
        while (isAllowed() && levels[level + 1]!.error_mm * pixelsPerMm <= pixels) ++level;
        if (isAllowed()) isCoarsest = false;
        chosen[i] = level;
        stretches += levels[level]!.points.length - 1;
      });
      if (stretches <= most) return chosen;
    }
  }
  return chosen;
}

// Whether lines lead over rests or ends of rapids, at these levels.
export function joinsRests(chunks: readonly Chunk[], levels: Int8Array): boolean {
  return levels.some((level, i) => level !== NOT_SEEN && !chunks[i]!.levels[level]!.keepsRests);
}
