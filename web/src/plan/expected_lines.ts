// How long lines will take that are not planned yet.
import { ByLine, type LineNumbers } from "./by_line.ts";
import type { Plan } from "./plan.ts";
import type { Progress } from "./source.ts";

// In ticks: each its share of what is left by length over feedrate. No line whose ticks are known has one, and none has where
// nothing is known of what is left.
export function expectedLines(plan: Plan, { lines, left_s }: Pick<Progress, "lines" | "left_s">): LineNumbers {
  const { line, seconds } = plan.nominal;
  const expected = new ByLine(line[line.length - 1] ?? 0);
  if (left_s === null) return expected;
  let nominal_s = 0;
  line.forEach((number, i) => {
    if (lines.get(number) === undefined) nominal_s += seconds[i]!;
  });
  const drawnOut = left_s / nominal_s / plan.period_s;
  line.forEach((number, i) => {
    if (lines.get(number) === undefined) expected.set(number, drawnOut * seconds[i]!);
  });
  return expected;
}
