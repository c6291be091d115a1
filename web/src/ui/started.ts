// How a page begins, and what it says where it cannot.
import { h } from "./dom.ts";

export async function started(start: (root: HTMLElement) => Promise<void>): Promise<void> {
  const root = document.getElementById("app")!;
  try {
    await start(root);
  } catch (error) {
    root.replaceChildren(h("div", { class: "failure", role: "alert" }, `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
    throw error;
  }
}
