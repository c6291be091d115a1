// Where the time of a program goes by line, whether it fits the travel, and what moves it.
import { ByLine, type LineNumbers } from "./by_line.ts";
import type { Header } from "./decode.ts";
import type { Plan } from "./plan.ts";

export interface Account {
  readonly lines: LineNumbers; // ticks of each line of the program that takes time
  readonly firstTick: LineNumbers; // at which it begins for the first time
}

export function accountOf(plan: Plan): Account {
  const runs = plan.motion?.runs;
  const lastLine = runs?.line.reduce((last, line) => Math.max(last, line), 0) ?? 0;
  const lines = new ByLine(lastLine);
  const firstTick = new ByLine(lastLine);
  for (let i = 0; runs && i < runs.tick.length; ++i) {
    const begin = runs.tick[i]!;
    const ticks = plan.runEnd(i) - begin;
    const line = runs.line[i]!;
    if (ticks > 0) lines.set(line, (lines.get(line) ?? 0) + ticks);
    if (firstTick.get(line) === undefined) firstTick.set(line, begin);
  }
  return { lines, firstTick };
}

export interface Fit {
  readonly axis: string;
  readonly min: number; // mm
  readonly max: number;
  readonly travel: readonly [number | null, number | null];
  readonly over: number; // by how much it leaves the travel; 0: it fits
}

// The box of the program beside the travel of X, Y and Z. Empty without motion.
export function fitsOf(plan: Plan): Fit[] {
  const { extents, machine, report } = plan.header;
  if (!extents) return [];
  return machine.axes.slice(0, 3).map((axis, k) => ({
    axis: axis.name,
    min: extents.min_mm[k]!,
    max: extents.max_mm[k]!,
    travel: axis.travel,
    over: report.fit?.axes[axis.name]?.over_mm ?? 0,
  }));
}

// The work offsets that move the program; where none is known to, G54.
export function workOffsetsOf({ header: { machine, report } }: Plan): Header["machine"]["work_offsets"] {
  const names = report.fit?.work_offsets.map(({ name }) => name) ?? [];
  const used = machine.work_offsets.filter(({ name }) => names.includes(name));
  return used.length > 0 ? used : machine.work_offsets.slice(0, 1);
}
