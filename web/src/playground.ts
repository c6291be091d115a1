// The playground: programs and machines that are written here, planned as they are typed.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { EditorState } from "@codemirror/state";
import { EditorView, keymap, lineNumbers } from "@codemirror/view";
import { App } from "./app.ts";
import { BrowserKernel, type Answer, type Order, type TextFile } from "./plan/browser_kernel.ts";
import { inflatedText } from "./plan/embedded.ts";
import type { Plan } from "./plan/plan.ts";
import { h, select } from "./ui/dom.ts";
import { clock } from "./units.ts";
import { look } from "./views/program_view.ts";

declare const KERF_WORKER: string;
declare const KERF_EXAMPLES: readonly [TextFile, ...TextFile[]];
declare const KERF_MACHINES: readonly [TextFile, ...TextFile[]];

const PROFILES = ["time-optimal", "s-curve", "quintic", "sine", "sine-series", "sigmoid", "trapezoid"] as const;
const TYPING_MS = 250; // a text that rests so long is planned

const writing = [history(), keymap.of([...defaultKeymap, ...historyKeymap])];

class Playground {
  private readonly kernel: BrowserKernel;
  private order: Order;
  private app: App | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly root: HTMLElement;
  private readonly status = h("output", { class: "status", "data-test": "status" });
  private readonly refusal = h("div", { class: "refusal", role: "alert", hidden: true });
  private readonly machine: EditorView;
  private readonly machineHost = h("div", { class: "machine-editor", hidden: true, "data-test": "machine" });

  constructor(root: HTMLElement, kernel: BrowserKernel) {
    this.root = root;
    this.kernel = kernel;
    this.order = { files: [KERF_EXAMPLES[0]], machine: KERF_MACHINES[0], profile: PROFILES[0] };
    const editor = this.machineHost.appendChild(h("div", { class: "editor" }));
    const tree = editor.attachShadow({ mode: "open" });
    this.machine = new EditorView({ state: this.machineState(), parent: tree, root: tree });
  }

  private machineState(): EditorState {
    return EditorState.create({
      doc: this.order.machine.text,
      extensions: [
        writing,
        lineNumbers(),
        look,
        EditorView.contentAttributes.of({ "aria-label": "The machine file" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) this.typed({ machine: { ...this.order.machine, text: update.state.doc.toString() } });
        }),
      ],
    });
  }

  private bar(): HTMLElement {
    const named = (files: readonly TextFile[]): [string, string][] => [["", "example\u2026"], ...files.map(({ name }): [string, string] => [name, name])];
    const examples = select("Example program", named(KERF_EXAMPLES), "", (name) => this.change({ files: [KERF_EXAMPLES.find((one) => one.name === name) ?? KERF_EXAMPLES[0]] }));
    const machines = select("Example machine", named(KERF_MACHINES), "", (name) => this.setMachine(KERF_MACHINES.find((one) => one.name === name) ?? KERF_MACHINES[0]));
    for (const choice of [examples, machines]) choice.addEventListener("change", () => (choice.value = ""));
    const profile = select("Profile", PROFILES.map((name) => [name, name] as const), this.order.profile, (name) => this.change({ profile: name }));
    return h(
      "div",
      { class: "tools order" },
      h("span", {}, "Program"),
      this.opener("Open a program, and with it its subprograms", true, ([first, ...others]) => this.change({ files: [first!, ...others] })),
      examples,
      h("span", {}, "Machine"),
      this.opener("Open a machine file", false, ([first]) => this.setMachine(first!)),
      machines,
      h("span", {}, "Profile"),
      profile,
      this.status,
    );
  }

  // A button that reads files of the visitor's; they stay in this page.
  private opener(label: string, several: boolean, take: (files: TextFile[]) => void): HTMLElement {
    const input = h("input", { type: "file", multiple: several, hidden: true, "aria-label": label });
    input.addEventListener("change", () => {
      const chosen = [...(input.files ?? [])];
      input.value = "";
      if (chosen.length > 0) void Promise.all(chosen.map(async (file) => ({ name: file.name, text: await file.text() }))).then(take);
    });
    return h("span", {}, input, h("button", { type: "button", title: label, click: () => input.click() }, "open\u2026"));
  }

  private setMachine(machine: TextFile): void {
    this.order = { ...this.order, machine };
    this.machine.setState(this.machineState());
    void this.plan();
  }

  private change(change: Partial<Order>): void {
    this.order = { ...this.order, ...change };
    void this.plan();
  }

  private typed(change: Partial<Order>): void {
    this.order = { ...this.order, ...change };
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.plan(), TYPING_MS);
  }

  async plan(): Promise<void> {
    clearTimeout(this.timer);
    this.status.textContent = "planning\u2026";
    const { order } = this;
    const answer = await this.kernel.plan(order);
    if (answer && order === this.order) this.show(answer); // else the next answer is on its way
  }

  private show(answer: Answer): void {
    this.refusal.hidden = !("refused" in answer);
    if ("refused" in answer) {
      this.status.textContent = "not planned";
      this.refusal.textContent = answer.refused.join("\n");
      return;
    }
    this.status.textContent = `planned in ${clock(answer.took_s)}`;
    this.showPlan(answer.plan);
  }

  private showPlan(plan: Plan): void {
    if (this.app) {
      this.app.replace([plan]);
      return;
    }
    this.app = new App(this.root, [plan], {
      editing: {
        extension: writing,
        changed: (text) => {
          const [program, ...others] = this.order.files;
          if (text !== program.text) this.typed({ files: [{ name: program.name, text }, ...others] });
        },
      },
      bar: h("div", {}, this.bar(), this.refusal),
      panes: [["machine", "Machine", this.machineHost]],
    });
  }
}

async function start(): Promise<void> {
  const root = document.getElementById("app")!;
  try {
    root.replaceChildren(h("div", { class: "empty" }, "The kernel starts\u2026"));
    const element = document.querySelector('script[type="application/x-kerf-kernel"]')!;
    const module = await WebAssembly.compile(await inflatedText(element.textContent ?? ""));
    element.remove();
    const script = URL.createObjectURL(new Blob([KERF_WORKER], { type: "text/javascript" }));
    await new Playground(root, new BrowserKernel(script, module)).plan();
  } catch (error) {
    root.replaceChildren(h("div", { class: "failure", role: "alert" }, `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
    throw error;
  }
}

void start();
