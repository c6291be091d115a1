// A program and its run, ready to be looked at: what every view reads.
import type { Decoded, Header } from "./decode.ts";
import { cutAtTravel } from "./cut_path.ts";
import { Pyramid, type MinMax } from "./pyramid.ts";
import { hasSource, sourceIn } from "./source_text.ts";

export enum RunKind {
  rest,
  rapid,
  cut,
}

// Run i is from tick[i] up to tick[i + 1], the last one up to the end.
export interface Runs {
  readonly tick: Float64Array;
  readonly line: Float64Array;
  readonly tool: Float64Array;
  readonly kind: Uint8Array;
}

// The tool goes straight and evenly from point to point, to within the path's tolerance. Of a program that does not run,
// or whose times are not planned yet, "ticks" are nanometres along the path.
export interface Path {
  readonly tick: Float64Array;
  readonly xyz: readonly [Float64Array, Float64Array, Float64Array];
  readonly rapid: Uint8Array; // the way to the point
}

export const lastPart = (path: string): string => path.split("/").pop() ?? path;

// About how long lines take of a program whose times are not planned yet, by what it says alone.
export interface Nominal {
  readonly line: Float64Array; // in order
  readonly seconds: Float64Array; // in all its rounds
  readonly end_mm: Float64Array; // of the last one, along the path
}

export type Quantity = "v" | "a" | "j";

// The last i with values[i] <= value; -1: none.
export function lastAtOrBefore(values: Float64Array, value: number): number {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle]! <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export interface Motion {
  readonly path: Path;
  readonly runs: Runs;
  readonly limit: Uint8Array; // of each column: its number in header.constraints
  readonly firstTick: number; // at which the first column begins
  readonly ticksPerColumn: number;
  readonly columns: number;
  readonly lastTick: number;
}

function wanted<T>(sections: { get(name: string): T | undefined }, name: string): T {
  const found = sections.get(name);
  if (!found) throw new Error(`the plan lacks ${name}`);
  return found;
}

function pathOf({ numbers, bytes }: Decoded): Path | null {
  if (!numbers.has("path.tick")) return null;
  const of = (name: string): Float64Array => wanted(numbers, name);
  return { tick: of("path.tick"), xyz: [of("path.x"), of("path.y"), of("path.z")], rapid: wanted(bytes, "path.rapid") };
}

function motionOf(decoded: Decoded, path: Path | null): Motion | null {
  const { header, numbers, bytes } = decoded;
  if (header.last_tick === undefined || path === null) return null;
  const of = (name: string): Float64Array => wanted(numbers, name);
  const runs: Runs = {
    tick: of("runs.tick"),
    line: of("runs.line"),
    tool: of("runs.tool"),
    kind: wanted(bytes, "runs.kind"),
  };
  return {
    path,
    runs,
    limit: wanted(bytes, "limit"),
    firstTick: header.first_tick ?? 0,
    ticksPerColumn: header.ticks_per_column ?? 1,
    columns: header.columns ?? 0,
    lastTick: header.last_tick,
  };
}

// CR, LF and CRLF each end a line, and CRs after an LF belong to its end, as kerf counts lines.
export const withLineFeeds = (text: string): string => (text.includes("\r") ? text.replace(/\r\n?|\n\r*/g, "\n") : text);

const LINE_FEED = 10;

// What is not UTF-8 becomes U+FFFD.
const textOf = (bytes: Uint8Array): string => withLineFeeds(new TextDecoder().decode(bytes));

export class Plan {
  readonly header: Header;
  readonly path: Path | null; // also of one that leaves the travel
  readonly motion: Motion | null; // null: it did not run
  readonly hasSource: boolean;
  readonly sourceSteps: Generator<string>; // each makes some of the source, and gives its first lines once there are some
  private text: string | null = null;
  private readonly decoded: Decoded;
  private readonly pyramids = new Map<string, Pyramid>();

  // source: the program's text as its reader has it, in place of what was planned.
  constructor(decoded: Decoded, source?: string) {
    this.decoded = decoded;
    this.header = decoded.header;
    const path = pathOf(decoded);
    this.motion = motionOf(decoded, path);
    this.path = path && !this.motion ? cutAtTravel(path, this.header.machine.axes) : path;
    this.hasSource = source !== undefined || hasSource(decoded);
    this.sourceSteps = this.madeSource(source);
  }

  private *madeSource(given: string | undefined): Generator<string> {
    this.text = given === undefined ? yield* this.readSource() : withLineFeeds(given);
  }

  private *readSource(): Generator<string, string> {
    const steps = sourceIn(this.decoded);
    let begin: string | undefined;
    let step = steps.next();
    for (; !step.done; step = steps.next()) {
      const { value } = step;
      if (value.length > 0) begin ??= textOf(value.subarray(0, Math.max(0, value.lastIndexOf(LINE_FEED))));
      yield begin ?? "";
    }
    return textOf(step.value);
  }

  // Its lines end with LF, whatever they were read with. Made when it is first asked for: a million lines take as long as all
  // that is seen before them.
  get source(): string | null {
    if (this.hasSource) while (!this.sourceSteps.next().done);
    return this.text;
  }

  get period_s(): number {
    return this.header.report.period_s;
  }

  // Of a run that came to its end; undefined: it did not, or does not run at all.
  get cycle_s(): number | undefined {
    const { exit_status, cycle_time_s } = this.header.report;
    return exit_status === 0 ? cycle_time_s : undefined;
  }

  // It ran, and a fault or a bound of time ended it early.
  get endsEarly(): boolean {
    return this.motion !== null && this.header.report.exit_status !== 0;
  }

  // "path", "x", "y", ...
  get tracks(): string[] {
    return ["path", ...this.header.machine.axes.map((axis) => axis.name)];
  }

  // Of a plan that is on its way; empty of one that has come.
  get nominal(): Nominal {
    const of = (name: string): Float64Array => this.decoded.numbers.get(name) ?? new Float64Array();
    return { line: of("nominal.line"), seconds: of("nominal.s"), end_mm: of("nominal.end") };
  }

  unitOf(track: string): "mm" | "deg" {
    return this.header.machine.axes.find((axis) => axis.name === track)?.unit ?? "mm";
  }

  limitOf(track: string, quantity: Quantity): number | null {
    const axis = this.header.machine.axes.find((one) => one.name === track);
    return (axis ? axis.limits : this.header.machine.path_limits)[quantity];
  }

  has(series: string): boolean {
    return this.decoded.numbers.has(series) || this.decoded.numbers.has(`${series}.min`);
  }

  // "path.v", "x.j", "following_error", "deviation"
  series(name: string): Pyramid {
    let pyramid = this.pyramids.get(name);
    if (!pyramid) {
      const single = this.decoded.numbers.get(name);
      const min = single ?? this.decoded.numbers.get(`${name}.min`);
      const max = single ?? this.decoded.numbers.get(`${name}.max`);
      if (!min || !max) throw new Error(`the plan lacks ${name}`);
      const low = new Float32Array(min);
      pyramid = new Pyramid(low, single ? low : new Float32Array(max));
      this.pyramids.set(name, pyramid);
    }
    return pyramid;
  }

  columnAt(tick: number): number {
    const motion = this.motion;
    return motion ? Math.min(motion.columns - 1, Math.max(0, Math.floor((tick - motion.firstTick) / motion.ticksPerColumn))) : 0;
  }

  // Of the column that the tick is in: a single value where columns are ticks.
  valueAt(name: string, tick: number): MinMax {
    const column = this.columnAt(tick);
    return this.series(name).range(column, column + 1);
  }

  positionAt(tick: number): [number, number, number] {
    const path = this.motion?.path;
    if (!path || path.tick.length === 0) return [0, 0, 0];
    const i = Math.max(0, lastAtOrBefore(path.tick, tick));
    const next = Math.min(i + 1, path.tick.length - 1);
    const span = path.tick[next]! - path.tick[i]!;
    const share = span > 0 ? Math.min(1, (tick - path.tick[i]!) / span) : 0;
    const at = (k: 0 | 1 | 2): number => path.xyz[k][i]! + share * (path.xyz[k][next]! - path.xyz[k][i]!);
    return [at(0), at(1), at(2)];
  }

  // "G1 G17 G21 ...", or "F600 S9000 T1"; empty where nothing is known.
  inForceAt(what: "codes" | "words", tick: number): string {
    const begins = this.decoded.numbers.get(`${what}.tick`);
    const texts = this.decoded.numbers.get(`${what}.text`);
    const run = begins ? lastAtOrBefore(begins, tick) : -1;
    return run < 0 ? "" : (this.header[what]?.[texts?.[run] ?? -1] ?? "");
  }

  runAt(tick: number): number {
    return this.motion ? Math.max(0, lastAtOrBefore(this.motion.runs.tick, tick)) : 0;
  }

  // Whether two runs are of one line.
  isSameLine(a: number, b: number): boolean {
    const { line } = this.motion!.runs;
    return line[a] === line[b];
  }

  // "line 12"
  placeAt(tick: number): string {
    return `line ${this.motion?.runs.line[this.runAt(tick)] ?? 0}`;
  }

  runEnd(run: number): number {
    const { runs, lastTick } = this.motion!;
    return run + 1 < runs.tick.length ? runs.tick[run + 1]! : lastTick;
  }
}
