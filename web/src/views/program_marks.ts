// What the editor of a program shows beside its text: the line in force, the time of each line, errors and warnings.
import { RangeSetBuilder, StateEffect, StateField, type SelectionRange, type Text } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, WidgetType, type DecorationSet } from "@codemirror/view";
import type { Diagnostic } from "../plan/decode.ts";
import type { Plan } from "../plan/plan.ts";
import { h } from "../ui/dom.ts";
import { isReplaced, setPlan } from "./planned_lines.ts";

export const setLine = StateEffect.define<number>(); // 1-based; 0: none
export const setTimes = StateEffect.define(); // those of lines are others
export const activeLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(decorations, transaction) {
    for (const effect of transaction.effects) {
      if (!effect.is(setLine)) continue;
      const { doc } = transaction.state;
      if (effect.value < 1 || effect.value > doc.lines) return Decoration.none;
      return Decoration.set([Decoration.line({ class: "cm-now" }).range(doc.line(effect.value).from)]);
    }
    return isReplaced(transaction) ? Decoration.none : decorations.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

export class TimeMarker extends GutterMarker {
  private readonly text: string;
  private readonly share: number; // of the line that takes longest

  constructor(text: string, share: number) {
    super();
    this.text = text;
    this.share = share;
  }

  override eq(other: TimeMarker): boolean {
    return this.text === other.text && this.share === other.share;
  }

  override toDOM(): HTMLElement {
    const element = h("div", { class: "cm-time" }, this.text);
    element.style.backgroundSize = `${Math.round(100 * this.share)}% 100%`;
    return element;
  }
}

class DiagnosticWidget extends WidgetType {
  private readonly diagnostic: Diagnostic;

  constructor(diagnostic: Diagnostic) {
    super();
    this.diagnostic = diagnostic;
  }

  override eq(other: DiagnosticWidget): boolean {
    return this.diagnostic === other.diagnostic;
  }

  override toDOM(): HTMLElement {
    const { id, severity, message, remedy, column } = this.diagnostic;
    return h("div", { class: `cm-diagnostic cm-${severity}` }, h("b", {}, `${severity} ${id}`), ` ${message} (column ${column})`, h("div", { class: "cm-remedy" }, remedy));
  }
}

function diagnosticsOf(plan: Plan, doc: Text): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  const here = plan.header.diagnostics.filter((one) => one.line >= 1 && one.line <= doc.lines && one.file === plan.header.report.file);
  here.sort((a, b) => a.line - b.line);
  for (const diagnostic of here) {
    const { to } = doc.line(diagnostic.line);
    builder.add(to, to, Decoration.widget({ widget: new DiagnosticWidget(diagnostic), block: true, side: 1 }));
  }
  return builder.finish();
}

export const diagnostics = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(decorations, transaction) {
    const planned = transaction.effects.find((effect) => effect.is(setPlan));
    if (planned) return diagnosticsOf(planned.value as Plan, transaction.state.doc);
    return isReplaced(transaction) ? Decoration.none : decorations.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

// The editor would scroll the page as well, whose reader may look at something else.
export function scrollWithin(view: EditorView, range: SelectionRange, { y }: { y: string }): boolean {
  const { scrollDOM: panel } = view;
  const line = view.lineBlockAt(range.head);
  const top = line.top + view.documentPadding.top;
  const least = top + line.height - panel.clientHeight;
  panel.scrollTop = y === "center" ? (top + least) / 2 : Math.max(Math.min(panel.scrollTop, top), least);
  return true;
}

// Of any text that an editor shows.
export const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13px", color: "var(--text)", backgroundColor: "var(--panel)" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--accent)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--soft)", borderRight: "1px solid var(--line)" },
  ".cm-now": { backgroundColor: "var(--mark)", boxShadow: "inset 3px 0 0 var(--accent)" },
  ".cm-time": {
    padding: "0 6px",
    textAlign: "right",
    minWidth: "52px",
    color: "var(--told, var(--text))",
    backgroundImage: "linear-gradient(var(--mark), var(--mark))",
    backgroundRepeat: "no-repeat",
    backgroundPosition: "right",
    backgroundSize: "0 100%",
  },
  ".cm-selectionBackground": { backgroundColor: "var(--mark) !important" },
  ".cm-diagnostic": { fontFamily: "system-ui, sans-serif", padding: "4px 8px", whiteSpace: "normal", boxSizing: "border-box", maxWidth: "calc(100cqw - 110px)" },
  ".cm-error": { backgroundColor: "var(--error-ground)", color: "var(--error)" },
  ".cm-warning": { backgroundColor: "var(--warning-ground)", color: "var(--warning)" },
  ".cm-remedy": { color: "var(--text)" },
});
