// The answer: how long, does it fit, how close to the limits, how exact, which lines cost most.
import type { Account } from "../plan/account.ts";
import { countText, errorCount, messagesOf } from "../plan/messages.ts";
import type { Plan } from "../plan/plan.ts";
import type { Shown } from "../plan/source.ts";
import { SPLIT_NAMES, operationsOf, splitOf, toolsOf, total, type Split } from "../plan/split.ts";
import { usesOf } from "../plan/uses.ts";
import type { Store } from "../state.ts";
import { h, replaceKeepingFocus, table } from "../ui/dom.ts";
import { cycleText, machineOf, nameOf, numbered } from "../ui/header.ts";
import { MM_PER_INCH, clock, difference, lengthUnit, percent, plain, unitOf, wordsOf } from "../units.ts";
import { QUANTITY_NAMES, constraintsTable, offsetsTable, partsTable, planTable, usesTable } from "./answer_tables.ts";
import { fitCard } from "./fit_card.ts";
import { waitingTexts, type Waited } from "./waiting.ts";

// What to change where a constraint costs time.
const REMEDIES: readonly (readonly [RegExp, string])[] = [
  [/^rest$/, "a dwell, a spindle start or an event: the tool stands"],
  [/^programmed_feedrate$/, "a higher F would save time"],
  [/^chord_error$/, "a wider chord tolerance of the machine would save time"],
  [/^joint$/, "direction or curvature jumps there: G64 with a larger P rounds it"],
  [/^window_end$/, "the look-ahead ends there: a wider one (--window of kerf) would save time"],
  [/_velocity$/, "the machine's speed: only a faster axis helps"],
  [/_acceleration$/, "the machine's acceleration: a gentler path or a faster machine"],
  [/_jerk$/, "the machine's jerk: a smoother path or a stiffer machine"],
];
const remedyOf = (key: string): string => REMEDIES.find(([pattern]) => pattern.test(key))?.[1] ?? "";

function bar(split: Split): HTMLElement {
  const all = total(split);
  const parts = SPLIT_NAMES.filter(([kind]) => split[kind] > 0).map(([kind, name]) => {
    const part = h("span", { class: `part ${kind}`, title: `${name} ${clock(split[kind])}` });
    part.style.flexGrow = String(split[kind] / all);
    return part;
  });
  return h("div", { class: "bar" }, ...parts);
}

export class AnswerView {
  readonly strip = h("section", { class: "strip", "aria-label": "The answer" });
  readonly details = h("section", { class: "details", tabindex: "0", "aria-label": "The answer in full" });
  private plan: Plan | null = null;
  private shown: Shown | null = null;
  private account: Account | null = null;
  private progress: Waited = null; // of a plan that is on its way
  private readonly store: Store;

  constructor(store: Store) {
    this.store = store;
    store.listen((_state, change) => {
      if ("units" in change) this.build();
    });
  }

  // shown: all that stand side by side, this one among them.
  show(plan: Plan, account: Account, shown: Shown): void {
    this.shown = shown;
    this.plan = plan;
    this.account = account;
    this.progress = null;
    this.build();
  }

  // Of a plan whose path is shown.
  showProgress(progress: Waited): void {
    this.progress = progress;
    this.strip.firstElementChild?.replaceWith(this.waitingCard());
  }

  private lineButton(line: number, text = `line ${line}`): HTMLElement {
    const tick = this.account!.firstTick.get(line);
    if (tick === undefined) return h("span", {}, text);
    return h("button", { type: "button", class: "link", "aria-label": `line ${line}`, click: () => this.store.set({ tick, hover: null, playing: false }, "answer") }, text);
  }

  private build(): void {
    if (!this.plan || !this.account) return;
    this.strip.replaceChildren(...this.cards());
    this.strip.classList.toggle("stopped", this.plan.motion === null);
    replaceKeepingFocus(this.details, ...this.sections());
  }

  private card(title: string, test: string, ...children: (Node | string | null)[]): HTMLElement {
    return h("div", { class: "card", "data-test": test }, h("h2", {}, title), ...children);
  }

  private cards(): HTMLElement[] {
    const plan = this.plan!;
    if (!plan.motion && plan.header.report.exit_status === 0) {
      return [this.waitingCard(), this.fitCard()];
    }
    if (!plan.motion) {
      const messages = messagesOf(plan);
      const failed = this.card("Does not run", "failed", h("div", { class: "big bad" }, errorCount(messages)), h("div", { class: "soft" }, messages.first));
      return plan.header.extents ? [failed, this.fitCard()] : [failed];
    }
    const figures = plan.header.report.max ? [this.limitsCard(), this.exactCard()] : [];
    return [plan.endsEarly ? this.earlyEndCard() : this.timeCard(), this.fitCard(), ...figures, this.linesCard()].filter((card): card is HTMLElement => card !== null);
  }

  private waitingCard(): HTMLElement {
    const [whole, soFar] = waitingTexts(this.progress, this.plan!.period_s);
    return this.card("Cycle time", "planning", h("div", { class: "big", "data-test": "estimate" }, whole), h("div", { class: "soft", "data-test": "so-far" }, soFar));
  }

  // What ran until then is shown, but its time is no cycle time.
  private earlyEndCard(): HTMLElement {
    const { first } = messagesOf(this.plan!);
    return this.card("Ends early", "failed", h("div", { class: "big bad" }, `after ${clock(this.plan!.motion!.lastTick * this.plan!.period_s)}`), h("div", { class: "soft" }, first));
  }

  private timeCard(): HTMLElement {
    const whole = splitOf(this.plan!.header.report);
    const keys = SPLIT_NAMES.filter(([kind]) => whole[kind] > 0 || kind === "cut" || kind === "rapid").map(([kind, name]) =>
      h("span", { class: "key" }, h("i", { class: `part ${kind}` }), `${name} `, h("b", { "data-test": `time-${kind}` }, clock(whole[kind]))),
    );
    const seconds = this.plan!.header.report.cycle_time_s ?? 0;
    const text = this.differenceOf(this.plan!);
    const more = text === "" ? null : h("span", { class: `more ${text.startsWith("+") ? "bad" : "good"}`, "data-test": "time-difference", title: "against the run that it is compared with" }, text);
    return this.card("Cycle time", "cycle", h("div", { class: "big" }, h("span", { "data-test": "cycle-time" }, clock(seconds)), more), bar(whole), h("div", { class: "keys" }, ...keys));
  }

  private fitCard(): HTMLElement {
    return fitCard(this.plan!, this.store.state.units, () => this.store.set({ tab: "answer" }, "answer"));
  }

  private limitsCard(): HTMLElement {
    const uses = usesOf(this.plan!);
    const { units } = this.store.state;
    const rows = (["v", "a", "j"] as const).flatMap((quantity) => {
      const of = uses.filter((use) => use.quantity === quantity && use.limit !== null).sort((a, b) => b.share - a.share)[0];
      if (!of) return [];
      const { factor, unit } = unitOf(quantity, this.plan!.unitOf(of.track), units);
      const meter = h("span", { class: "meter" }, h("i", { class: of.share > 1.005 ? "over" : "" }));
      (meter.firstChild as HTMLElement).style.width = `${Math.min(100, 100 * of.share)}%`;
      return [h("div", { class: "use" }, h("span", {}, quantity === "a" ? "accel." : QUANTITY_NAMES[quantity]), meter, h("b", {}, percent(of.share)), h("span", { class: "soft" }, `${of.track === "path" ? "path" : of.track.toUpperCase()} ${plain(of.peak * factor)} ${unit}`))];
    });
    return this.card("Largest, of its limit", "limits", h("div", { class: "uses" }, ...rows));
  }

  private exactCard(): HTMLElement {
    const { report, machine } = this.plan!.header;
    const { units } = this.store.state;
    const deviation = report.deviation;
    const max = deviation?.max_mm ?? 0;
    const small = (mm: number): string => (units.length === "mm" ? `${plain(1000 * mm, 3)} \u00b5m` : `${plain(mm / MM_PER_INCH, 2)} in`);
    const where = deviation?.line === undefined || max === 0 ? null : h("div", {}, `of ${small(deviation.tolerance_mm ?? 0)} allowed, `, this.lineButton(deviation.line));
    const chord = report.chord_error_mm ?? 0;
    const chordText = `chord error ${small(chord)}${machine.chord_tolerance_mm ? `, ${percent(chord / machine.chord_tolerance_mm)}` : ""}`;
    return this.card("Off the programmed path", "deviation", h("div", { class: "big" }, max < 5e-7 ? "nothing" : small(max)), h("div", { class: "soft rows" }, where, h("div", {}, chordText), h("div", {}, `table off the path ${small(report.contour_error?.max_mm ?? 0)}`)));
  }

  private linesCard(): HTMLElement | null {
    const line = this.plan!.header.report.speed_limits_of_lines?.[0];
    if (!line) return null;
    const key = Object.keys(line.limits)[0] ?? "";
    const share = line.time_s / (this.plan!.motion!.lastTick * this.plan!.period_s);
    return this.card("Costs most", "slowest", h("div", { class: "big" }, this.lineButton(line.line)), h("div", { class: "soft rows" }, h("div", {}, `${clock(line.time_s)}, ${percent(share)} of the time`), h("div", {}, `mostly ${wordsOf(key)}`), h("div", {}, remedyOf(key))));
  }

  private sections(): HTMLElement[] {
    const plan = this.plan!;
    const parts: HTMLElement[] = [];
    const add = (title: string, ...children: (Node | string)[]): void => void parts.push(h("div", { class: "part-of-answer" }, h("h3", {}, title), ...children));
    const { report } = plan.header;
    const messages = messagesOf(plan);
    const texts = [...messages.errors, ...messages.warnings];
    if (texts.length > 0) add(countText(messages), h("ul", { "data-test": "messages" }, ...texts.map((text) => h("li", {}, text))));
    const { units } = this.store.state;
    const told = plan.header.messages ?? [];
    if (told.length > 0) add("What the program tells the operator", h("ul", { "data-test": "told" }, ...told.map(({ line, text }) => h("li", {}, this.lineButton(line), `: ${text}`))));
    if (this.shown!.plans.length > 1) add("Side by side", this.othersTable());
    const addOffsets = (): void => add(`Where the work offset may lie, ${lengthUnit(units)}`, offsetsTable(plan, units));
    if (!plan.motion) {
      if (plan.header.extents) addOffsets();
      return parts;
    }
    if (report.speed_limits_of_lines?.length) add("Lines that cost most", this.linesTable());
    add("What limits the feed", constraintsTable(plan));
    const tools = toolsOf(report);
    const operations = operationsOf(report);
    if (tools.length > 1 || splitOf(report).toolChange > 0) add("By tool", partsTable("tool", tools));
    if (operations.length > 0) add("By operation, as the comments name them", partsTable("operation", operations));
    addOffsets();
    if (report.max) add("Largest figures", usesTable(plan, units));
    add("The plan", planTable(plan, units));
    return parts;
  }

  // Each with its difference from the base.
  private othersTable(): HTMLElement {
    const { plans, base } = this.shown!;
    const names = this.shown!.names ?? numbered(plans.map(nameOf), plans.map((plan) => `${nameOf(plan)}, ${plan.header.report.machine}`));
    return table(
      ["program", "machine", "time", "difference"],
      plans.map((plan, i) => {
        const name = h("button", { type: "button", class: "link", click: () => this.store.showPlan(i, "answer") }, names[i]!);
        return [name, machineOf(plan), cycleText(plan), i === base ? "" : this.differenceOf(plan)];
      }),
      "side-by-side",
    );
  }

  // From the base; empty where one of the two does not run to its end.
  private differenceOf(plan: Plan): string {
    const [before, after] = [this.shown!.plans[this.shown!.base], plan].map((one) => one?.cycle_s);
    return before === undefined || after === undefined ? "" : difference(before, after);
  }

  private linesTable(): HTMLElement {
    const lines = this.plan!.header.report.speed_limits_of_lines ?? [];
    return table(
      ["line", "time", "limited by", ""],
      lines.map((line) => {
        const [key, share] = Object.entries(line.limits)[0] ?? ["", { share: 0 }];
        return [this.lineButton(line.line, String(line.line)), clock(line.time_s), `${wordsOf(key)} ${percent(share.share)}`, remedyOf(key)];
      }),
      "lines",
    );
  }
}
