// How the time of a program is split: by what the machine does, by tool, by operation. The figures are the kernel's.
import type { Report } from "./decode.ts";

export interface Split {
  readonly cut: number; // all in s
  readonly rapid: number;
  readonly rest: number;
  readonly toolChange: number;
}

export interface Part {
  readonly name: string;
  readonly split: Split;
}

export const SPLIT_NAMES: readonly (readonly [keyof Split, string])[] = [
  ["cut", "cutting"],
  ["rapid", "rapid"],
  ["rest", "rest"],
  ["toolChange", "tool change"],
];

type Times = NonNullable<Report["time_split"]>;

const split = (times: Times): Split => ({ cut: times.cutting_s, rapid: times.rapid_s, rest: times.rest_s, toolChange: times.tool_change_s });

export const total = ({ cut, rapid, rest, toolChange }: Split): number => cut + rapid + rest + toolChange;

const part = (name: string, times: Times): Part => ({ name, split: split(times) });
const thatTook = (parts: readonly Part[]): Part[] => parts.filter((one) => total(one.split) > 0);

export const splitOf = ({ time_split }: Report): Split => (time_split ? split(time_split) : { cut: 0, rapid: 0, rest: 0, toolChange: 0 });
export const toolsOf = ({ time_by_tool }: Report): Part[] => thatTook((time_by_tool ?? []).map((one) => part(one.tool, one)));
// None without headings.
export const operationsOf = ({ time_by_operation }: Report): Part[] => thatTook((time_by_operation ?? []).map((one) => part(one.operation, one)));
