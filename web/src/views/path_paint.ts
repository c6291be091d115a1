// The coloured lines of a path in any view: chunk by chunk at the level that the view needs, each made once.
import { rgbOf } from "../colours.ts";
import type { Path } from "../plan/plan.ts";
import type { Ground } from "./ground.ts";
import { scalePart, type Colouring } from "./path_colours.ts";
import { NOT_SEEN, chunksOf, joinsRests, levelsFor, type Chunk, type Sight } from "./path_detail.ts";
import { linesBetween, rapidWays, type Stretches } from "./stretches.ts";

export const MOST_STRETCHES = 70_000;
const MOST_LEVELS = 32;

export interface Painted {
  readonly parts: readonly Stretches[];
  readonly isWhole: boolean; // else some chunks are coarser than they should be, for want of time
}

const bytesOf = (rgb: readonly number[]): number[] => rgb.map((part) => Math.round(255 * part));

export class PathPaint {
  joinsRests = false; // in the view that was asked for last
  private readonly path: Path;
  private readonly chunks: readonly Chunk[];
  private readonly ways: Float32Array;
  private readonly made = new Map<number, Stretches>();
  private tint: (from: number, to: number, into: Uint8Array, at: number) => void = () => undefined;
  private shown: Int8Array | null = null; // the level of each chunk as it was painted last
  private wholeAt = ""; // the view that was painted last, if nothing of it was left coarser

  constructor(path: Path) {
    this.path = path;
    this.chunks = chunksOf(path);
    this.ways = rapidWays(path);
  }

  // parts: those that are not dimmed; null: all.
  colour(colouring: Colouring, parts: readonly number[] | null, ground: Ground): void {
    const faint = bytesOf(rgbOf(ground.faint));
    const steps = colouring.legend.kind === "scale" ? Array.from({ length: 257 }, (_, i) => bytesOf(colouring.rgbOf(i / 256))) : null;
    const known = new Map<number, number[]>();
    this.tint = (from, to, into, at) => {
      const value = colouring.valueOf(from, to);
      let bytes: number[] | undefined;
      if (parts !== null && !parts.includes(steps ? scalePart(value) : value)) bytes = faint;
      else if (steps) bytes = steps[Math.round(256 * Math.min(1, Math.max(0, value)))];
      else if (!(bytes = known.get(value))) known.set(value, (bytes = bytesOf(colouring.rgbOf(value))));
      into.set(bytes!, at);
    };
    this.made.clear();
    this.shown = null;
    this.wholeAt = "";
    this.chunks.forEach((chunk, i) => this.make(i, chunk.levels.length - 1));
  }

  // Makes what the view lacks, until then on the clock of performance.now(). False: it still lacks some.
  makeFor(sight: Sight, until_ms: number): boolean {
    return this.makeLevels(levelsFor(this.chunks, sight, MOST_STRETCHES), until_ms);
  }

  // As before, and what is drawn then. Null: as it was painted last.
  paintFor(sight: Sight, until_ms: number): Painted | null {
    // While only the instant moves, no chunk is looked at.
    const at = `${Array.from(sight.projection).join()} ${sight.pixelsPerMm}`;
    if (at === this.wholeAt) return null;
    const wanted = levelsFor(this.chunks, sight, MOST_STRETCHES);
    this.joinsRests = joinsRests(this.chunks, wanted);
    const isWhole = this.makeLevels(wanted, until_ms);
    const levels = wanted.map((level, i) => {
      while (level !== NOT_SEEN && !this.isMade(i, level)) ++level; // the coarsest is always there
      return level;
    });
    this.wholeAt = isWhole ? at : "";
    if (this.shown && levels.every((level, i) => level === this.shown![i])) return isWhole ? null : { parts: this.partsAt(levels), isWhole };
    this.shown = levels;
    return { parts: this.partsAt(levels), isWhole };
  }

  private isMade(chunk: number, level: number): boolean {
    return this.made.has(chunk * MOST_LEVELS + level);
  }

  private makeLevels(levels: Int8Array, until_ms: number): boolean {
    for (const [i, level] of levels.entries()) {
      if (level === NOT_SEEN || this.isMade(i, level)) continue;
      if (performance.now() >= until_ms) return false;
      this.make(i, level);
    }
    return true;
  }

  private partsAt(levels: Int8Array): Stretches[] {
    return [...levels].flatMap((level, i) => (level === NOT_SEEN ? [] : [this.made.get(i * MOST_LEVELS + level)!]));
  }

  private make(chunk: number, level: number): void {
    this.made.set(chunk * MOST_LEVELS + level, linesBetween(this.path, this.chunks[chunk]!.levels[level]!.points, this.ways, this.tint));
  }
}
