// Where plans come from: embedded in the page (embedded.ts), computed in the browser (../playground.ts), or sent by a server,
// which has its place here and is not written yet. Whoever shows them knows none of the three.
import type { LineNumbers } from "./by_line.ts";
import type { Plan } from "./plan.ts";

// Ticks of a run, both ends among them.
export interface Part {
  readonly first: number;
  readonly last: number;
}

// A plan whose columns are these ticks; null: there is none now. Throws where there will be none.
export type PartOf = (plan: Plan, part: Part) => Promise<Plan | null>;

// Plans that stand side by side.
export interface Shown {
  readonly plans: readonly [Plan, ...Plan[]];
  readonly base: number; // which of them the others are compared with
  readonly names?: readonly string[]; // of each, where neither program, machine nor profile tells them apart
  readonly partOf?: PartOf; // of those with columns of several ticks, where the kernel is at hand
}

// How far a plan is that is on its way.
export interface Progress {
  readonly ticks: number;
  readonly path_mm: number; // its length so far
  readonly left_s: number | null; // the kernel's estimate; null: it has none
  readonly line: number; // that is run now; 0: none is yet
  readonly lines: LineNumbers; // ticks so far
}

export interface PlanSource {
  // Calls `show` with what is to be seen: once, or again with all that comes later. Fails where there is nothing.
  open(show: (shown: Shown) => void): Promise<void>;
}
