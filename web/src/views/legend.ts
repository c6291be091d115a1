// What the colours of the path mean. A part of a legend can be clicked: all others are dimmed then.
import { hexOf, scaleColour } from "../colours.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { MM_PER_INCH, percent, plain, unitOf } from "../units.ts";
import { chosenParts, type Colouring } from "./path_colours.ts";

export function legendOf(colouring: Colouring, store: Store, dark: boolean, allTicks: number): HTMLElement {
  const { legend } = colouring;
  const { state } = store;
  if (legend.kind === "parts") {
    const shown = chosenParts(legend, state.shown);
    const items = legend.parts.map(({ id, name, colour, ticks }) => {
      const swatch = h("i", { class: "swatch" });
      swatch.style.backgroundColor = hexOf(colour);
      const chosen = shown === null || shown.includes(id);
      const choose = (): void => {
        const others = shown ?? [];
        const now = others.includes(id) ? others.filter((one) => one !== id) : [...others, id];
        store.set({ shown: now.length > 0 ? now : null }, "page");
      };
      return h("button", { type: "button", "aria-pressed": String(shown !== null && chosen), class: chosen ? "" : "dimmed", click: choose }, swatch, `${name} `, h("span", { class: "soft" }, percent(ticks / Math.max(1, allTicks))));
    });
    return h("div", { class: "legend parts", "aria-label": legend.title }, h("div", { class: "legend-title" }, legend.title), ...items);
  }
  const { factor, unit } =
    legend.quantity === "v"
      ? unitOf("v", "mm", state.units)
      : legend.quantity === "length"
        ? { factor: state.units.length === "inch" ? 1000 / MM_PER_INCH : 1000, unit: state.units.length === "inch" ? "thou" : "\u00b5m" }
        : { factor: 100, unit: "%" };
  const ramp = h("div", { class: "ramp" });
  const stops = Array.from({ length: 17 }, (_, i) => hexOf(scaleColour(i / 16, dark)));
  ramp.style.backgroundImage = `linear-gradient(to right, ${stops.join(", ")})`;
  const marks = [0, 0.25, 0.5, 0.75, 1].map((share) => h("span", {}, plain(share * legend.most * factor, 3)));
  return h("div", { class: "legend scale" }, h("div", { class: "legend-title" }, `${legend.title}, ${unit}`), ramp, h("div", { class: "marks" }, ...marks));
}
