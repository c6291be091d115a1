// What each line of a program takes, or is expected to, as it stands beside its text.
import type { Account } from "../plan/account.ts";
import { ByLine, type LineNumbers } from "../plan/by_line.ts";
import { ExpectedLines } from "../plan/expected_lines.ts";
import type { Plan } from "../plan/plan.ts";
import type { Progress } from "../plan/source.ts";
import { roughTime, shortTime } from "../units.ts";
import { TimeMarker } from "./program_marks.ts";

export class LineTimes {
  private readonly plan: Plan;
  private lines: LineNumbers; // ticks
  private expectation: ExpectedLines | null = null;
  private expected: LineNumbers = new ByLine(0); // ticks of lines that are not planned to their end
  private longest = 1; // ticks of the line that takes longest

  constructor(plan: Plan, { lines }: Account) {
    this.plan = plan;
    this.lines = lines;
    this.findLongest();
  }

  // The ticks of some lines of a plan that is on its way, and about what the others take. null: no more will come.
  follow(progress: Progress | null): void {
    if (progress) {
      this.lines = progress.lines;
      this.expectation ??= new ExpectedLines(this.plan);
    }
    this.expected = (progress && this.expectation?.at(progress)) ?? new ByLine(0);
    this.findLongest();
  }

  // line: as it was planned.
  markerOf(line: number): TimeMarker | null {
    const expected = this.expected.get(line);
    const ticks = expected ?? this.lines.get(line) ?? 0;
    if (ticks < 0.5) return null;
    const seconds = ticks * this.plan.period_s;
    return new TimeMarker(expected === undefined ? shortTime(seconds) : roughTime(seconds), ticks / this.longest);
  }

  private findLongest(): void {
    this.longest = 1;
    for (const lines of [this.lines, this.expected]) lines.forEach((ticks) => (this.longest = Math.max(this.longest, ticks)));
  }
}
