// The program's text with the time that each line takes, and errors and warnings at their lines.
import { EditorState, type Extension, type StateEffect, type Text, type TransactionSpec } from "@codemirror/state";
import { EditorView, gutter, keymap, lineNumbers, type ViewUpdate } from "@codemirror/view";
import type { Account } from "../plan/account.ts";
import { ByLine, type LineNumbers } from "../plan/by_line.ts";
import { ExpectedLines } from "../plan/expected_lines.ts";
import type { Plan } from "../plan/plan.ts";
import type { Progress } from "../plan/source.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { roughTime, shortTime } from "../units.ts";
import { LineFollower } from "./line_follower.ts";
import { linesOf, plannedLines, setPlan, type PlannedLines } from "./planned_lines.ts";
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
  private readonly words = h("b", { "data-test": "words", title: "feed, spindle speed and tool in the spindle at this instant" });
  private readonly codes = h("span", { "data-test": "codes", title: "the codes in force at this instant" });
  private readonly note = h("div", { class: "read-only", "data-test": "read-only", hidden: true }, "The text of the run that is shown, to be read only. What is written is kept.");
  private view: EditorView | null = null;
  private written: { readonly state: EditorState; readonly scroll: StateEffect<unknown> } | null = null; // while another text is looked at
  private plan: Plan | null = null;
  private account: Account | null = null;
  private expectation: ExpectedLines | null = null;
  private expected: LineNumbers = new ByLine(0); // ticks of lines that are not planned to their end
  private readonly follower = new LineFollower(() => this.showInstant(true));
  private longest = 1; // ticks of the line that takes longest
  private readonly store: Store;
  private readonly editing: Editing | null;

  constructor(store: Store, editing: Editing | null = null) {
    this.store = store;
    this.editing = editing;
    // In a shadow tree CodeMirror's style sheets are objects, which the page's policy lets pass.
    this.root = this.host.attachShadow({ mode: "open" });
    this.element = h("div", { class: "program-view" }, this.host, this.message, this.note, h("div", { class: "codes" }, this.words, " ", this.codes));
    store.listen((_state, change, origin) => {
      if (!("plan" in change) && ("tick" in change || "hover" in change)) this.showInstant(origin !== "program");
    });
    // After another tab it stands still, and comes up with the instant when it is seen again.
    new ResizeObserver(() => this.showInstant(true)).observe(this.element);
  }

  show(plan: Plan, account: Account): void {
    this.plan = plan;
    this.account = account;
    this.expectation = null;
    this.expected = new ByLine(0);
    this.findLongest();
    this.host.hidden = plan.source === null;
    this.message.hidden = plan.source !== null;
    if (this.view && this.editing) this.turnTo(plan.source ?? "");
    else if (this.view?.state.doc.toString() !== (plan.source ?? undefined)) this.build(plan);
    this.showPlan(plan);
  }

  // After the next frame: to lay out a million lines takes as long as all else, and the answer and the path need not wait.
  private build(plan: Plan): void {
    const { editing } = this;
    const source = editing?.text ?? plan.source;
    this.view?.destroy();
    this.view = null;
    if (source === null) return;
    const built = (): void => {
      if (this.view || (this.plan !== plan && !editing)) return;
      this.view = new EditorView({ state: this.stateOf(linesOf(source), editing !== null), parent: this.root, root: this.root });
      editing?.attach((change) => this.change(change));
      this.showPlan(this.plan!);
    };
    requestAnimationFrame(() => setTimeout(built));
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

  private get lines(): PlannedLines | null {
    return this.view?.state.field(plannedLines) ?? null;
  }

  // The line of the plan before goes: where the text stays, its editor does, too. Where somebody writes nothing moves.
  private showPlan(plan: Plan): void {
    this.follower.forget();
    const isPresent = this.view?.state.doc.toString() === plan.source;
    this.view?.dispatch({ effects: [isPresent ? setPlan.of(plan) : setTimes.of(null), setLine.of(0)] });
    this.showInstant(this.editing === null || this.root.activeElement === null);
  }

  // The ticks of some lines of a plan that is on its way, and about what the others take.
  showLines(progress: Progress): void {
    if (!this.plan || !this.account) return;
    this.account = { ...this.account, lines: progress.lines };
    this.expectation ??= new ExpectedLines(this.plan);
    this.expect(this.expectation.at(progress));
  }

  expectNothing(): void {
    this.expect(new ByLine(0));
  }

  private expect(lines: LineNumbers): void {
    this.expected = lines;
    this.findLongest();
    this.view?.dispatch({ effects: setTimes.of(null) });
  }

  private findLongest(): void {
    this.longest = 1;
    for (const lines of [this.account?.lines, this.expected]) lines?.forEach((ticks) => (this.longest = Math.max(this.longest, ticks)));
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
    const planned = this.lines?.plannedOf(line) ?? 0;
    const expected = this.expected.get(planned);
    const ticks = expected ?? this.account?.lines.get(planned) ?? 0;
    if (ticks < 0.5) return null;
    const seconds = ticks * this.plan!.period_s;
    return new TimeMarker(expected === undefined ? shortTime(seconds) : roughTime(seconds), ticks / this.longest);
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
    if (this.view) this.follower.mark(this.view, runs?.line[run] ?? 0, scroll);
    this.words.textContent = plan?.inForceAt("words", instant) ?? "";
    this.codes.textContent = plan?.inForceAt("codes", instant) ?? "";
    if (plan?.source === null) this.message.textContent = `The program's text is not in this report.${plan.motion ? ` The tool is in ${plan.placeAt(instant)}.` : ""}`;
  }
}
