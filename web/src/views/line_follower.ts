// Takes a text along with the instant: marks its line and goes to where it is seen.
import { EditorSelection, type Extension, type SelectionRange, type StateEffect } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { plannedLines } from "./planned_lines.ts";
import { scrollWithin, setLine } from "./program_marks.ts";

const JUMP_MS = 100;

export class LineFollower {
  line = 0; // of the text that was planned; 0: none
  // The caret goes where the editor takes it.
  readonly extension: Extension = EditorView.scrollHandler.of((view, range, how) => range === this.target && scrollWithin(view, range, how));
  private target: SelectionRange | null = null;
  private later: ReturnType<typeof setTimeout> | undefined; // while the text stays where it is
  private readonly again: () => void;

  // again: marks the line of the instant anew.
  constructor(again: () => void) {
    this.again = again;
  }

  forget(): void {
    this.line = 0;
    clearTimeout(this.later);
    this.later = undefined;
  }

  // To a line that is not seen the text goes at most ten times a second: it costs the browser most of what a frame may take.
  mark(view: EditorView, line: number, scroll: boolean): void {
    if (line === this.line || this.later !== undefined) return;
    this.line = line;
    const now = view.state.field(plannedLines)?.nowOf(line) ?? 0;
    const effects: StateEffect<unknown>[] = [setLine.of(now)];
    if (scroll && now > 0) {
      const { from } = view.state.doc.line(now);
      const seen = isSeen(view, from);
      this.target = EditorSelection.cursor(from);
      // The editor may still be on its way elsewhere, so it is told of a line that is seen, too.
      effects.push(EditorView.scrollIntoView(this.target, { y: seen ? "nearest" : "center" }));
      if (!seen) this.rest();
    }
    view.dispatch({ effects });
  }

  private rest(): void {
    this.later = setTimeout(() => {
      this.later = undefined;
      this.again();
    }, JUMP_MS);
  }
}

function isSeen(view: EditorView, at: number): boolean {
  const block = view.lineBlockAt(at);
  const { scrollTop, clientHeight } = view.scrollDOM;
  return block.top >= scrollTop && block.bottom <= scrollTop + clientHeight;
}
