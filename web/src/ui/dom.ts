// Elements from code. Text goes in as text only: nothing of a program is ever read as markup.

type Child = Node | string | null;
type Properties = Record<string, string | boolean | ((event: Event) => void)>;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (typeof value === "boolean") element.toggleAttribute(name, value);
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child): child is Node | string => child !== null));
  return element;
}

// New children in place of the old ones; the button of the same number has the focus that one of them had.
export function replaceKeepingFocus(parent: HTMLElement, ...children: Node[]): void {
  const buttons = (): HTMLButtonElement[] => [...parent.querySelectorAll("button")];
  const focused = buttons().findIndex((button) => button === document.activeElement);
  parent.replaceChildren(...children);
  if (focused >= 0) buttons()[focused]?.focus({ preventScroll: true });
}

// A group of buttons of which one is pressed.
export function choice<T extends string>(
  label: string,
  options: readonly (readonly [T, string])[],
  chosen: T,
  choose: (value: T) => void,
): { element: HTMLElement; set(value: T): void } {
  const buttons = options.map(([value, text]) =>
    h("button", { type: "button", "data-value": value, click: () => choose(value) }, text),
  );
  const set = (value: T): void => {
    for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset["value"] === value));
  };
  set(chosen);
  return { element: h("div", { class: "choice", role: "group", "aria-label": label }, ...buttons), set };
}

export function select<T extends string>(
  label: string,
  options: readonly (readonly [T, string])[],
  chosen: T,
  choose: (value: T) => void,
): HTMLSelectElement {
  const element = h(
    "select",
    { "aria-label": label, title: label, change: () => choose(element.value as T) },
    ...options.map(([value, text]) => h("option", { value }, text)),
  );
  element.value = chosen;
  return element;
}

// Cells that begin like a number are numbers.
export function table(head: readonly string[], rows: readonly (readonly (string | Node)[])[], test: string): HTMLElement {
  return h(
    "table",
    { "data-test": test },
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...rows.map((row) => h("tr", {}, ...row.map((cell) => h("td", typeof cell === "string" && /^[\u2212\d]/.test(cell) ? { class: "number" } : {}, cell))))),
  );
}
