// The tables of the answer in full.
import { fitsOf } from "../plan/account.ts";
import type { Plan, Quantity } from "../plan/plan.ts";
import { SPLIT_NAMES, total, type Part } from "../plan/split.ts";
import { usesOf } from "../plan/uses.ts";
import { table } from "../ui/dom.ts";
import { clock, lengthText, lengthUnit, percent, plain, unitOf, wordsOf, type Units } from "../units.ts";
import { fitText, offsetText } from "./fit_card.ts";

export const QUANTITY_NAMES: Record<Quantity, string> = { v: "velocity", a: "acceleration", j: "jerk" };

export function planTable(plan: Plan, units: Units): HTMLElement {
  const { report } = plan.header;
  const rows = [["program", report.file], ["machine", report.machine], ["profile", report.profile]];
  if (report.feed_override !== 1) rows.push(["feed override", `${plain(100 * report.feed_override)} %`]);
  if (report.path_length_mm !== undefined) rows.push(["path", `${lengthText(report.path_length_mm, units)} ${lengthUnit(units)} in ${report.blocks} blocks`]);
  if (report.ticks !== undefined) rows.push(["ticks", `${report.ticks} of ${plain(1000 * plan.period_s)} ms`]);
  return table(["", ""], rows, "plan");
}

export function offsetsTable(plan: Plan, units: Units): HTMLElement {
  const offsets = plan.header.report.fit?.work_offsets ?? [];
  return table(
    ["axis", "the path", ...offsets.map((offset) => `${offset.name} between`)],
    fitsOf(plan).map((fit) => [fit.axis.toUpperCase(), fitText(fit, units), ...offsets.map((offset) => offsetText(plan, offset.axes[fit.axis], fit.axis, units))]),
    "offsets",
  );
}

export function constraintsTable(plan: Plan): HTMLElement {
  const limits = Object.entries(plan.header.report.speed_limits ?? {});
  return table(
    ["limit", "time", "share"],
    limits.map(([key, { time_s, share }]) => [wordsOf(key), clock(time_s), percent(share)]),
    "constraints",
  );
}

export function partsTable(what: string, parts: readonly Part[]): HTMLElement {
  return table(
    [what, "time", "cut", "rapid", "rest", "tool"],
    parts.map((part) => [
      part.name,
      clock(total(part.split)),
      ...SPLIT_NAMES.map(([kind]) => (part.split[kind] > 0 ? clock(part.split[kind]) : "")),
    ]),
    `by-${what}`,
  );
}

export function usesTable(plan: Plan, units: Units): HTMLElement {
  return table(
    ["where", "largest", "limit", "share"],
    usesOf(plan).map((use) => {
      const { factor, unit } = unitOf(use.quantity, plan.unitOf(use.track), units);
      return [`${use.track === "path" ? "path" : `axis ${use.track.toUpperCase()}`} ${QUANTITY_NAMES[use.quantity]}`, `${plain(use.peak * factor)} ${unit}`, use.limit === null ? "none" : plain(use.limit * factor), use.limit === null ? "" : percent(use.share)];
    }),
    "largest",
  );
}
