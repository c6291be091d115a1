// Where the time of a program goes: by what the machine does, by tool, by operation, by line.
import { RunKind, lastPart, type Plan } from "./plan.ts";

export interface Split {
  cut: number; // all in ticks
  rapid: number;
  rest: number;
  toolChange: number;
}

export interface Part {
  readonly name: string;
  readonly line: number; // where it begins; 0: none
  readonly split: Split;
}

export const SPLIT_NAMES: readonly (readonly [keyof Split, string])[] = [
  ["cut", "cutting"],
  ["rapid", "rapid"],
  ["rest", "rest"],
  ["toolChange", "tool change"],
];

const none = (): Split => ({ cut: 0, rapid: 0, rest: 0, toolChange: 0 });
const PLACE: readonly (keyof Split)[] = ["rest", "rapid", "cut", "toolChange"];

export const total = (split: Split): number => split.cut + split.rapid + split.rest + split.toolChange;

export interface Heading {
  readonly line: number;
  readonly text: string;
}

// The operations of a program as CAM posts mark them: a line that is nothing but a comment, the last one of several that
// follow each other without motion between. Words to the operator and those that machines act on are none.
export function headingsOf(source: string): Heading[] {
  const found: Heading[] = [];
  source.split("\n").forEach((text, i) => {
    const comment = /^\s*(?:N\d+\s*)?(?:\(([^()]*)\)|;(.*))\s*$/i.exec(text);
    const words = (comment?.[1] ?? comment?.[2] ?? "").trim();
    if (words !== "" && !/^(msg|print|debug|log|logopen|logappend|logclose|probeopen|probeclose|abort)\b\s*,/i.test(words)) {
      found.push({ line: i + 1, text: words });
    }
  });
  return found;
}

export interface Account {
  readonly whole: Split;
  readonly tools: readonly Part[];
  readonly operations: readonly Part[]; // empty without headings
  readonly files: readonly Part[]; // the program and those of its subprograms; empty without subprograms in files
  readonly lines: ReadonlyMap<number, number>; // ticks of each line of the program that takes time
  readonly firstTick: ReadonlyMap<number, number>; // at which it begins for the first time
}

// Which heading a line belongs to: the last one at or before it; -1: none.
function headingOf(headings: readonly Heading[], line: number): number {
  let low = 0;
  let high = headings.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (headings[middle]!.line <= line) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export function accountOf(plan: Plan): Account {
  const whole = none();
  const tools = new Map<number, Part>();
  const operations = new Map<number, Part>();
  const files = new Map<number, Part>();
  const lines = new Map<number, number>();
  const firstTick = new Map<number, number>();
  const headings = plan.source === null ? [] : headingsOf(plan.source);
  const runs = plan.motion?.runs;
  let own = 0; // the line of the program, or from which the subprogram was called
  for (let i = 0; runs && i < runs.tick.length; ++i) {
    const ticks = plan.runEnd(i) - runs.tick[i]!;
    const where = PLACE[runs.kind[i] as RunKind]!;
    const line = runs.line[i]!;
    whole[where] += ticks;
    const tool = runs.tool[i]!;
    let part = tools.get(tool);
    if (!part) tools.set(tool, (part = { name: tool === 0 ? "no tool" : `T${tool}`, line, split: none() }));
    part.split[where] += ticks;
    const file = runs.file[i]!;
    let text = files.get(file);
    if (!text) files.set(file, (text = { name: lastPart(plan.fileName(file)), line, split: none() }));
    text.split[where] += ticks;
    if (file === 0) own = line; // lines of subprograms in files are numbered by themselves
    if (headings.length > 0) {
      const h = headingOf(headings, own);
      let operation = operations.get(h);
      if (!operation) {
        const heading = headings[h];
        operation = { name: heading?.text ?? "before the first heading", line: heading?.line ?? own, split: none() };
        operations.set(h, operation);
      }
      operation.split[where] += ticks;
    }
    if (file !== 0) continue;
    if (ticks > 0) lines.set(line, (lines.get(line) ?? 0) + ticks);
    if (!firstTick.has(line)) firstTick.set(line, runs.tick[i]!);
  }
  const took = (parts: Map<number, Part>): Part[] => [...parts.values()].filter((part) => total(part.split) > 0);
  return { whole, tools: took(tools), operations: took(operations), files: files.size > 1 ? took(files) : [], lines, firstTick };
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
