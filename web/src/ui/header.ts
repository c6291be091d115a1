// The page's head: what is shown, and how figures are told.
import { lastPart, type Plan } from "../plan/plan.ts";
import type { Shown } from "../plan/source.ts";
import type { Store, Theme } from "../state.ts";
import { clock } from "../units.ts";
import { aboutBox } from "./about.ts";
import { choice, h, select } from "./dom.ts";

export const nameOf = (plan: Plan): string => lastPart(plan.header.report.file);
export const machineOf = (plan: Plan): string => lastPart(plan.header.report.machine);

// Those that nothing tells apart with their number: "part.ngc (2)". keys: what tells them apart.
export function numbered(names: readonly string[], keys = names): string[] {
  const count = (key: string, before: number): number => keys.filter((one, i) => one === key && i < before).length;
  return names.map((name, i) => (count(keys[i]!, keys.length) > 1 ? `${name} (${count(keys[i]!, i) + 1})` : name));
}

// What tells plans apart: the program where these differ, the machine, the profile.
export function namesOf({ plans, names }: Shown): readonly string[] {
  if (names) return names;
  const parts = plans.map((plan) => [nameOf(plan), machineOf(plan), plan.header.report.profile]);
  const differing = [0, 1, 2].filter((k) => parts.some((part) => part[k] !== parts[0]![k]));
  return numbered(parts.map((part) => (differing.length > 0 ? differing : [0]).map((k) => part[k]).join(", ")));
}

// Of how long it takes.
export const cycleText = (plan: Plan): string => (plan.cycle_s !== undefined ? clock(plan.cycle_s) : plan.endsEarly ? "ends early" : "does not run");

export class Header {
  readonly element: HTMLElement;
  private readonly title = h("h1", {});
  private readonly what = h("div", { class: "what" });
  private readonly several = h("select", { "aria-label": "Program", title: "Program" });
  private readonly store: Store;

  constructor(store: Store, isReport: boolean) {
    this.store = store;
    const { state } = store;
    const length = choice("Lengths in", [["mm", "mm"], ["inch", "inch"]] as const, state.units.length, (value) => {
      length.set(value);
      store.set({ units: { ...state.units, length: value } }, "page");
    });
    const per = choice("Feeds per", [["min", "/min"], ["s", "/s"]] as const, state.units.time, (value) => {
      per.set(value);
      store.set({ units: { ...state.units, time: value } }, "page");
    });
    const theme = select<Theme>("Theme", [["auto", "auto"], ["light", "light"], ["dark", "dark"]], state.theme, (value) => store.set({ theme: value }, "page"));
    const about = aboutBox(isReport);
    const help = h("button", { type: "button", click: () => about.showModal() }, "About");
    this.several.addEventListener("change", () => store.showPlan(Number(this.several.value), "page"));
    this.element = h("header", {}, this.title, this.what, this.several, length.element, per.element, theme, help, about);
  }

  show(plan: Plan, { plans, names }: Shown): void {
    const { report } = plan.header;
    this.title.textContent = nameOf(plan);
    this.title.title = report.file;
    document.title = `${nameOf(plan)} \u2013 Kerf`;
    const text = plan.hasSource ? "with the program\u2019s text" : "without the program\u2019s text";
    this.what.textContent = `${report.machine === "default" ? "default machine" : machineOf(plan)}, ${report.profile}, ${text}`;
    this.several.hidden = plans.length < 2;
    const told = names ?? numbered(plans.map((one) => `${nameOf(one)}${one.header.report.machine === "default" ? "" : `, ${machineOf(one)}`}`));
    this.several.replaceChildren(
      ...plans.map((one, i) => {
        return h("option", { value: String(i) }, `${told[i]!}: ${cycleText(one)}`);
      }),
    );
    this.several.value = String(this.store.state.plan);
  }
}
