// A feed override in percent, with what is said of a number that is none of a feed.
import { h } from "./dom.ts";

// change: is told the share. The whole number counts, no digit of it alone: 2 of 250.
export function feedField(change: (share: number) => void): HTMLElement[] {
  let share = 1;
  const field = h("input", { type: "number", min: "1", max: "200", step: "1", value: "100", "aria-label": "Feed override in percent" });
  const refusal = h("span", { class: "refused", role: "alert", hidden: true, "data-test": "feed-refused" });
  field.addEventListener("change", () => {
    const before = share;
    const isFeed = field.value !== "" && field.checkValidity();
    if (isFeed) share = field.valueAsNumber / 100;
    refusal.hidden = isFeed;
    refusal.textContent = isFeed ? "" : `not planned: a whole number from 1 to 200 %; it stays at ${Math.round(100 * share)} %`;
    if (share !== before) change(share);
  });
  return [h("label", {}, "Feed ", field, " %"), refusal];
}
