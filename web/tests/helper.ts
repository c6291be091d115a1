// Plans that tests make up.
import type { LineNumbers } from "../src/plan/by_line.ts";
import { Plan } from "../src/plan/plan.ts";
import type { Decoded, Header, Report } from "../src/plan/decode.ts";

export interface MadeRun {
  readonly ticks: number;
  readonly line: number;
  readonly kind: number;
  readonly tool?: number;
}

const limits = { v: 100, a: 1000, j: 10000 };

// Runs one after the other; the tool moves along X by 1 mm a tick in each run that is no rest.
// series: values of each tick. report: what else it says.
export function planOf(runs: readonly MadeRun[], source: string | null = null, series: Readonly<Record<string, readonly number[]>> = {}, report: Partial<Report> = {}): Plan {
  const begin: number[] = [];
  let tick = 0;
  for (const run of runs) {
    begin.push(tick);
    tick += run.ticks;
  }
  const header = {
    version: 2,
    report: { file: "made.ngc", period_s: 0.001, exit_status: 0, machine: "default", profile: "", warnings: [], errors: [], ...report },
    diagnostics: [],
    machine: {
      path_limits: limits,
      axes: ["x", "y", "z"].map((name) => ({ name, unit: "mm", limits, travel: [-100, 300] })),
      work_offsets: [],
      chord_tolerance_mm: null,
    },
    constraints: [],
    has_source: source !== null,
    extents: { min_mm: [0, 0, 0], max_mm: [50, 20, 0] },
    last_tick: tick,
    ticks_per_column: 1,
    columns: tick,
    sections: [],
  } as unknown as Header;
  const x: number[] = [0];
  for (const run of runs) x.push(x[x.length - 1]! + (run.kind === 0 ? 0 : run.ticks));
  const zero = new Float64Array(x.length);
  const decoded: Decoded = {
    header,
    numbers: new Map([
      ["path.tick", Float64Array.from([...begin, tick])],
      ["path.x", Float64Array.from(x)],
      ["path.y", zero],
      ["path.z", zero],
      ["runs.tick", Float64Array.from(begin)],
      ["runs.line", Float64Array.from(runs, (run) => run.line)],
      ["runs.tool", Float64Array.from(runs, (run) => run.tool ?? 0)],
      ...Object.entries(series).map(([name, values]) => [name, Float64Array.from(values)] as const),
    ]),
    bytes: new Map([
      ["path.rapid", new Uint8Array(x.length)],
      ["limit", new Uint8Array(tick)],
      ["runs.kind", Uint8Array.from(runs, (run) => run.kind)],
      ...(source === null ? [] : [["source", new TextEncoder().encode(source)] as const]),
    ]),
  };
  return new Plan(decoded);
}

// In the order of the lines.
export function numbersOf(lines: LineNumbers): [number, number][] {
  const pairs: [number, number][] = [];
  lines.forEach((number, line) => pairs.push([line, number]));
  return pairs.sort((a, b) => a[0] - b[0]);
}
