// A report: the plans that are embedded in it.
import { App } from "./app.ts";
import { EmbeddedSource } from "./plan/embedded.ts";
import { started } from "./ui/started.ts";
import { pathDrawing, warmUp } from "./views/path_drawing.ts";

void started(async (root) => {
  const drawing = pathDrawing(); // its shaders are compiled while the plans are read
  await new EmbeddedSource(document).open((shown) => {
    if (drawing) warmUp(drawing);
    new App(root, shown, drawing);
  });
});
