// Where the time of a program goes: by what the machine does, by tool, by operation, by line.
import { ByLine, type LineNumbers } from "./by_line.ts";
import type { Header } from "./decode.ts";
import { RunKind, type Plan } from "./plan.ts";

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

// By its first letter: hardly any line of a long program is one, and to take each apart takes long.
function mayBeComment(source: string, begin: number, end: number): boolean {
  let at = begin;
  while (at < end && source.charCodeAt(at) <= 0x20) ++at;
  return "(;Nn".includes(source.charAt(at));
}

function commentOf(line: string): string {
  const comment = /^\s*(?:N\d+\s*)?(?:\(([^()]*)\)|;(.*))\s*$/i.exec(line);
  return (comment?.[1] ?? comment?.[2] ?? "").trim();
}

// The operations of a program as CAM posts mark them: a line that is nothing but a comment, the last one of several that
// follow each other without motion between. Words to the operator and those that machines act on are none.
export function headingsOf(source: string): Heading[] {
  const found: Heading[] = [];
  for (let line = 1, begin = 0; begin < source.length; ++line) {
    const next = source.indexOf("\n", begin);
    const end = next < 0 ? source.length : next;
    const words = mayBeComment(source, begin, end) ? commentOf(source.slice(begin, end)) : "";
    if (words !== "" && !/^(msg|print|debug|log|logopen|logappend|logclose|probeopen|probeclose|abort)\b\s*,/i.test(words)) {
      found.push({ line, text: words });
    }
    begin = end + 1;
  }
  return found;
}

export interface Account {
  readonly whole: Split;
  readonly tools: readonly Part[];
  readonly operations: readonly Part[]; // empty without headings
  readonly lines: LineNumbers; // ticks of each line of the program that takes time
  readonly firstTick: LineNumbers; // at which it begins for the first time
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

// Of runs that some number tells apart, in the order in which they come.
class Parts {
  private readonly parts = new Map<number, Part>();
  private readonly begin: (number: number) => { name: string; line: number };
  private number = NaN; // of the run before: most are of its part
  private split = none();

  constructor(begin: (number: number) => { name: string; line: number }) {
    this.begin = begin;
  }

  of(number: number): Split {
    if (number === this.number) return this.split;
    let part = this.parts.get(number);
    if (!part) this.parts.set(number, (part = { ...this.begin(number), split: none() }));
    this.number = number;
    return (this.split = part.split);
  }

  get thatTook(): Part[] {
    return [...this.parts.values()].filter((part) => total(part.split) > 0);
  }
}

export function accountOf(plan: Plan): Account {
  const headings = plan.source === null ? [] : headingsOf(plan.source);
  const runs = plan.motion?.runs;
  const lastLine = runs?.line.reduce((last, line) => Math.max(last, line), 0) ?? 0;
  let line = 0;
  const whole = none();
  const tools = new Parts((tool) => ({ name: tool === 0 ? "no tool" : `T${tool}`, line }));
  const operations = new Parts((h) => ({ name: headings[h]?.text ?? "before the first heading", line: headings[h]?.line ?? line }));
  const lines = new ByLine(lastLine);
  const firstTick = new ByLine(lastLine);
  for (let i = 0; runs && i < runs.tick.length; ++i) {
    const begin = runs.tick[i]!;
    const ticks = plan.runEnd(i) - begin;
    const where = PLACE[runs.kind[i] as RunKind]!;
    line = runs.line[i]!;
    whole[where] += ticks;
    tools.of(runs.tool[i]!)[where] += ticks;
    if (headings.length > 0) operations.of(headingOf(headings, line))[where] += ticks;
    if (ticks > 0) lines.set(line, (lines.get(line) ?? 0) + ticks);
    if (firstTick.get(line) === undefined) firstTick.set(line, begin);
  }
  return { whole, tools: tools.thatTook, operations: operations.thatTook, lines, firstTick };
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
