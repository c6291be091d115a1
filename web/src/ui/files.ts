// Files of the visitor's; they stay in this page.
import type { Files } from "../editing.ts";
import { h } from "./dom.ts";

// Who takes the texts of files, and is told why one cannot be read.
export interface FileTaker {
  take(files: Files): void;
  fail(why: string): void;
}

async function read(file: File): Promise<{ name: string; text: string }> {
  try {
    return { name: file.name, text: await file.text() };
  } catch (error) {
    throw new Error(`${file.name} cannot be read: ${error instanceof Error ? error.message : String(error)}`);
  }
}

async function hand(files: readonly File[], { take, fail }: FileTaker): Promise<void> {
  try {
    const [first, ...others] = await Promise.all(files.map(read));
    if (first) take([first, ...others]);
  } catch (error) {
    fail((error as Error).message);
  }
}

export function opener(label: string, several: boolean, taker: FileTaker): HTMLElement {
  const input = h("input", { type: "file", multiple: several, hidden: true, "aria-label": label });
  input.addEventListener("change", () => {
    const chosen = [...(input.files ?? [])];
    input.value = "";
    void hand(chosen, taker);
  });
  return h("span", {}, input, h("button", { type: "button", title: label, "aria-label": label, click: () => input.click() }, "open\u2026"));
}

// Files that are dropped anywhere on the page: the browser would leave it for them, and an editor put them into its text.
export function takeDropped(programs: FileTaker, machines: FileTaker): void {
  const filesOf = ({ dataTransfer }: DragEvent): DataTransfer | null => (dataTransfer?.types.includes("Files") ? dataTransfer : null);
  const isMachine = ({ name }: File): boolean => /\.toml$/i.test(name);
  document.addEventListener("dragover", (event) => filesOf(event) && event.preventDefault(), true);
  document.addEventListener(
    "drop",
    (event) => {
      const dropped = filesOf(event);
      if (!dropped) return;
      event.preventDefault();
      event.stopPropagation();
      const files = [...dropped.files];
      void hand(files.filter(isMachine), machines);
      void hand(files.filter((file) => !isMachine(file)), programs);
    },
    true,
  );
}

// Where something would be lost.
export function askBeforeLeaving(isWritten: () => boolean): void {
  window.addEventListener("beforeunload", (event) => {
    if (!isWritten()) return;
    event.preventDefault();
    event.returnValue = true; // for browsers before 2024
  });
}
