// Reads the bytes of a plan: the magic, the size of the header, the header (JSON), then the sections that it lists.
// kerf writes them in programs/kerf/page/plan_document.cpp; docs/page-data.md describes them.

export const PLAN_VERSION = 2;

export interface Limits {
  readonly v: number | null; // mm/s or deg/s; null: does not bind
  readonly a: number | null;
  readonly j: number | null;
}

export interface AxisData {
  readonly name: string;
  readonly unit: "mm" | "deg";
  readonly limits: Limits;
  readonly travel: readonly [number | null, number | null];
}

export interface ConstraintData {
  readonly key: string;
  readonly text: string;
  readonly colour: string;
}

export interface Diagnostic {
  readonly id: string;
  readonly severity: "error" | "warning";
  readonly file: string;
  readonly line: number;
  readonly column: number;
  readonly message: string;
  readonly title: string;
  readonly remedy: string;
}

type Triple = readonly [number, number, number];

export interface Extents {
  readonly min_mm: Readonly<Record<string, number>>;
  readonly max_mm: Readonly<Record<string, number>>;
}

// Between which places the origin of a work offset may lie along an axis; null: no bound.
export interface OffsetRange {
  readonly origin_mm: number;
  readonly min_mm: number | null;
  readonly max_mm: number | null;
  readonly fits_somewhere: boolean; // false: the path is longer than the travel
}

interface TimeData {
  readonly cutting_s: number;
  readonly rapid_s: number;
  readonly rest_s: number;
  readonly tool_change_s: number;
}

// What `kerf dry-run --json` prints: docs/json.md. Only what the page uses.
export interface Report {
  readonly file: string;
  readonly exit_status: number;
  readonly machine: string;
  readonly profile: string;
  readonly feed_override: number; // share of the programmed feedrates
  readonly period_s: number;
  readonly cycle_time_s?: number;
  readonly ticks?: number;
  readonly time_split?: TimeData;
  readonly time_by_tool?: readonly (TimeData & { readonly tool: string })[];
  readonly time_by_operation?: readonly (TimeData & { readonly operation: string })[];
  readonly path_length_mm?: number;
  readonly blocks?: number;
  readonly extents?: Extents;
  readonly deviation?: { max_mm: number; tolerance_mm?: number; at_mm?: Record<string, number>; line?: number };
  readonly max?: { path: Record<string, number>; axes: Record<string, Record<string, number>> };
  readonly chord_error_mm?: number;
  readonly contour_error?: { max_mm: number; mean_mm: number };
  readonly speed_limits?: Readonly<Record<string, { time_s: number; share: number }>>;
  readonly speed_limits_of_lines?: readonly {
    line: number;
    time_s: number;
    limits: Record<string, { time_s: number; share: number }>;
  }[];
  readonly fit?: {
    readonly axes: Readonly<Record<string, { over_mm: number; fixed_over_mm?: number }>>; // fixed: of what follows no work offset
    readonly other_axes?: string; // what of A to W leaves its travel, in words
    readonly work_offsets: readonly { readonly name: string; readonly axes: Readonly<Record<string, OffsetRange>> }[];
  };
  readonly warnings: readonly string[];
  readonly errors: readonly { message: string; line?: number; id?: string }[];
}

interface Section {
  readonly name: string;
  readonly coding: "differences" | "bytes";
  readonly unit?: number;
  readonly count: number;
  readonly bytes: number;
}

export interface Header {
  readonly version: number;
  readonly report: Report;
  readonly diagnostics: readonly Diagnostic[];
  readonly machine: {
    readonly path_limits: Limits;
    readonly axes: readonly AxisData[];
    readonly work_offsets: readonly { name: string; origin_mm: Triple; rotation_deg: number }[];
    readonly chord_tolerance_mm: number | null;
  };
  readonly constraints: readonly ConstraintData[];
  readonly has_source: boolean;
  readonly feed_unit?: "mm/s" | "mm/min" | "inch/min"; // as the program or --units has it
  readonly extents?: { readonly min_mm: Triple; readonly max_mm: Triple }; // also of a path that leaves the travel
  readonly last_tick?: number; // these only of a program that ran
  readonly first_tick?: number;
  readonly ticks_per_column?: number;
  readonly columns?: number;
  readonly path_tolerance_mm?: number; // also of a path alone
  readonly path_tells_rapids?: boolean;
  readonly codes?: readonly string[];
  readonly words?: readonly string[]; // F, S and T
  readonly messages?: readonly { line: number; text: string }[];
  readonly shortest_run_ticks?: number;
  readonly sections: readonly Section[];
}

export type Numbers = Pick<ReadonlyMap<string, Float64Array>, "get" | "has" | "keys">;

// Each section is unpacked when it is first asked for: of a long program most are never seen.
class PackedNumbers implements Numbers {
  private readonly packed = new Map<string, { bytes: Uint8Array; count: number; unit: number }>();
  private readonly unpacked = new Map<string, Float64Array>();

  add(name: string, bytes: Uint8Array, count: number, unit: number): void {
    this.packed.set(name, { bytes, count, unit });
  }

  has(name: string): boolean {
    return this.packed.has(name);
  }

  keys(): MapIterator<string> {
    return this.packed.keys();
  }

  // Throws where the section holds fewer numbers than it says.
  get(name: string): Float64Array | undefined {
    let numbers = this.unpacked.get(name);
    const section = this.packed.get(name);
    if (!numbers && section) this.unpacked.set(name, (numbers = unpackNumbers(section.bytes, section.count, section.unit)));
    return numbers;
  }
}

export interface Decoded {
  readonly header: Header;
  readonly numbers: Numbers;
  readonly bytes: ReadonlyMap<string, Uint8Array>;
}

const MAGIC = "KERFPLAN";

// Whole numbers as differences: 7 bits a byte, the lowest first, the sign in the lowest bit. No number leaves the 53 bits
// that a double holds.
export function unpackNumbers(bytes: Uint8Array, count: number, unit: number): Float64Array {
  const numbers = new Float64Array(count);
  let at = 0;
  let last = 0;
  for (let i = 0; i < count; ++i) {
    const small = bytes[at]!;
    if (small < 0x80) {
      // Most are of one byte, and of a long program there are millions.
      ++at;
      last += (small >> 1) ^ -(small & 1);
      numbers[i] = last * unit;
      continue;
    }
    let step = 0;
    let weight = 1;
    let byte = 0;
    do {
      if (at >= bytes.length) {
        throw new Error("the numbers of the plan end early");
      }
      byte = bytes[at++]!;
      step += (byte & 0x7f) * weight;
      weight *= 128;
    } while (byte >= 0x80);
    const half = Math.floor(step / 2);
    last += step % 2 === 0 ? half : -half - 1;
    numbers[i] = last * unit;
  }
  return numbers;
}

export const isPlan = (bytes: Uint8Array): boolean => String.fromCharCode(...bytes.subarray(0, MAGIC.length)) === MAGIC;

export function decodePlan(bytes: Uint8Array): Decoded {
  if (!isPlan(bytes)) {
    throw new Error("the data of this page is no plan");
  }
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(MAGIC.length, true);
  const begin = MAGIC.length + 4;
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(begin, begin + size))) as Header;
  if (header.version !== PLAN_VERSION) {
    throw new Error(`the plan has version ${header.version}, this page reads ${PLAN_VERSION}`);
  }
  const numbers = new PackedNumbers();
  const raw = new Map<string, Uint8Array>();
  let at = begin + size;
  for (const section of header.sections) {
    const part = bytes.subarray(at, at + section.bytes);
    if (part.length !== section.bytes) {
      throw new Error("the plan ends early");
    }
    at += section.bytes;
    if (section.coding === "differences") {
      numbers.add(section.name, part, section.count, section.unit ?? 1);
    } else {
      raw.set(section.name, part);
    }
  }
  return { header, numbers, bytes: raw };
}
