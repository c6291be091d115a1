// A report: the plans that are embedded in it.
import { App } from "./app.ts";
import { EmbeddedSource } from "./plan/embedded.ts";
import { started } from "./ui/started.ts";

void started(async (root) => {
  await new EmbeddedSource(document).open((shown) => new App(root, shown));
});
