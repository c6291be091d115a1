// The machine file, to be written here.
import { EditorState } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import { opening, writing } from "../editing.ts";
import type { TextFile } from "../plan/browser_kernel.ts";
import { linesOf } from "../views/planned_lines.ts";
import { look } from "../views/program_marks.ts";
import { h } from "./dom.ts";

export class MachineEditor {
  readonly element = h("div", { class: "machine-editor", hidden: true, "data-test": "machine" });
  private readonly view: EditorView;

  constructor(first: TextFile, changed: (machine: TextFile, isRewritten: boolean) => void) {
    const tree = this.element.appendChild(h("div", { class: "editor" })).attachShadow({ mode: "open" });
    const extensions = [writing([first], ([machine], isRewritten) => changed(machine, isRewritten)), lineNumbers(), look, EditorView.contentAttributes.of({ "aria-label": "The machine file" })];
    this.view = new EditorView({ state: EditorState.create({ doc: linesOf(first.text), extensions }), parent: tree, root: tree });
  }

  open(file: TextFile): void {
    this.view.dispatch(opening([file])(this.view.state));
  }
}
