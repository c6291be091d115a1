// What is said of a program's time while it is planned.
import type { Progress } from "../plan/source.ts";
import { clock } from "../units.ts";

// No digits that an estimate does not have.
const wholeSeconds = (seconds: number): string => clock(Math.round(seconds)).replace(/\.\d+/, "");

// null: nothing is known yet. "none": it will not come.
export type Waited = Progress | null | "none";

// The whole time, as an estimate, and how much of it is planned.
export function waitingTexts(progress: Waited, period_s: number): [string, string] {
  if (progress === "none") return ["not planned", ""];
  if (!progress || progress.ticks === 0) return ["planning\u2026", ""];
  const done_s = progress.ticks * period_s;
  const soFar = `planned so far: ${wholeSeconds(done_s)}${progress.line > 0 ? `, up to line ${progress.line}` : ""}`;
  return progress.left_s === null ? ["planning\u2026", soFar] : [`about ${wholeSeconds(done_s + progress.left_s)}`, `an estimate; ${soFar}`];
}
