// What the colours of the path mean. A part of a legend can be clicked: all others are dimmed then.
import { hexOf, scaleColour } from "../colours.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { MM_PER_INCH, percent, plain, unitOf } from "../units.ts";
import { SCALE_PARTS, chosenParts, type Colouring } from "./path_colours.ts";

// A part of a legend, to be chosen beside those that are; with none of them all are.
function partButton(part: { id: number; label: string | null }, chosen: readonly number[] | null, store: Store, ...content: HTMLElement[]): HTMLElement {
  const isChosen = chosen?.includes(part.id) ?? false;
  const choose = (): void => {
    const others = chosen ?? [];
    const now = isChosen ? others.filter((one) => one !== part.id) : [...others, part.id];
    store.set({ shown: now.length > 0 ? now : null }, "page");
  };
  const button = h("button", { type: "button", "aria-pressed": String(isChosen), class: chosen === null || isChosen ? "" : "dimmed", click: choose }, ...content);
  if (part.label !== null) button.title = part.label;
  if (part.label !== null) button.setAttribute("aria-label", part.label);
  return button;
}

export function legendOf(colouring: Colouring, store: Store, dark: boolean, allTicks: number): HTMLElement {
  const { legend } = colouring;
  const chosen = chosenParts(legend, store.state.shown);
  if (legend.kind === "parts") {
    const items = legend.parts.map(({ id, name, colour, ticks }) => {
      const swatch = h("i", { class: "swatch" });
      swatch.style.backgroundColor = hexOf(colour);
      return partButton({ id, label: null }, chosen, store, swatch, h("span", {}, `${name} `), h("span", { class: "soft" }, percent(ticks / Math.max(1, allTicks))));
    });
    return h("div", { class: "legend parts", role: "group", "aria-label": legend.title }, h("div", { class: "legend-title" }, legend.title), ...items);
  }
  const { units } = store.state;
  const { factor, unit } =
    legend.quantity === "v"
      ? unitOf("v", "mm", units)
      : legend.quantity === "length"
        ? { factor: units.length === "inch" ? 1000 / MM_PER_INCH : 1000, unit: units.length === "inch" ? "thou" : "\u00b5m" }
        : { factor: 100, unit: "%" };
  const mark = (i: number): string => plain((i / SCALE_PARTS) * legend.most * factor, 3);
  const parts = Array.from({ length: SCALE_PARTS }, (_, i) => partButton({ id: i, label: `${mark(i)} to ${mark(i + 1)} ${unit}` }, chosen, store));
  const ramp = h("div", { class: "ramp" }, ...parts);
  const stops = Array.from({ length: 17 }, (_, i) => hexOf(scaleColour(i / 16, dark)));
  ramp.style.backgroundImage = `linear-gradient(to right, ${stops.join(", ")})`;
  const marks = Array.from({ length: SCALE_PARTS + 1 }, (_, i) => h("span", {}, mark(i)));
  return h("div", { class: "legend scale", role: "group", "aria-label": legend.title }, h("div", { class: "legend-title" }, `${legend.title}, ${unit}`), ramp, h("div", { class: "marks" }, ...marks));
}
