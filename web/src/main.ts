// The page: plans from a source, the views, and what links them.
import { EmbeddedSource } from "./plan/embedded.ts";
import { App } from "./app.ts";
import { h } from "./ui/dom.ts";

async function start(): Promise<void> {
  const root = document.getElementById("app")!;
  try {
    const plans = await new EmbeddedSource(document).plans();
    if (plans.length === 0) throw new Error("there is no plan in this page");
    new App(root, plans);
  } catch (error) {
    root.replaceChildren(h("div", { class: "failure", role: "alert" }, `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
    throw error;
  }
}

void start();
