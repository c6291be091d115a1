// The machine file, to be written here.
import { EditorState } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import { adding, opening, writing, type Files } from "../editing.ts";
import type { TextFile } from "../plan/browser_kernel.ts";
import { isToml, names } from "../plan/machine_files.ts";
import { linesOf } from "../views/planned_lines.ts";
import { look } from "../views/program_marks.ts";
import { h } from "./dom.ts";

export class MachineEditor {
  readonly element = h("div", { class: "machine-editor", hidden: true, "data-test": "machine" });
  private readonly view: EditorView;

  constructor(first: TextFile, changed: (machine: Files, isRewritten: boolean) => void) {
    const tree = this.element.appendChild(h("div", { class: "editor" })).attachShadow({ mode: "open" });
    const extensions = [writing([first], changed), lineNumbers(), look, EditorView.contentAttributes.of({ "aria-label": "The machine file" })];
    this.view = new EditorView({ state: EditorState.create({ doc: linesOf(first.text), extensions }), parent: tree, root: tree });
  }

  names(name: string): boolean {
    return names(this.view.state.doc.toString(), name);
  }

  // A machine file and what it names, or what the present one names.
  take(files: Files): void {
    const file = files.find(isToml) ?? files.find(({ name }) => !this.names(name));
    const change = file ? opening([file, ...files.filter((other) => other !== file)]) : adding(files);
    this.view.dispatch(change(this.view.state));
  }
}
