// Whether the program fits the travel, by how much it does not, and where the work offset would have to lie.
import { fitsOf, type Fit } from "../plan/account.ts";
import type { OffsetRange } from "../plan/decode.ts";
import type { Plan } from "../plan/plan.ts";
import { h } from "../ui/dom.ts";
import { boundOf, boundText, fixed, fromMm, lengthText, lengthUnit, type Units } from "../units.ts";

const NARROW_DIGITS = 6; // of a range that lies between two numbers of the usual digits

export function fitText(fit: Fit, units: Units): string {
  return `${lengthText(fit.min, units)} to ${lengthText(fit.max, units)}`;
}

// Where the origin of a work offset may lie: "-12 to 340".
function rangeText(range: OffsetRange, units: Units): string {
  const [min, max] = [range.min_mm, range.max_mm];
  if (min !== null && max !== null && boundOf(min, "least", units) > boundOf(max, "most", units)) return `at ${fixed(0.5 * fromMm(min + max, units), NARROW_DIGITS)}`;
  const end = (value: number | null, bound: "least" | "most"): string => (value === null ? "any" : boundText(value, bound, units));
  return `${end(min, "least")} to ${end(max, "most")}`;
}

// Of an axis: nothing that a work offset could do helps a path that leaves the travel without following one.
export function offsetText(plan: Plan, range: OffsetRange | undefined, axis: string, units: Units): string {
  const fixedOver = plan.header.report.fit?.axes[axis]?.fixed_over_mm ?? 0;
  if (fixedOver > 0) return `no place: over by ${lengthText(fixedOver, units)} wherever it lies`;
  if (range === undefined) return "does not move it, or not one to one"; // the report does not tell the two apart
  return range.fits_somewhere ? rangeText(range, units) : "no place: larger than the travel";
}

// "-12 to 340" of "-12.000 to 340.000": the card is narrow.
const withoutZeros = (text: string): string => text.replace(/\.(\d*?)0+(?!\d)/g, (_, kept: string) => (kept === "" ? "" : `.${kept}`));

// Of the first offset in use; the answer in full has them all.
function offsetPart(plan: Plan, units: Units, openAll: () => void): HTMLElement | null {
  const [first, ...others] = plan.header.report.fit?.work_offsets ?? [];
  if (!first) return null;
  const rows = Object.entries(first.axes).map(([axis, range]) => h("div", {}, `${axis.toUpperCase()} ${withoutZeros(offsetText(plan, range, axis, units))}`));
  const names = others.map((one) => one.name).join(", ");
  const more = names === "" ? null : h("button", { type: "button", class: "link", click: openAll }, `${names} ...`);
  return h("div", {}, h("h2", {}, `${first.name} between`), h("div", { class: "soft rows", "data-test": "offset-in-force" }, ...rows, more));
}

export function fitCard(plan: Plan, units: Units, openAll: () => void): HTMLElement {
  const fits = fitsOf(plan);
  const other = plan.header.report.fit?.other_axes;
  const isOver = other !== undefined || fits.some((fit) => fit.over > 0);
  const known = fits.some((fit) => fit.travel[0] !== null || fit.travel[1] !== null);
  // Of a program that is refused another axis may be what leaves its travel.
  const fitsAll = plan.motion !== null || plan.header.report.exit_status === 0;
  const good = !isOver && known && fitsAll;
  const verdict = fits.length === 0 ? "does not move" : isOver ? "does not fit" : !known ? "no travel known" : fitsAll ? "fits the travel" : "X, Y and Z fit";
  const rows = fits.map((fit) =>
    h("div", { class: fit.over > 0 ? "bad" : "" }, `${fit.axis.toUpperCase()} ${fitText(fit, units)}${fit.over > 0 ? `, over by ${lengthText(fit.over, units)}` : ""}`),
  );
  const path = h(
    "div",
    {},
    h("h2", {}, `Travel, ${lengthUnit(units)}`),
    h("div", { class: `big ${isOver ? "bad" : good ? "good" : ""}`, "data-test": "fit-verdict" }, verdict),
    h("div", { class: "soft rows", "data-test": "extents" }, ...rows, ...(other === undefined ? [] : [h("div", { class: "bad" }, other)])),
  );
  return h("div", { class: "card fit", "data-test": "fit" }, path, offsetPart(plan, units, openAll));
}
