// Asks for another machine, other tolerances or another feed, beside what the program and the machine file say.
import { AS_IT_IS, type WhatIf } from "../plan/browser_kernel.ts";
import { h } from "./dom.ts";

interface Field {
  readonly key: keyof WhatIf;
  readonly text: string;
  readonly unit: "%" | "mm";
  readonly least: number;
  readonly most: number;
}

const FIELDS: readonly Field[] = [
  { key: "velocity", text: "machine\u2019s speed", unit: "%", least: 1, most: 1000 },
  { key: "acceleration", text: "its acceleration", unit: "%", least: 1, most: 1000 },
  { key: "jerk", text: "its jerk", unit: "%", least: 1, most: 1000 },
  { key: "feed", text: "feed override", unit: "%", least: 1, most: 200 },
  { key: "rapid", text: "rapid override", unit: "%", least: 5, most: 100 },
  { key: "corner_tolerance_mm", text: "P of each G64", unit: "mm", least: 0, most: 1000 },
  { key: "merge_tolerance_mm", text: "and its Q", unit: "mm", least: 0, most: 1000 },
];

export class WhatIfForm {
  readonly element: HTMLElement;
  value: WhatIf = AS_IT_IS;
  private readonly inputs: readonly HTMLInputElement[];
  private readonly changed: (value: WhatIf) => void;

  // keep: takes the run that is shown as the one that others are compared with, until it is called again.
  constructor(changed: (value: WhatIf) => void, keep: HTMLElement) {
    this.changed = changed;
    this.inputs = FIELDS.map(({ key, unit, least, most }) =>
      h("input", { type: "number", min: String(least), max: String(most), step: "any", "data-what": key, disabled: key === "merge_tolerance_mm", placeholder: unit === "%" ? "100" : key === "merge_tolerance_mm" ? "as P" : "as it is", input: () => this.read() }),
    );
    const rows = FIELDS.map(({ text, unit }, i) => h("label", { class: "field" }, h("span", {}, text), this.inputs[i]!, h("span", { class: "soft" }, unit)));
    const clear = h("button", { type: "button", click: () => this.clear() }, "as it is");
    this.element = h("form", { class: "what-if", "aria-label": "What if", submit: (event) => event.preventDefault() }, ...rows, h("div", { class: "tools" }, clear, keep));
  }

  private clear(): void {
    for (const input of this.inputs) input.value = "";
    this.read();
  }

  // An empty field changes nothing; neither does one that is not a possible number, until it is.
  private read(): void {
    const of = (key: keyof WhatIf): HTMLInputElement => this.inputs[FIELDS.findIndex((field) => field.key === key)]!;
    of("merge_tolerance_mm").disabled = of("corner_tolerance_mm").value === "";
    if (!this.inputs.every((input) => input.checkValidity())) return;
    const told = FIELDS.flatMap(({ key, unit }, i) => {
      const { value } = this.inputs[i]!;
      return value === "" || this.inputs[i]!.disabled ? [] : [[key, unit === "%" ? Number(value) / 100 : Number(value)] as const];
    });
    this.value = { ...AS_IT_IS, ...Object.fromEntries(told) };
    this.changed(this.value);
  }
}
