// The views of a page, and what links them.
import { rgbOf } from "./colours.ts";
import { accountOf, type Account } from "./plan/account.ts";
import type { Plan } from "./plan/plan.ts";
import { COLOURS, Store, fromFragment, initialState, toFragment, type ColourBy, type Theme } from "./state.ts";
import { aboutBox } from "./ui/about.ts";
import { choice, h, select } from "./ui/dom.ts";
import { clock } from "./units.ts";
import { AnswerView } from "./views/answer_view.ts";
import { legendOf } from "./views/legend.ts";
import type { Ground } from "./views/ground.ts";
import { PathView, SIDES } from "./views/path_view.ts";
import { ProgramView, type Editing } from "./views/program_view.ts";
import { TimeView } from "./views/time_view.ts";

const COLOUR_NAMES: Record<ColourBy, string> = {
  feed: "feed",
  limit: "what limits the feed",
  acceleration: "acceleration of its limit",
  jerk: "jerk of its limit",
  tool: "tool",
  following: "following error",
};
const SPEEDS = ["0.01", "0.1", "0.25", "1", "4", "20", "100"] as const;

function nameOf(plan: Plan): string {
  return plan.header.report.file.split("/").pop() ?? plan.header.report.file;
}

// What a page has beside its plans.
export interface Extras {
  readonly editing?: Editing; // of the program's text
  readonly bar?: HTMLElement; // below the header
  readonly panes?: readonly (readonly [name: string, text: string, HTMLElement])[]; // beside program and answer
}

export class App {
  private readonly store: Store;
  private plans: readonly Plan[];
  private accounts: (Account | undefined)[];
  private readonly extras: Extras;
  private readonly path: PathView | null;
  private readonly time: TimeView;
  private readonly program: ProgramView;
  private readonly answer: AnswerView;
  private readonly main = h("main", {});
  private readonly title = h("h1", {});
  private readonly what = h("div", { class: "what" });
  private readonly legend = h("div", {});
  private readonly instant = h("output", { class: "instant", "data-test": "instant" });
  private readonly play = h("button", { type: "button", class: "play", "aria-label": "Play" }, "\u25b6");
  private readonly scrub = h("input", { type: "range", class: "scrub", min: "0", step: "1", "aria-label": "Instant" });
  private readonly tracks = h("select", { "aria-label": "Along the path, or an axis" });
  private lastFrame_ms = 0;

  constructor(root: HTMLElement, plans: readonly Plan[], extras: Extras = {}) {
    this.plans = plans;
    this.extras = extras;
    this.accounts = new Array<Account | undefined>(plans.length);
    this.store = new Store({ ...initialState(), ...fromFragment(location.hash) });
    const { state } = this.store;
    state.plan = Math.min(state.plan, plans.length - 1);
    this.applyTheme();
    const ground = this.ground();
    this.path = this.makePath(ground);
    this.time = new TimeView(this.store, ground);
    this.program = new ProgramView(this.store, extras.editing ?? null);
    this.answer = new AnswerView(this.store);
    root.replaceChildren(this.header(), ...(extras.bar ? [extras.bar] : []), this.answer.strip, this.main);
    this.main.append(this.spacePanel(), this.timePanel(), this.sidePanel());
    this.listen();
    this.show();
  }

  // Other plans in place of those that are shown.
  replace(plans: readonly Plan[]): void {
    this.plans = plans;
    this.accounts = new Array<Account | undefined>(plans.length);
    this.store.set({ plan: 0, hover: null, playing: false }, "page");
  }

  private makePath(ground: Ground): PathView | null {
    try {
      return new PathView(this.store, ground);
    } catch {
      return null; // no WebGL: the panel says so, all else works
    }
  }

  private get plan(): Plan {
    return this.plans[this.store.state.plan]!;
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

  private header(): HTMLElement {
    const { state } = this.store;
    const length = choice("Lengths in", [["mm", "mm"], ["inch", "inch"]] as const, state.units.length, (value) => {
      length.set(value);
      this.store.set({ units: { ...state.units, length: value } }, "page");
    });
    const per = choice("Feeds per", [["min", "/min"], ["s", "/s"]] as const, state.units.time, (value) => {
      per.set(value);
      this.store.set({ units: { ...state.units, time: value } }, "page");
    });
    const theme = select<Theme>("Theme", [["auto", "auto"], ["light", "light"], ["dark", "dark"]], state.theme, (value) => this.store.set({ theme: value }, "page"));
    const about = aboutBox();
    const help = h("button", { type: "button", click: () => about.showModal() }, "About");
    const several = this.plans.length > 1 ? this.planChoice() : null;
    this.store.listen((changed) => {
      if (several) several.value = String(changed.plan);
    });
    return h("header", {}, this.title, this.what, several, length.element, per.element, theme, help, about);
  }

  private planChoice(): HTMLSelectElement {
    const names = this.plans.map((plan, i) => {
      const { cycle_time_s: seconds, machine } = plan.header.report;
      const where = machine === "default" ? "" : `, ${machine.split("/").pop()}`;
      return [String(i), `${nameOf(plan)}${where}: ${seconds === undefined ? "does not run" : clock(seconds)}`] as const;
    });
    return select("Program", names, String(this.store.state.plan), (value) => this.store.set({ plan: Number(value), tick: 0, hover: null, shown: null, camera: "", playing: false }, "page"));
  }

  private spacePanel(): HTMLElement {
    const { path } = this;
    const { state } = this.store;
    const sides = SIDES.map((side) => h("button", { type: "button", "data-side": side, click: () => path?.look(side) }, side));
    const fit = h("button", { type: "button", click: () => path?.fit() }, "fit");
    const colour = select("Colour of the path", COLOURS.map((by) => [by, COLOUR_NAMES[by]] as const), state.colourBy, (value) => this.store.set({ colourBy: value, shown: null }, "page"));
    colour.dataset["test"] = "colour";
    const tools = h("div", { class: "tools" }, ...sides, fit, h("label", {}, "colour ", colour));
    const view = path?.element ?? h("div", { class: "empty" }, "The path cannot be drawn: this browser has no WebGL.");
    return h("section", { class: "panel space-panel", "aria-label": "Path" }, tools, view, this.legend);
  }

  private timePanel(): HTMLElement {
    const { state } = this.store;
    this.play.addEventListener("click", () => this.togglePlay());
    this.scrub.addEventListener("input", () => this.store.set({ tick: Number(this.scrub.value), hover: null, playing: false }, "page"));
    this.tracks.addEventListener("change", () => this.store.set({ track: this.tracks.value }, "page"));
    const speed = select("Speed of playing", SPEEDS.map((one) => [one, `${one}\u00d7`] as const), "1", (value) => this.store.set({ speed: Number(value) }, "page"));
    const all = h("button", { type: "button", click: () => this.time.zoomTo({ from: 0, to: Infinity }) }, "all");
    const near = h("button", { type: "button", title: "Zoom to 0.2 s about the instant", click: () => this.zoomNear(state.tick) }, "near");
    return h("section", { class: "panel time-panel", "aria-label": "Time" }, h("div", { class: "tools" }, this.play, speed, this.scrub, this.instant, this.tracks, near, all), this.time.element);
  }

  private zoomNear(tick: number): void {
    const half = 0.1 / this.plan.period_s;
    this.time.zoomTo({ from: tick - half, to: tick + half });
  }

  private sidePanel(): HTMLElement {
    const panes = [["program", "Program", this.program.element], ["answer", "Answer in full", this.answer.details], ...(this.extras.panes ?? [])] as const;
    const content = h("div", { class: "content" }, ...panes.map(([, , pane]) => pane));
    const tabs = panes.map(([name, text]) => h("button", { type: "button", role: "tab", "data-tab": name, click: () => choose(name) }, text));
    const choose = (name: string): void => {
      panes.forEach(([one, , pane], i) => {
        pane.hidden = one !== name;
        tabs[i]!.setAttribute("aria-selected", String(one === name));
      });
    };
    choose("program");
    return h("section", { class: "panel side", "aria-label": "Program and answer" }, h("div", { class: "tools", role: "tablist" }, ...tabs), content);
  }

  private listen(): void {
    this.store.listen((state, change) => {
      if ("plan" in change) this.show();
      if ("theme" in change) this.retheme();
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("playing" in change) this.showPlaying();
      if ("shown" in change || "units" in change) this.showLegend();
      if (!state.playing) this.keepFragment();
    });
    if (this.path) this.path.onColouring = () => this.showLegend();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.retheme());
    document.addEventListener("keydown", (event) => this.key(event));
  }

  private retheme(): void {
    this.applyTheme();
    this.path?.setGround(this.ground());
    this.time.setGround(this.ground());
  }

  private show(): void {
    const { plan } = this;
    const { report } = plan.header;
    const { state } = this.store;
    state.tick = Math.min(state.tick, plan.motion?.lastTick ?? 0);
    this.title.textContent = nameOf(plan);
    this.title.title = report.file;
    document.title = `${nameOf(plan)} \u2013 Kerf`;
    this.what.textContent = `${report.machine === "default" ? "default machine" : report.machine.split("/").pop()}, ${report.profile}${plan.source === null ? "" : ", with the program\u2019s text"}`;
    this.main.classList.toggle("still", plan.motion === null && !this.extras.editing);
    this.scrub.max = String(plan.motion?.lastTick ?? 0);
    this.tracks.replaceChildren(...plan.tracks.map((track) => h("option", { value: track }, track === "path" ? "along the path" : `axis ${track.toUpperCase()}`)));
    this.tracks.value = plan.tracks.includes(state.track) ? state.track : "path";
    const account = (this.accounts[state.plan] ??= accountOf(plan));
    this.answer.show(plan, account, this.plans);
    this.program.show(plan, account);
    this.path?.show(plan);
    this.time.show(plan);
    // The panels have their size by now.
    requestAnimationFrame(() => this.path?.restore(state.camera));
    this.showInstant();
    this.showLegend();
  }

  private showInstant(): void {
    const { store } = this;
    const tick = store.instant;
    this.scrub.value = String(store.state.tick);
    const seconds = clock(tick * this.plan.period_s);
    const line = this.plan.motion ? this.plan.motion.runs.line[this.plan.runAt(tick)] ?? 0 : 0;
    this.instant.textContent = `${seconds}, tick ${Math.round(tick)}, line ${line}`;
    this.instant.dataset["tick"] = String(Math.round(tick));
  }

  private showLegend(): void {
    const { colouring } = this.path ?? {};
    this.legend.replaceChildren(...(colouring && this.plan.motion ? [legendOf(colouring, this.store, this.isDark, this.plan.motion.lastTick)] : []));
  }

  private keepFragment(): void {
    const fragment = toFragment(this.store.state);
    if (this.store.state.hover === null && location.hash.slice(1) !== fragment) history.replaceState(null, "", `#${fragment}`);
  }

  private togglePlay(): void {
    const { state } = this.store;
    const last = this.plan.motion?.lastTick ?? 0;
    const atEnd = state.tick >= last;
    this.store.set({ playing: !state.playing, hover: null, ...(atEnd && !state.playing ? { tick: 0 } : {}) }, "page");
  }

  private showPlaying(): void {
    const { playing } = this.store.state;
    this.play.textContent = playing ? "\u275a\u275a" : "\u25b6";
    this.play.setAttribute("aria-label", playing ? "Pause" : "Play");
    if (playing) {
      this.lastFrame_ms = performance.now();
      requestAnimationFrame((now) => this.frame(now));
    }
  }

  private frame(now_ms: number): void {
    const { state } = this.store;
    if (!state.playing || !this.plan.motion) return;
    const passed_s = Math.max(0, now_ms - this.lastFrame_ms) / 1000;
    this.lastFrame_ms = now_ms;
    const tick = Math.min(this.plan.motion.lastTick, state.tick + (passed_s * state.speed) / this.plan.period_s);
    this.store.set(tick >= this.plan.motion.lastTick ? { tick, playing: false } : { tick }, "play");
    requestAnimationFrame((now) => this.frame(now));
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || /^(input|select|textarea)$/i.test(target.tagName)) return;
    const step = (ticks: number): void => {
      const tick = Math.min(this.plan.motion?.lastTick ?? 0, Math.max(0, Math.round(this.store.state.tick) + ticks));
      this.store.set({ tick, hover: null, playing: false }, "page");
    };
    const actions: Record<string, () => void> = {
      " ": () => this.togglePlay(),
      ",": () => step(-1),
      ".": () => step(1),
      f: () => this.path?.fit(),
      "1": () => this.path?.look("top"),
      "2": () => this.path?.look("front"),
      "3": () => this.path?.look("right"),
      "4": () => this.path?.look("iso"),
    };
    const action = actions[event.key];
    if (!action || (event.key === " " && target.tagName === "BUTTON")) return;
    event.preventDefault();
    action();
  }
}

