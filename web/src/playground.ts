// The playground: programs and machines that are written here, planned as they are typed.
import type { EditorState, TransactionSpec } from "@codemirror/state";
import { App, type Extras } from "./app.ts";
import { opening, writing } from "./editing.ts";
import { BrowserKernel, type Answer, type Order, type TextFile } from "./plan/browser_kernel.ts";
import { inflatedText } from "./plan/embedded.ts";
import type { Plan } from "./plan/plan.ts";
import { programFirst } from "./plan/program_files.ts";
import type { Part, PlanSource, Progress, Shown } from "./plan/source.ts";
import { h, select } from "./ui/dom.ts";
import { feedField } from "./ui/feed_field.ts";
import { askBeforeLeaving, opener, takeDropped, type FileTaker } from "./ui/files.ts";
import { MachineEditor } from "./ui/machine_editor.ts";
import { menu } from "./ui/menu.ts";
import { Refusal } from "./ui/refusal.ts";
import { started } from "./ui/started.ts";
import { clock } from "./units.ts";
import { pathDrawing } from "./views/path_drawing.ts";

declare const KERF_WORKER: string;
declare const KERF_EXAMPLES: readonly [TextFile, ...TextFile[]];
declare const KERF_MACHINES: readonly [TextFile, ...TextFile[]];

const PROFILES = ["time-optimal", "s-curve", "quintic", "sine", "sine-series", "sigmoid", "trapezoid"] as const;
const TYPING_MS = 250; // a text that rests so long is planned
const OLD_MS = 400; // in which most plans are there

const isSame = (a: Order, b: Order): boolean => a.files === b.files && a.machine === b.machine && a.profile === b.profile && a.feed_override === b.feed_override;

interface Planned {
  readonly order: Order;
  readonly plan: Plan;
}

class Playground implements PlanSource {
  private readonly kernel: BrowserKernel;
  private order: Order;
  private shown: Order | null = null; // whose plan is seen; null: a path alone is
  private kept: Order | null = null; // that others are compared with; null: with none
  private planned: Planned[] = [];
  private tell: (shown: Shown) => void = () => undefined;
  onProgress: (progress: Progress) => void = () => undefined; // of the path that is seen
  onNoTimes: () => void = () => undefined; // of it
  private timer: ReturnType<typeof setTimeout> | undefined;
  private aging: ReturnType<typeof setTimeout> | undefined; // since what is seen is of an order before
  private isPlanning = false;
  private rewritten = { program: false, machine: false };
  private readonly root: HTMLElement;
  private readonly status = h("output", { class: "status", "data-test": "status" });
  private readonly progress = h("span", { class: "soft", "data-test": "progress" });
  private readonly refusal = new Refusal();
  private readonly machine: MachineEditor;
  private changeProgram: (change: (state: EditorState) => TransactionSpec) => void = () => undefined;
  private readonly programs: FileTaker = {
    take: (files) => this.opened(() => this.changeProgram(opening(programFirst(files)))),
    fail: (why) => this.refusal.showUnread("files", why),
  };
  private readonly machines: FileTaker = {
    take: (files) => this.opened(() => this.machine.take(files)),
    fail: (why) => this.refusal.showUnread("machine", why),
  };

  private readonly keep = h("button", { type: "button", "aria-pressed": "false", click: () => this.toggleKept() }, "compare with this run");

  constructor(root: HTMLElement, kernel: BrowserKernel) {
    this.root = root;
    this.kernel = kernel;
    this.order = { files: [KERF_EXAMPLES[0]], machine: [KERF_MACHINES[0]], profile: PROFILES[0], feed_override: 1 };
    this.machine = new MachineEditor(KERF_MACHINES[0], (machine, isRewritten) => {
      this.rewritten.machine = isRewritten;
      this.typed({ machine });
    });
    takeDropped({ programs: this.programs, machines: this.machines }, (name) => this.machine.names(name));
    askBeforeLeaving(() => this.rewritten.program || this.rewritten.machine);
  }

  private bar(): HTMLElement {
    const pick = (all: readonly TextFile[], { take }: FileTaker) => (name: string): void => take([all.find((one) => one.name === name)!]);
    const namesOf = (all: readonly TextFile[]): string[] => all.map(({ name }) => name);
    const profile = select("Profile", PROFILES.map((name) => [name, name] as const), this.order.profile, (name) => this.change({ profile: name }));
    return h(
      "div",
      { class: "tools order" },
      h("span", {}, "Program"),
      opener("Open a program, and with it its subprograms", this.programs),
      menu("Example program", "example\u2026", namesOf(KERF_EXAMPLES), pick(KERF_EXAMPLES, this.programs)),
      h("span", {}, "Machine"),
      opener("Open a machine file, and with it the files that it names", this.machines),
      menu("Example machine", "example\u2026", namesOf(KERF_MACHINES), pick(KERF_MACHINES, this.machines)),
      h("span", {}, "Profile"),
      profile,
      ...feedField((feed_override) => this.change({ feed_override })),
      h("b", { class: "older-note" }, "shown is the run before"),
      this.status,
      this.progress,
    );
  }

  private change(change: Partial<Order>): void {
    this.changeOrder(change);
    void this.plan();
  }

  private typed(change: Partial<Order>): void {
    this.changeOrder(change);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.plan(), TYPING_MS);
  }

  // As if it was typed, but nothing more is waited for.
  private opened(open: () => void): void {
    open();
    void this.plan();
  }

  // What is seen is marked as old a moment later: most plans are there by then.
  private changeOrder(change: Partial<Order>): void {
    this.order = { ...this.order, ...change };
    for (const kind of Object.keys(change)) this.refusal.dropUnread(kind);
    this.setPlanning(true);
    this.aging ??= setTimeout(() => this.root.classList.add("older"), OLD_MS);
  }

  private renew(shown: Order | null): void {
    this.shown = shown;
    clearTimeout(this.aging);
    this.aging = undefined;
    this.root.classList.remove("older");
  }

  private setPlanning(isPlanning: boolean): void {
    this.isPlanning = isPlanning;
    this.progress.textContent = "";
    this.keep.setAttribute("aria-disabled", String(!this.canKeep));
  }

  // A run that is seen as a whole.
  private get canKeep(): boolean {
    return !this.isPlanning && (this.kept !== null || this.shown !== null);
  }

  // From now on others are compared with the run that is shown, or again with none.
  private toggleKept(): void {
    if (!this.canKeep) return;
    this.kept = this.kept ? null : this.shown;
    this.keep.setAttribute("aria-pressed", String(this.kept !== null));
    void this.plan();
  }

  async open(show: (shown: Shown) => void): Promise<void> {
    this.tell = show;
    await this.plan();
    if (!this.shown && this.refusal.text !== "") throw new Error(this.refusal.text);
  }

  private async plan(): Promise<void> {
    clearTimeout(this.timer);
    this.setPlanning(true);
    this.status.textContent = "planning\u2026";
    const { order, kept } = this;
    const answers: Answer[] = [];
    for (const one of kept && !isSame(kept, order) ? [order, kept] : [order]) {
      const answer = await this.answerTo(one);
      if (!answer || order !== this.order) return; // the next answer is on its way
      answers.push(answer);
    }
    this.show(answers, order);
  }

  private async answerTo(order: Order): Promise<Answer | null> {
    const known = this.planned.find((one) => isSame(one.order, order));
    if (known) {
      this.kernel.stop();
      return { plan: known.plan, took_s: 0 };
    }
    // What is typed by then has made it an older one, whose text is not to take the place of that.
    const isPresent = (): boolean => order === this.order;
    let isPathShown = false;
    let soFar: Progress | null = null;
    const answer = await this.kernel.plan(order, {
      showPath: (plan) => {
        if (!isPresent()) return;
        isPathShown = true;
        this.renew(null);
        this.tell({ plans: [plan], base: 0 });
        if (soFar) this.onProgress(soFar);
      },
      showProgress: (progress) => {
        if (!isPresent()) return;
        soFar = progress;
        this.progress.textContent = progress.line > 0 ? `up to line ${progress.line}` : "";
        if (isPathShown) this.onProgress(progress);
      },
    });
    if (answer && "plan" in answer) this.remember({ order, plan: answer.plan });
    return answer;
  }

  // Whoever orders a plan meanwhile goes before.
  private async partOf(plan: Plan, part: Part): Promise<Plan | null> {
    const known = this.planned.find((one) => one.plan === plan);
    if (this.isPlanning || !known) return null;
    const nobody = { showPath: () => undefined, showProgress: () => undefined };
    const answer = await this.kernel.plan({ ...known.order, part }, nobody);
    if (answer && "refused" in answer) throw new Error(answer.refused.join("\n"));
    return answer?.plan ?? null;
  }

  // The last two, and the one that others are compared with.
  private remember(planned: Planned): void {
    const { kept } = this;
    const isKept = ({ order }: Planned): boolean => kept !== null && isSame(order, kept);
    const others = this.planned.filter((one) => !isKept(one));
    this.planned = [planned, ...others.slice(0, 1), ...this.planned.filter(isKept)];
  }

  private show(answers: readonly Answer[], order: Order): void {
    const refused = answers.flatMap((answer) => ("refused" in answer ? answer.refused : []));
    const [plan, ...base] = answers.flatMap((answer) => ("plan" in answer ? [answer.plan] : []));
    this.refusal.showRefused(refused);
    if (refused.length > 0 || !plan) {
      this.setPlanning(false);
      if (!this.shown) this.onNoTimes();
      this.status.textContent = "not planned";
      return;
    }
    this.renew(order);
    this.setPlanning(false);
    const names = base.length > 0 ? { names: ["now", "before"] } : {};
    this.tell({ plans: [plan, ...base], base: base.length, partOf: (of, part) => this.partOf(of, part), ...names });
    this.status.textContent = `planned in ${clock(answers.reduce((sum, answer) => sum + ("took_s" in answer ? answer.took_s : 0), 0))}`;
  }

  // What the page has beside the plans.
  extras(): Extras {
    return {
      editing: {
        text: this.order.files[0].text,
        extension: writing(this.order.files, (files, isRewritten) => {
          this.rewritten.program = isRewritten;
          this.typed({ files });
        }),
        attach: (change) => (this.changeProgram = change),
      },
      bar: h("div", {}, this.bar(), this.refusal.element),
      panes: [["machine", "Machine", this.machine.element]],
      question: h("div", { class: "what-if" }, h("div", { class: "tools" }, this.keep)),
    };
  }
}

void started(async (root) => {
  root.replaceChildren(h("div", { class: "empty" }, "The kernel starts\u2026"));
  const drawing = pathDrawing();
  const element = document.querySelector('script[type="application/x-kerf-kernel"]')!;
  const module = await WebAssembly.compile(await inflatedText(element.textContent ?? ""));
  element.remove();
  const script = URL.createObjectURL(new Blob([KERF_WORKER], { type: "text/javascript" }));
  const playground = new Playground(root, new BrowserKernel(script, module));
  let app: App | null = null;
  playground.onProgress = (progress) => app?.showProgress(progress);
  playground.onNoTimes = () => app?.showNoTimes();
  await playground.open((shown) => {
    if (app) app.replace(shown);
    else app = new App(root, shown, drawing, playground.extras());
  });
});
