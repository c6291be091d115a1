// What colour each stretch of the path has, and the legend that says so.
import { rgbOf, scaleColour, toolColour, visibleOn, type Rgb } from "../colours.ts";
import { lastAtOrBefore, type Path, type Plan, type Quantity } from "../plan/plan.ts";
import { COLOURS, type ColourBy } from "../state.ts";

export type ScaleQuantity = "v" | "length" | "share";
export type Legend =
  | { readonly kind: "scale"; readonly title: string; readonly quantity: ScaleQuantity; readonly most: number }
  | { readonly kind: "parts"; readonly title: string; readonly parts: readonly { id: number; name: string; colour: Rgb; ticks: number }[] };

export interface Colouring {
  readonly legend: Legend;
  // Of the way between two points of the path: how far up the scale, 0 to 1, or which part.
  valueOf(from: number, to: number): number;
  rgbOf(value: number): Rgb;
}

// A scale has parts of the same width.
export const SCALE_PARTS = 4;
export const scalePart = (share: number): number => Math.min(SCALE_PARTS - 1, Math.max(0, Math.floor(SCALE_PARTS * share)));

// Of the parts that were chosen those that the legend has; null: none was, or none of them is there.
export function chosenParts(legend: Legend, chosen: readonly number[] | null): readonly number[] | null {
  const has = legend.kind === "parts" ? (id: number) => legend.parts.some((part) => part.id === id) : (id: number) => id >= 0 && id < SCALE_PARTS;
  const there = (chosen ?? []).filter(has);
  return there.length > 0 ? there : null;
}

// The columns between two points of the path, at least one.
function columnsOf(plan: Plan, from: number, to: number): [number, number] {
  const { path, ticksPerColumn, columns } = plan.motion!;
  const first = Math.min(Math.floor(path.tick[from]! / ticksPerColumn), columns - 1);
  return [first, Math.min(Math.max(Math.ceil(path.tick[to]! / ticksPerColumn), first + 1), columns)];
}

// Of columns, without those at both ends: a long stretch takes in some of the motion that it begins and ends with.
const MOST_AT_END = 64;
export function innerColumns(from: number, to: number): [number, number] {
  const atEnd = Math.min(MOST_AT_END, Math.floor((to - from) / 4));
  return [from + atEnd, to - atEnd];
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

function mostFrequent(values: Uint8Array, from: number, to: number, counts: Uint32Array): number {
  counts.fill(0);
  let best = values[from]!;
  for (let i = from; i < to; ++i) {
    const value = values[i]!;
    if (++counts[value]! > counts[best]!) best = value;
  }
  return best;
}

function byScale(dark: boolean, value: (from: number, to: number) => number, legend: { title: string; quantity: ScaleQuantity; most: number }): Colouring {
  return {
    legend: { kind: "scale", ...legend },
    valueOf: (from, to) => (legend.most > 0 ? value(from, to) / legend.most : 0),
    rgbOf: (share) => scaleColour(share, dark),
  };
}

function byPart(
  valueOf: (from: number, to: number) => number,
  ticks: ReadonlyMap<number, number>,
  legend: { title: string; name: (id: number) => string; colour: (id: number) => Rgb },
): Colouring {
  const parts = [...ticks].map(([id, took]) => ({ id, name: legend.name(id), colour: legend.colour(id), ticks: took }));
  parts.sort((a, b) => b.ticks - a.ticks);
  return { legend: { kind: "parts", title: legend.title, parts }, valueOf, rgbOf: legend.colour };
}

// From point to point of the path, as the tool goes between them: what columns of several ticks say of the feed at the ends
// of a stretch is in part its neighbours'.
function meanFeeds({ motion, period_s }: Plan): (from: number, to: number) => number {
  const { tick, xyz: [x, y, z] } = motion!.path;
  const ways = new Float64Array(tick.length); // up to each point, in mm
  for (let i = 1; i < ways.length; ++i) ways[i] = ways[i - 1]! + Math.hypot(x[i]! - x[i - 1]!, y[i]! - y[i - 1]!, z[i]! - z[i - 1]!);
  return (from, to) => (tick[to]! > tick[from]! ? (ways[to]! - ways[from]!) / ((tick[to]! - tick[from]!) * period_s) : 0);
}

// The largest between two points without a rapid. Of several ticks, the columns at both ends have some of the rapids there.
function largestBetween(plan: Plan, meanFeed: (from: number, to: number) => number, first: number, last: number): number {
  const { path, ticksPerColumn } = plan.motion!;
  const series = plan.series("path.v");
  const [from, to] = [path.tick[first]!, path.tick[last]!];
  if (ticksPerColumn === 1) return series.range(...columnsOf(plan, first, last)).max;
  const [begin, end] = [Math.ceil(from / ticksPerColumn), Math.floor(to / ticksPerColumn)];
  if (begin < end) return series.range(begin, end).max;
  let most = 0;
  for (let i = first + 1; i <= last; ++i) most = Math.max(most, meanFeed(i - 1, i));
  return most;
}

// The largest feedrate that is no rapid's; of a program that only has rapids theirs.
function largestFeed(plan: Plan, meanFeed: (from: number, to: number) => number): number {
  const { path, columns } = plan.motion!;
  let most = 0;
  for (let first = 0, i = 1; i <= path.tick.length; ++i) {
    if (path.rapid[i] === 0) continue;
    // A rapid leads to this point, or there is none.
    if (i - 1 > first) most = Math.max(most, largestBetween(plan, meanFeed, first, i - 1));
    first = i;
  }
  return most > 0 ? most : plan.series("path.v").range(0, columns).max;
}

function byFeed(plan: Plan, dark: boolean): Colouring {
  const meanFeed = meanFeeds(plan);
  return byScale(dark, meanFeed, { title: "feed", quantity: "v", most: largestFeed(plan, meanFeed) });
}

function byLimit(plan: Plan, ground: Rgb): Colouring {
  const { limit } = plan.motion!;
  const { constraints, report } = plan.header;
  const counts = new Uint32Array(256);
  // As the report tells them: a column has the limit alone that lasts longest in it.
  const ticks = new Map<number, number>();
  constraints.forEach(({ key }, id) => {
    const told = report.speed_limits?.[key];
    if (told) ticks.set(id, told.time_s / plan.period_s);
  });
  return byPart((from, to) => mostFrequent(limit, ...columnsOf(plan, from, to), counts), ticks, {
    title: "what limits the feed",
    name: (id) => constraints[id]?.text ?? String(id),
    colour: (id) => visibleOn(rgbOf(constraints[id]?.colour ?? "#888888"), ground),
  });
}

function byTool(plan: Plan, ground: Rgb): Colouring {
  const { path, runs } = plan.motion!;
  const ticks = new Map<number, number>();
  runs.tool.forEach((tool, i) => ticks.set(tool, (ticks.get(tool) ?? 0) + plan.runEnd(i) - runs.tick[i]!));
  return byPart((from) => runs.tool[Math.max(0, lastAtOrBefore(runs.tick, path.tick[from]!))]!, ticks, {
    title: "tool",
    name: (id) => (id === 0 ? "no tool" : `T${id}`),
    colour: (id) => visibleOn(toolColour(id), ground),
  });
}

// By the largest value of a length in the way.
function byLength(plan: Plan, dark: boolean, name: string, title: string): Colouring {
  const series = plan.series(name);
  const most = series.range(0, plan.motion!.columns).max;
  return byScale(dark, (from, to) => series.range(...innerColumns(...columnsOf(plan, from, to))).max, { title, quantity: "length", most });
}

// Of a path that does not run: what of it is outside the travel.
function byTravel(plan: Plan, path: Path, ground: Rgb): Colouring {
  const { axes } = plan.header.machine;
  // Of the way to point i; the path is cut where it leaves the travel.
  const isOut = (i: number): boolean =>
    path.xyz.some((axis, k) => {
      const [low, high] = axes[k]!.travel;
      const middle = 0.5 * (axis[i]! + axis[Math.max(0, i - 1)]!);
      return (low !== null && middle < low) || (high !== null && middle > high);
    });
  const ways = Uint8Array.from(path.tick, (_, i) => Number(isOut(i)));
  const ticks = new Map<number, number>();
  ways.forEach((way, i) => i > 0 && ticks.set(way, (ticks.get(way) ?? 0) + path.tick[i]! - path.tick[i - 1]!));
  return byPart((_from, to) => ways[to]!, ticks, {
    title: "the path as it is planned",
    name: (id) => (id === 1 ? "leads out of the travel" : "within the travel of X, Y and Z"),
    colour: (id) => visibleOn(rgbOf(id === 1 ? "#c62828" : "#7d8590"), ground),
  });
}

// What can be told of this plan.
export function coloursOf(plan: Plan): ColourBy[] {
  return COLOURS.filter((by) => (by !== "deviation" || plan.has("deviation")) && (by !== "following" || plan.has("following_error")));
}

export function colouringOf(plan: Plan, path: Path, wanted: ColourBy, ground: { rgb: Rgb; dark: boolean }): Colouring {
  if (!plan.motion) return byTravel(plan, path, ground.rgb);
  const by = coloursOf(plan).includes(wanted) ? wanted : "feed";
  switch (by) {
    case "feed":
      return byFeed(plan, ground.dark);
    case "acceleration":
    case "jerk": {
      const quantity = by === "jerk" ? "j" : "a";
      const title = `${by}, of the limit that is closest`;
      const share = (from: number, to: number): number => {
        const columns = columnsOf(plan, from, to);
        const most = shareOfLimit(plan, quantity, ...columns);
        return most > 1.001 ? most : shareOfLimit(plan, quantity, ...innerColumns(...columns)); // what is over a limit shows
      };
      return byScale(ground.dark, share, { title, quantity: "share", most: 1 });
    }
    case "following":
      return byLength(plan, ground.dark, "following_error", "following error");
    case "deviation":
      return byLength(plan, ground.dark, "deviation", "off the programmed path");
    case "limit":
      return byLimit(plan, ground.rgb);
    case "tool":
      return byTool(plan, ground.rgb);
  }
}
