// The program's text with the time that each line takes, and errors and warnings at their lines.
import { EditorState, type Extension, type StateEffect, type Text, type TransactionSpec } from "@codemirror/state";
import { EditorView, gutter, keymap, lineNumbers, type ViewUpdate } from "@codemirror/view";
import type { Account } from "../plan/account.ts";
import type { Plan } from "../plan/plan.ts";
import type { Progress } from "../plan/source.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { inSteps } from "../ui/steps.ts";
import { CodesBar } from "./codes_bar.ts";
import { LineFollower } from "./line_follower.ts";
import { LineTimes } from "./line_times.ts";
import { linesInSteps, linesOf, plannedLines, setPlan, type PlannedLines } from "./planned_lines.ts";
import { TimeMarker, activeLine, diagnostics, look, setLine, setTimes } from "./program_marks.ts";

// Of a program that is written here.
export interface Editing {
  readonly text: string; // at first
  readonly extension: Extension; // what the editor can do
  // Is given what changes the text that is written, also while another one is looked at.
  attach(change: (change: (state: EditorState) => TransactionSpec) => void): void;
}

export class ProgramView {
  readonly element: HTMLElement;
  private readonly host = h("div", { class: "editor" });
  private readonly root: ShadowRoot;
  private readonly message = h("div", { class: "empty" });
  private readonly bar = new CodesBar();
  private readonly note = h("div", { class: "read-only", "data-test": "read-only", hidden: true }, "The text of the run that is shown, to be read only. What is written is kept.");
  private view: EditorView | null = null;
  private read: Plan | null = null; // whose text it has, where nothing is written
  private written: { readonly state: EditorState; readonly scroll: StateEffect<unknown> } | null = null; // while another text is looked at
  private plan: Plan | null = null;
  private account: Account | null = null;
  private times: LineTimes | null = null;
  private readonly follower = new LineFollower(() => this.showInstant(true));
  private readonly store: Store;
  private readonly editing: Editing | null;

  constructor(store: Store, editing: Editing | null = null) {
    this.store = store;
    this.editing = editing;
    // In a shadow tree CodeMirror's style sheets are objects, which the page's policy lets pass.
    this.root = this.host.attachShadow({ mode: "open" });
    this.element = h("div", { class: "program-view" }, this.host, this.message, this.note, this.bar.element);
    store.listen((_state, change, origin) => {
      if (!("plan" in change) && ("tick" in change || "hover" in change)) this.showInstant(origin !== "program");
    });
    // After another tab it stands still, and comes up with the instant when it is seen again.
    new ResizeObserver(() => this.showInstant(true)).observe(this.element);
  }

  show(plan: Plan, account: Account): void {
    this.plan = plan;
    this.account = account;
    this.times = new LineTimes(plan, account);
    this.host.hidden = !plan.hasSource;
    this.message.hidden = plan.hasSource;
    if (!this.editing && this.read?.header.report.file !== plan.header.report.file) this.clear();
    if (this.view && this.editing) this.turnTo(plan.source ?? "");
    else inSteps(this.build(plan), () => (this.editing ? this.view === null : this.plan === plan));
    this.showPlan(plan);
  }

  private clear(): void {
    this.view?.destroy();
    this.view = this.read = null;
  }

  // A million lines take as long as all that is seen before them; the first are shown at once.
  private *build(plan: Plan): Generator<void> {
    const { editing } = this;
    if (!editing) {
      for (const begin of plan.sourceSteps) {
        if (begin !== "") this.view ??= this.viewOf(linesOf(begin));
        yield;
      }
    }
    const source = editing?.text ?? plan.source;
    if (source === null) return;
    if (!this.view || this.read?.source !== source) {
      const lines = editing ? linesOf(source) : yield* linesInSteps(source);
      const scroll = this.view && !this.read ? this.view.scrollSnapshot() : null;
      this.clear();
      this.view = this.viewOf(lines);
      if (scroll) this.view.dispatch({ effects: scroll });
      editing?.attach((change) => this.change(change));
    }
    this.read = plan;
    this.showPlan(this.plan!);
  }

  private viewOf(lines: Text): EditorView {
    return new EditorView({ state: this.stateOf(lines, this.editing !== null), parent: this.root, root: this.root });
  }

  // What is written stays as it is; the plan of another text, which is looked at, has its own in place of it.
  private turnTo(text: string): void {
    const view = this.view!;
    const { doc } = view.state;
    const written = this.written?.state ?? view.state;
    const isWritten = [written.doc, written.field(plannedLines)?.planned].some((one) => one?.toString() === text);
    if (isWritten) this.turnBack();
    else if (doc.toString() !== text) {
      this.written ??= { state: view.state, scroll: view.scrollSnapshot() };
      view.setState(this.stateOf(linesOf(text), false));
    }
    this.note.hidden = this.written === null;
  }

  private turnBack(): void {
    if (!this.written) return;
    const { state, scroll } = this.written;
    this.written = null;
    this.note.hidden = true;
    this.view!.setState(state);
    this.view!.dispatch({ effects: scroll });
  }

  private change(change: (state: EditorState) => TransactionSpec): void {
    this.turnBack();
    this.view!.dispatch(change(this.view!.state));
  }

  // Not while the text of a plan before still stands there.
  private get lines(): PlannedLines | null {
    return this.isRead ? this.view!.state.field(plannedLines) : null;
  }

  private get isRead(): boolean {
    return this.view !== null && (this.editing !== null || this.read === this.plan);
  }

  // The line of the plan before goes: where the text stays, its editor does, too. Where somebody writes nothing moves.
  private showPlan(plan: Plan): void {
    this.follower.forget();
    const isPresent = this.editing ? this.view?.state.doc.toString() === plan.source : this.isRead;
    this.view?.dispatch({ effects: [isPresent ? setPlan.of(plan) : setTimes.of(null), setLine.of(0)] });
    this.showInstant(this.editing === null || this.root.activeElement === null);
  }

  // How far a plan is that is on its way; null: no more will come.
  showProgress(progress: Progress | null): void {
    this.times?.follow(progress);
    this.view?.dispatch({ effects: setTimes.of(null) });
  }

  private stateOf(doc: Text, isWritten: boolean): EditorState {
    const label = isWritten ? "The program" : "The program's text";
    const stepping = keymap.of([
      { key: "ArrowUp", run: () => this.step(-1) },
      { key: "ArrowDown", run: () => this.step(1) },
    ]);
    const extensions = [
      isWritten ? [this.editing!.extension, EditorView.updateListener.of((update) => this.followCaret(update))] : [EditorState.readOnly.of(true), stepping],
      lineNumbers(),
      plannedLines,
      gutter({
        class: "cm-times",
        lineMarker: (view, block) => this.marker(view.state.doc.lineAt(block.from).number),
        lineMarkerChange: (update) => update.transactions.some((one) => one.effects.some((effect) => effect.is(setPlan) || effect.is(setTimes))),
        initialSpacer: () => new TimeMarker("00.00", 0),
      }),
      activeLine,
      diagnostics,
      look,
      EditorView.contentAttributes.of({ "aria-label": label, "aria-readonly": String(!isWritten), ...(isWritten ? {} : { inputmode: "none" }) }), // no keyboard on the screen where nothing is written
      this.follower.extension,
      EditorView.domEventHandlers({
        mousedown: (event, view) => this.pointed(event, view, true),
        mousemove: (event, view) => this.pointed(event, view, false),
        mouseleave: () => {
          if (this.store.state.hover !== null) this.store.set({ hover: null }, "program");
        },
      }),
    ];
    return EditorState.create({ doc, extensions });
  }

  private marker(line: number): TimeMarker | null {
    return this.times?.markerOf(this.lines?.plannedOf(line) ?? 0) ?? null;
  }

  // The next line, in that direction, that takes time.
  private step(way: 1 | -1): boolean {
    const first = this.account?.firstTick;
    const last = this.lines?.planned.lines ?? 0;
    if (!first || last === 0) return false;
    for (let line = this.follower.line + way; line >= 1 && line <= last; line += way) {
      const tick = first.get(line);
      if (tick !== undefined) {
        this.store.set({ tick, hover: null, playing: false }, "page");
        return true;
      }
    }
    return true;
  }

  // When a line that was planned is in force: of one that takes no time, where the next begins that does.
  private tickOf(line: number): number | undefined {
    const { motion } = this.plan ?? {};
    const last = this.lines?.planned.lines ?? 0;
    if (line === 0) return undefined;
    for (; motion && line <= last; ++line) {
      const tick = this.account!.firstTick.get(line);
      if (tick !== undefined) return tick;
    }
    return motion?.lastTick;
  }

  private pointed(event: MouseEvent, view: EditorView, chosen: boolean): boolean {
    if (!chosen && (event.buttons !== 0 || this.store.state.playing)) return false;
    const at = view.posAtCoords({ x: event.clientX, y: event.clientY }, false);
    const line = this.lines?.plannedOf(view.state.doc.lineAt(at).number) ?? 0;
    const tick = this.tickOf(line);
    if (tick === undefined) return false;
    if (chosen) this.store.set({ tick, hover: null, playing: false }, "program");
    else if (line !== this.follower.line) this.store.set({ hover: tick }, "program");
    return false;
  }

  // A key that takes the caret to another line takes the instant along.
  private followCaret({ docChanged, startState, state, transactions }: ViewUpdate): void {
    const lineOf = ({ doc, selection }: EditorState): number => doc.lineAt(selection.main.head).number;
    const isByKey = transactions.some((one) => one.isUserEvent("select") && !one.isUserEvent("select.pointer"));
    if (docChanged || !isByKey || !state.selection.main.empty || lineOf(state) === lineOf(startState)) return;
    const tick = this.tickOf(this.lines?.plannedOf(lineOf(state)) ?? 0);
    if (tick !== undefined) this.store.set({ tick, hover: null, playing: false }, "program");
  }

  private showInstant(scroll: boolean): void {
    if (this.element.hidden) return;
    const { plan } = this;
    const { instant } = this.store;
    const runs = plan?.motion?.runs;
    const run = plan?.runAt(instant) ?? 0;
    // First, for the editor asks the browser where things are: a word written before has all of the page laid out for that.
    if (this.view && this.isRead) this.follower.mark(this.view, runs?.line[run] ?? 0, scroll);
    this.bar.show(plan, instant);
    if (plan?.hasSource === false) this.message.textContent = `The program's text is not in this report.${plan.motion ? ` The tool is in ${plan.placeAt(instant)}.` : ""}`;
  }
}
