// What colour each stretch of the path has, and the legend that says so.
import { rgbOf, scaleColour, toolColour, visibleOn, type Rgb } from "../colours.ts";
import { lastAtOrBefore, type Plan, type Quantity } from "../plan/plan.ts";
import type { ColourBy } from "../state.ts";

export type Legend =
  | { readonly kind: "scale"; readonly title: string; readonly quantity: "v" | "length" | "share"; readonly most: number }
  | { readonly kind: "parts"; readonly title: string; readonly parts: readonly { id: number; name: string; colour: Rgb; ticks: number }[] };

export interface Colouring {
  readonly colour: Uint8Array; // r, g, b of the stretch to each point
  readonly part: Int16Array | null; // of a legend of parts: which of them
  readonly legend: Legend;
}

// The largest share of its limit that the quantity has in some columns, along the path or of an axis.
function shareOfLimit(plan: Plan, quantity: Quantity, from: number, to: number): number {
  let most = 0;
  for (const track of plan.tracks) {
    const limit = plan.limitOf(track, quantity);
    if (limit !== null) {
      const { min, max } = plan.series(`${track}.${quantity}`).range(from, to);
      most = Math.max(most, -min / limit, max / limit);
    }
  }
  return most;
}

// The columns that the stretch to point i stands for, at least one.
function columnsOf(plan: Plan, i: number): [number, number] {
  const { path, ticksPerColumn, columns } = plan.motion!;
  const from = Math.floor(path.tick[i - 1]! / ticksPerColumn);
  const to = Math.ceil(path.tick[i]! / ticksPerColumn);
  return [Math.min(from, columns - 1), Math.min(Math.max(to, from + 1), columns)];
}

function mostFrequent(values: Uint8Array, from: number, to: number, counts: Uint32Array): number {
  counts.fill(0);
  let best = values[from]!;
  for (let i = from; i < to; ++i) {
    const value = values[i]!;
    if (++counts[value]! > counts[best]!) best = value;
  }
  return best;
}

function byScale(plan: Plan, dark: boolean, value: (i: number) => number, legend: { title: string; quantity: "v" | "length" | "share" }, most: number): Colouring {
  const points = plan.motion!.path.tick.length;
  const colour = new Uint8Array(3 * points);
  for (let i = 1; i < points; ++i) {
    const rgb = scaleColour(most > 0 ? value(i) / most : 0, dark);
    for (let k = 0; k < 3; ++k) colour[3 * i + k] = Math.round(255 * rgb[k]!);
  }
  return { colour, part: null, legend: { kind: "scale", ...legend, most } };
}

function byPart(plan: Plan, partOf: (i: number) => number, legend: { title: string; name: (id: number) => string; colour: (id: number) => Rgb }): Colouring {
  const path = plan.motion!.path;
  const points = path.tick.length;
  const colour = new Uint8Array(3 * points);
  const part = new Int16Array(points);
  const ticks = new Map<number, number>();
  for (let i = 1; i < points; ++i) {
    const id = partOf(i);
    part[i] = id;
    ticks.set(id, (ticks.get(id) ?? 0) + path.tick[i]! - path.tick[i - 1]!);
    const rgb = legend.colour(id);
    for (let k = 0; k < 3; ++k) colour[3 * i + k] = Math.round(255 * rgb[k]!);
  }
  const parts = [...ticks].map(([id, took]) => ({ id, name: legend.name(id), colour: legend.colour(id), ticks: took }));
  parts.sort((a, b) => b.ticks - a.ticks);
  return { colour, part, legend: { kind: "parts", title: legend.title, parts } };
}

// The largest feedrate that is no rapid's; of a program that only has rapids theirs.
function largestFeed(plan: Plan): number {
  const { path } = plan.motion!;
  let most = 0;
  for (let i = 1; i < path.tick.length; ++i) {
    if (path.rapid[i] === 0) most = Math.max(most, plan.series("path.v").range(...columnsOf(plan, i)).max);
  }
  return most > 0 ? most : plan.series("path.v").range(0, plan.motion!.columns).max;
}

export function colouringOf(plan: Plan, by: ColourBy, ground: { rgb: Rgb; dark: boolean }): Colouring {
  const motion = plan.motion!;
  switch (by) {
    case "feed":
      return byScale(
        plan,
        ground.dark,
        (i) => {
          const { min, max } = plan.series("path.v").range(...columnsOf(plan, i));
          return (min + max) / 2;
        },
        { title: "feed", quantity: "v" },
        largestFeed(plan),
      );
    case "acceleration":
    case "jerk": {
      const quantity = by === "jerk" ? "j" : "a";
      const title = `${by}, of the limit that is closest`;
      return byScale(plan, ground.dark, (i) => shareOfLimit(plan, quantity, ...columnsOf(plan, i)), { title, quantity: "share" }, 1);
    }
    case "following": {
      const series = plan.series("following_error");
      const most = series.range(0, motion.columns).max;
      return byScale(plan, ground.dark, (i) => series.range(...columnsOf(plan, i)).max, { title: "following error", quantity: "length" }, most);
    }
    case "limit": {
      const counts = new Uint32Array(256);
      const constraints = plan.header.constraints;
      return byPart(plan, (i) => mostFrequent(motion.limit, ...columnsOf(plan, i), counts), {
        title: "what limits the feed",
        name: (id) => constraints[id]?.text ?? String(id),
        colour: (id) => visibleOn(rgbOf(constraints[id]?.colour ?? "#888888"), ground.rgb),
      });
    }
    case "tool": {
      const { runs } = motion;
      return byPart(plan, (i) => runs.tool[Math.max(0, lastAtOrBefore(runs.tick, motion.path.tick[i - 1]!))]!, {
        title: "tool",
        name: (id) => (id === 0 ? "no tool" : `T${id}`),
        colour: (id) => visibleOn(toolColour(id), ground.rgb),
      });
    }
  }
}
