// Panes of which one is seen. The tabs are one stop of the Tab key; the arrow keys, Home and End go from one to another.
import { h } from "./dom.ts";

export type Pane = readonly [name: string, text: string, content: HTMLElement];

export class Tabs {
  readonly list: HTMLElement;
  readonly content: HTMLElement;
  private readonly panes: readonly Pane[];
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly chosen: (name: string) => void;

  // chosen: one has been, by hand.
  constructor(label: string, panes: readonly Pane[], chosen: (name: string) => void) {
    this.panes = panes;
    this.chosen = chosen;
    for (const [name, text, pane] of panes) {
      const tab = h("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `pane-${name}`, "data-tab": name, click: () => this.choose(name) }, text);
      this.buttons.set(name, tab);
      pane.setAttribute("role", "tabpanel");
      pane.removeAttribute("aria-label");
      pane.setAttribute("aria-labelledby", tab.id);
      pane.id = `pane-${name}`;
    }
    this.list = h("div", { class: "tools", role: "tablist", "aria-label": label }, ...this.buttons.values());
    this.list.addEventListener("keydown", (event) => this.key(event));
    this.content = h("div", { class: "content" }, ...panes.map(([, , pane]) => pane));
  }

  // The first one where there is none of that name; says which.
  show(wanted: string): string {
    const shown = this.buttons.has(wanted) ? wanted : this.panes[0]![0];
    for (const [name, , pane] of this.panes) {
      const tab = this.buttons.get(name)!;
      pane.hidden = name !== shown;
      tab.setAttribute("aria-selected", String(name === shown));
      tab.tabIndex = name === shown ? 0 : -1;
    }
    return shown;
  }

  // A tab that is not there while its pane has nothing to show. Says which is shown.
  setHidden(name: string, hidden: boolean): string {
    this.buttons.get(name)!.hidden = hidden;
    const shown = this.panes.find(([, , pane]) => !pane.hidden)?.[0] ?? "";
    return hidden && shown === name ? this.show("") : shown;
  }

  private choose(name: string): void {
    this.show(name);
    this.chosen(name);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const names = this.panes.map(([name]) => name).filter((name) => !this.buttons.get(name)!.hidden);
    const at = names.findIndex((name) => this.buttons.get(name) === event.target);
    const next = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: names.length - 1 }[event.key];
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    const name = names[(next + names.length) % names.length]!;
    this.choose(name);
    this.buttons.get(name)!.focus();
  }
}
