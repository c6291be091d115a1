// The views of a page, and what links them.
import { rgbOf } from "./colours.ts";
import { accountOf, type Account } from "./plan/account.ts";
import type { Plan } from "./plan/plan.ts";
import type { Progress, Shown } from "./plan/source.ts";
import { Store, fromFragment, initialState, type ColourBy } from "./state.ts";
import { Address } from "./ui/address.ts";
import { h, replaceKeepingFocus } from "./ui/dom.ts";
import { Header, namesOf } from "./ui/header.ts";
import { PlayBar } from "./ui/play_bar.ts";
import { Tabs, type Pane } from "./ui/tabs.ts";
import { unitsNamed } from "./units.ts";
import { AnswerView } from "./views/answer_view.ts";
import { DifferenceView, type Named } from "./views/difference_view.ts";
import { legendOf } from "./views/legend.ts";
import type { Ground } from "./views/ground.ts";
import { SIDES } from "./views/path_camera.ts";
import { coloursOf } from "./views/path_colours.ts";
import type { PathDrawing } from "./views/path_drawing.ts";
import { PathView } from "./views/path_view.ts";
import { ProgramView, type Editing } from "./views/program_view.ts";
import { TimeView } from "./views/time_view.ts";

const COLOUR_NAMES: Record<ColourBy, string> = {
  feed: "feed",
  limit: "what limits the feed",
  acceleration: "acceleration of its limit",
  jerk: "jerk of its limit",
  deviation: "deviation from the program",
  tool: "tool",
  following: "following error",
};

// What a page has beside its plans.
export interface Extras {
  readonly editing?: Editing; // of the program's text
  readonly bar?: HTMLElement; // below the header
  readonly panes?: readonly Pane[]; // beside program and answer
  readonly question?: HTMLElement; // what makes the other plan; above the difference
}

export class App {
  private readonly store: Store;
  private shown: Shown;
  private readonly accounts = new WeakMap<Plan, Account>();
  private readonly extras: Extras;
  private readonly header: Header;
  private readonly path: PathView | null;
  private readonly time: TimeView;
  private readonly program: ProgramView;
  private readonly answer: AnswerView;
  private readonly difference: DifferenceView;
  private readonly playBar: PlayBar;
  private readonly main = h("main", {});
  private readonly legend = h("div", { class: "legend-corner" });
  private readonly colour = h("select", { "aria-label": "Colour of the path" });
  private readonly tracks = h("select", { "aria-label": "Along the path, or an axis" });
  private readonly tabs: Tabs;
  private readonly address: Address;

  constructor(root: HTMLElement, shown: Shown, drawing: PathDrawing | null, extras: Extras = {}) {
    this.shown = shown;
    this.extras = extras;
    const usual = unitsNamed(shown.plans[0].header.feed_unit ?? "");
    this.store = new Store({ ...initialState(), ...fromFragment(location.hash, usual) });
    this.address = new Address(this.store, usual);
    const { state } = this.store;
    state.plan = Math.min(state.plan, shown.plans.length - 1);
    this.applyTheme();
    const ground = this.ground();
    this.header = new Header(this.store, extras.editing === undefined);
    // The first to hear of an instant: it asks the browser where things are, before others have changed them.
    this.program = new ProgramView(this.store, extras.editing ?? null);
    this.path = drawing && new PathView(drawing, this.store, ground);
    this.time = new TimeView(this.store, ground);
    this.answer = new AnswerView(this.store);
    this.difference = new DifferenceView(this.store);
    this.playBar = new PlayBar(this.store);
    this.tabs = this.makeTabs();
    root.replaceChildren(this.header.element, ...(extras.bar ? [extras.bar] : []), this.answer.strip, this.main);
    this.main.append(this.spacePanel(), this.timePanel(), this.sidePanel());
    this.path?.avoid(this.legend);
    this.listen();
    this.show();
  }

  // Other plans in place of those that are shown.
  replace(shown: Shown): void {
    const [before, now] = [this.shown, shown].map(({ plans }) => plans[0].header.report.file);
    this.shown = shown;
    this.store.replacePlans(before === now, "page");
  }

  // Of the plan that is shown, as long as its times are not there.
  showProgress(progress: Progress): void {
    this.answer.showProgress(progress);
    this.program.showProgress(progress);
  }

  // They will not come.
  showNoTimes(): void {
    this.answer.showProgress("none");
    this.program.showProgress(null);
  }

  private get plan(): Plan {
    return this.shown.plans[this.store.state.plan]!;
  }

  private get isDark(): boolean {
    const { theme } = this.store.state;
    return theme === "auto" ? matchMedia("(prefers-color-scheme: dark)").matches : theme === "dark";
  }

  private applyTheme(): void {
    document.documentElement.dataset["theme"] = this.isDark ? "dark" : "light";
  }

  private ground(): Ground {
    const style = getComputedStyle(document.documentElement);
    const of = (name: string): string => style.getPropertyValue(name).trim();
    return { rgb: rgbOf(of("--panel")), dark: this.isDark, accent: of("--accent"), faint: of("--line"), text: of("--soft") };
  }

  private spacePanel(): HTMLElement {
    const { path } = this;
    const sides = SIDES.map((side) => h("button", { type: "button", "data-side": side, click: () => path?.look(side) }, side));
    const fit = h("button", { type: "button", click: () => path?.fit() }, "fit");
    this.colour.addEventListener("change", () => this.store.set({ colourBy: this.colour.value as ColourBy, shown: null }, "page"));
    this.colour.dataset["test"] = "colour";
    const tools = h("div", { class: "tools" }, ...sides, fit, h("label", {}, "colour ", this.colour));
    const view = path?.element ?? h("div", { class: "empty" }, "The path cannot be drawn: this browser has no WebGL.");
    return h("section", { class: "panel space-panel", "aria-label": "Path" }, tools, view, this.legend);
  }

  private timePanel(): HTMLElement {
    this.tracks.addEventListener("change", () => this.store.set({ track: this.tracks.value }, "page"));
    const all = h("button", { type: "button", click: () => this.time.zoomTo({ from: 0, to: Infinity }) }, "all");
    const near = h("button", { type: "button", title: "Zoom to 0.2 s about the instant", click: () => this.zoomNear(this.store.state.tick) }, "near");
    return h("section", { class: "panel time-panel", "aria-label": "Time" }, h("div", { class: "tools" }, ...this.playBar.elements, this.tracks, near, all), this.time.element);
  }

  private zoomNear(tick: number): void {
    const half = 0.1 / this.plan.period_s;
    this.time.zoomTo({ from: tick - half, to: tick + half });
  }

  private makeTabs(): Tabs {
    const { question } = this.extras;
    const difference = h("div", { class: "compared" }, ...(question ? [question] : []), this.difference.element);
    const panes: Pane[] = [
      ["program", "Program", this.program.element],
      ["answer", "Answer in full", this.answer.details],
      ["difference", "Difference", difference],
      ...(this.extras.panes ?? []),
    ];
    const tabs = new Tabs("Beside the path", panes, (name) => {
      this.store.set({ tab: name }, "page");
      if (name === "difference") this.difference.build();
    });
    this.store.state.tab = tabs.show(this.store.state.tab);
    return tabs;
  }

  private sidePanel(): HTMLElement {
    return h("section", { class: "panel side", "aria-label": "Program and answer" }, this.tabs.list, this.tabs.content);
  }

  private listen(): void {
    this.store.listen((state, change, origin) => {
      if ("plan" in change) this.show();
      if ("theme" in change) this.retheme();
      if ("shown" in change || "units" in change) this.showLegend();
      if ("tab" in change && origin === "answer") this.tabs.show(state.tab);
      if (!state.playing) this.address.keep();
    });
    if (this.path) this.path.onColouring = () => this.showLegend();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.retheme());
    document.addEventListener("keydown", (event) => this.key(event));
    // A link to another place of the same page; what somebody writes in it would be lost.
    if (!this.extras.editing) window.addEventListener("hashchange", () => location.reload());
  }

  private retheme(): void {
    this.applyTheme();
    this.path?.setGround(this.ground());
    this.time.setGround(this.ground());
  }

  private accountOf(plan: Plan): Account {
    let account = this.accounts.get(plan);
    if (!account) this.accounts.set(plan, (account = accountOf(plan)));
    return account;
  }

  private show(): void {
    const { plan } = this;
    const { state } = this.store;
    if (plan.motion) state.tick = Math.min(state.tick, plan.motion.lastTick); // else it waits for times
    this.header.show(plan, this.shown);
    this.main.classList.toggle("still", plan.path === null && !this.extras.editing);
    this.main.classList.toggle("timeless", plan.path !== null && plan.motion === null && !this.extras.editing);
    const colours = coloursOf(plan);
    this.colour.replaceChildren(...colours.map((by) => h("option", { value: by }, COLOUR_NAMES[by])));
    this.colour.value = colours.includes(state.colourBy) ? state.colourBy : "feed";
    this.colour.disabled = plan.motion === null;
    this.tracks.replaceChildren(...plan.tracks.map((track) => h("option", { value: track }, track === "path" ? "along the path" : `axis ${track.toUpperCase()}`)));
    this.tracks.value = plan.tracks.includes(state.track) ? state.track : "path";
    this.playBar.show(plan);
    this.answer.show(plan, this.accountOf(plan), this.shown);
    this.program.show(plan, this.accountOf(plan));
    this.path?.show(plan);
    this.time.show(plan, this.shown.partOf ?? null);
    this.showDifference();
    this.showLegend();
    this.path?.restore(state.camera);
  }

  // Of the shown plan from the base; while the base is shown, of the first other one.
  private showDifference(): void {
    const { plans, base } = this.shown;
    this.store.state.tab = this.tabs.setHidden("difference", plans.length < 2 && !this.extras.question);
    const names = namesOf(this.shown);
    const named = (i: number): Named => ({ plan: plans[i]!, account: this.accountOf(plans[i]!), name: names[i]! });
    const other = this.store.state.plan === base ? plans.findIndex((_, i) => i !== base) : this.store.state.plan;
    this.difference.show(other < 0 ? null : { base: named(base), other: named(other), shown: this.plan });
  }

  private showLegend(): void {
    const { colouring } = this.path ?? {};
    const { path, motion } = this.plan;
    const ticks = motion?.lastTick ?? path?.tick[path.tick.length - 1] ?? 0;
    replaceKeepingFocus(this.legend, ...(colouring && path ? [legendOf(colouring, this.store, this.isDark, ticks)] : []));
  }

  private key(event: KeyboardEvent): void {
    // Seen from outside, the target of an event in a shadow tree is its host.
    const target = event.composedPath()[0] as HTMLElement;
    const takesText = target.matches("input:not([type=range]), select, textarea") || (this.extras.editing && target.isContentEditable);
    if (event.ctrlKey || event.metaKey || event.altKey || takesText || document.querySelector("dialog[open]")) return;
    const actions: Record<string, () => void> = {
      " ": () => this.playBar.toggle(),
      ",": () => this.playBar.step(-1),
      ".": () => this.playBar.step(1),
      f: () => this.path?.fit(),
      "1": () => this.path?.look("top"),
      "2": () => this.path?.look("front"),
      "3": () => this.path?.look("right"),
      "4": () => this.path?.look("iso"),
    };
    const action = actions[event.key.toLowerCase()];
    if (!action || (event.key === " " && /^(button|summary)$/i.test(target.tagName))) return;
    event.preventDefault();
    action();
  }
}
