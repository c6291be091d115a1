// A button that opens a list of buttons. A select would choose at each arrow key.
import { h } from "./dom.ts";

export function menu(label: string, text: string, names: readonly string[], choose: (name: string) => void): HTMLElement {
  const summary = h("summary", { "aria-label": label, title: label }, text);
  const chosen = (name: string): void => {
    element.open = false;
    summary.focus();
    choose(name);
  };
  const list = h("div", { class: "menu-list" }, ...names.map((name) => h("button", { type: "button", click: () => chosen(name) }, name)));
  const element = h("details", { class: "menu" }, summary, list);
  const left = (to: EventTarget | null | undefined): void => {
    if (to && !element.contains(to as Node)) element.open = false;
  };
  element.addEventListener("focusout", ({ relatedTarget }) => left(relatedTarget));
  document.addEventListener("pointerdown", ({ target }) => left(target));
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    element.open = false;
    summary.focus();
  });
  return element;
}
