// How long the lines take of a plan that is on its way.
import { ByLine, type LineNumbers } from "./by_line.ts";
import type { Plan } from "./plan.ts";
import type { Progress } from "./source.ts";

export class ExpectedLines {
  private readonly plan: Plan;
  private readonly ends: ByLine; // along the path, where each line ends for the last time

  constructor(plan: Plan) {
    this.plan = plan;
    const { line, end_mm } = plan.nominal;
    this.ends = new ByLine(line[line.length - 1] ?? 0);
    line.forEach((number, i) => this.ends.set(number, end_mm[i]!));
  }

  // In ticks, of the lines that are not planned to their end: together they take what the others leave of the whole, each its
  // share by length over feedrate, in all its rounds. None where nothing is known of the whole.
  at({ ticks, path_mm, left_s, lines }: Progress): LineNumbers {
    const { plan, ends } = this;
    const { line, seconds, end_mm } = plan.nominal;
    const expected = new ByLine(line[line.length - 1] ?? 0);
    if (left_s === null) return expected;
    let planned = 0;
    lines.forEach((known, number) => {
      if ((ends.get(number) ?? 0) < path_mm) planned += known;
    });
    let nominal_s = 0;
    line.forEach((_, i) => {
      if (end_mm[i]! >= path_mm) nominal_s += seconds[i]!;
    });
    const drawnOut = (ticks + left_s / plan.period_s - planned) / nominal_s;
    line.forEach((number, i) => {
      if (end_mm[i]! >= path_mm) expected.set(number, drawnOut * seconds[i]!);
    });
    return expected;
  }
}
