// The words and codes in force at an instant, below the program's text.
import type { Plan } from "../plan/plan.ts";
import { h } from "../ui/dom.ts";

export class CodesBar {
  readonly element: HTMLElement;
  private readonly words = h("b", { "data-test": "words", title: "feed, spindle speed and tool in the spindle at this instant" });
  private readonly codes = h("span", { "data-test": "codes", title: "the codes in force at this instant" });

  constructor() {
    this.element = h("div", { class: "codes" }, this.words, " ", this.codes);
  }

  // Where nothing is known the bar keeps its place: without it the text would move, and not come back.
  show(plan: Plan | null, tick: number): void {
    const [words, codes] = [plan?.inForceAt("words", tick) ?? "", plan?.inForceAt("codes", tick) ?? ""];
    const isKnown = words !== "" || codes !== "";
    this.element.classList.toggle("unknown", !isKnown);
    if (!isKnown) return;
    this.words.textContent = words;
    this.codes.textContent = codes;
  }
}
