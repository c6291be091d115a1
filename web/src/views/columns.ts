// What a chart of some pixels' width shows of a series: every minimum and maximum, at any zoom; and how fine it can be.
import type { Plan } from "../plan/plan.ts";
import { plain } from "../units.ts";

export interface Span {
  readonly from: number; // in ticks
  readonly to: number;
}

export interface Drawn {
  readonly tick: Float64Array;
  readonly min: Float64Array;
  readonly max: Float64Array;
}

// One point a pixel, or one a column of the plan where these are fewer: of several ticks, one at each of its ends, since its
// values are those of all of it. A pixel's range reaches into the next one's first column, so that neighbours meet.
export function drawnColumns(plan: Plan, series: string, span: Span, pixels: number): Drawn {
  const { firstTick, ticksPerColumn, columns } = plan.motion!;
  const first = Math.max(0, Math.floor((span.from - firstTick) / ticksPerColumn));
  const last = Math.min(columns - 1, Math.ceil((span.to - firstTick) / ticksPerColumn));
  const count = Math.max(0, last - first + 1);
  const pyramid = plan.series(series);
  const points = Math.min(count, Math.max(1, Math.floor(pixels)));
  const ends = points === count && ticksPerColumn > 1 ? 2 : 1;
  const size = ends * points;
  const drawn = { tick: new Float64Array(size), min: new Float64Array(size), max: new Float64Array(size) };
  for (let i = 0; i < points; ++i) {
    const begin = first + Math.floor((i * count) / points);
    const end = first + Math.floor(((i + 1) * count) / points);
    const { min, max } = pyramid.range(begin, points < count ? end + 1 : end);
    for (let end = 0; end < ends; ++end) {
      const at = ends * i + end;
      drawn.tick[at] = firstTick + (begin + end) * ticksPerColumn;
      drawn.min[at] = min;
      drawn.max[at] = max;
    }
  }
  return drawn;
}

// Which constraint has most of the columns after each pixel; -1: the program is over there.
export function drawnLimits(plan: Plan, span: Span, pixels: number): Int16Array {
  const { limit, firstTick, ticksPerColumn, columns } = plan.motion!;
  const counts = new Uint32Array(256);
  const found = new Int16Array(pixels).fill(-1);
  const column = (pixel: number): number => (span.from - firstTick + ((span.to - span.from) * pixel) / pixels) / ticksPerColumn;
  for (let i = 0; i < pixels; ++i) {
    const begin = Math.floor(column(i));
    const end = Math.min(columns, Math.max(begin + 1, Math.floor(column(i + 1))));
    if (begin < 0 || begin >= end) continue;
    counts.fill(0);
    let best = limit[begin]!;
    for (let k = begin; k < end; ++k) {
      if (++counts[limit[k]!]! > counts[best]!) best = limit[k]!;
    }
    found[i] = best;
  }
  return found;
}

// Where the ticks within a column are: nowhere any more, nearer, on their way, seen, or refused by the kernel.
export type Ticks = "gone" | "nearer" | "coming" | "seen" | "refused";

// What of a run is not known to the tick; empty: all is.
export function finenessText(plan: Plan, within: Ticks = "gone"): string {
  const ticks = plan.motion?.ticksPerColumn ?? 1;
  const shortest = plan.header.shortest_run_ticks ?? 1;
  const column = `${ticks} ticks (${plain(ticks * plan.period_s, 3)} s)`;
  const texts: Record<Ticks, string> = {
    gone: `The finest level here is ${column} a column; minimum and maximum are kept.`,
    nearer: `A column is ${column} here, with their minimum and maximum: zoom in to see each tick.`,
    coming: "The ticks of this part are being planned\u2026",
    seen: "Each tick is shown here.",
    refused: `The ticks of this part cannot be planned; a column is ${column} here.`,
  };
  return [
    ...(ticks > 1 ? [texts[within]] : []),
    ...(shortest > 1 ? [`Runs of fewer than ${shortest} ticks may be joined with those before them: times of lines, tools and operations are rough.`] : []),
  ].join(" ");
}
