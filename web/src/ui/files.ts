// Files of the visitor's; they stay in this page.
import type { Files } from "../editing.ts";
import { isToml, names } from "../plan/machine_files.ts";
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

export function opener(label: string, taker: FileTaker): HTMLElement {
  const input = h("input", { type: "file", multiple: true, hidden: true, "aria-label": label });
  input.addEventListener("change", () => {
    const chosen = [...(input.files ?? [])];
    input.value = "";
    void hand(chosen, taker);
  });
  return h("span", {}, input, h("button", { type: "button", title: label, "aria-label": label, click: () => input.click() }, "open\u2026"));
}

interface Takers {
  readonly programs: FileTaker;
  readonly machines: FileTaker;
}

// Those of a kind together, or none of them.
async function divide(files: readonly File[], { programs, machines }: Takers, isNamed: (name: string) => boolean): Promise<void> {
  const tables = await Promise.allSettled(files.filter(isToml).map(read));
  const texts = tables.flatMap((one) => (one.status === "fulfilled" ? [one.value.text] : []));
  const isMachine = (file: File): boolean => isToml(file) || (texts.length > 0 ? texts.some((text) => names(text, file.name)) : isNamed(file.name));
  await Promise.all([hand(files.filter(isMachine), machines), hand(files.filter((file) => !isMachine(file)), programs)]);
}

// Files that are dropped anywhere on the page: the browser would leave it for them, and an editor put them into its text.
// isNamed: by the present machine file.
export function takeDropped(takers: Takers, isNamed: (name: string) => boolean): void {
  const filesOf = ({ dataTransfer }: DragEvent): DataTransfer | null => (dataTransfer?.types.includes("Files") ? dataTransfer : null);
  document.addEventListener("dragover", (event) => filesOf(event) && event.preventDefault(), true);
  document.addEventListener(
    "drop",
    (event) => {
      const dropped = filesOf(event);
      if (!dropped) return;
      event.preventDefault();
      event.stopPropagation();
      void divide([...dropped.files], takers, isNamed);
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
