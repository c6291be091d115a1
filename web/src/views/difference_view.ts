// Two runs side by side: all of their time, by what the machine does, by limit and by line.
import { SPLIT_NAMES, splitOf, total } from "../plan/split.ts";
import { largestFirst, limitRows, lineRows, type LineRow, type Ran, type Row } from "../plan/difference.ts";
import type { Plan } from "../plan/plan.ts";
import type { Store } from "../state.ts";
import { h, replaceKeepingFocus, select, table } from "../ui/dom.ts";
import { clock, difference, wordsOf } from "../units.ts";

const ROWS_AT_ONCE = 200;

export interface Named extends Ran {
  readonly name: string;
}

export interface Pair {
  readonly base: Named; // what the other one is compared with
  readonly other: Named;
  readonly shown: Plan; // one of them: the instant is of this one
}

const spanText = (first: number, last: number): string => (last < first ? "" : last === first ? String(first) : `${first} to ${last}`);

// Of the first of some lines that takes time.
function firstTickOf({ account }: Ran, first: number, last: number): number | undefined {
  for (let line = first; line <= last; ++line) {
    const tick = account.firstTick.get(line);
    if (tick !== undefined) return tick;
  }
  return undefined;
}

export class DifferenceView {
  readonly element = h("section", { class: "details", tabindex: "0", "aria-label": "Two runs side by side" });
  private pair: Pair | null = null;
  private rows: LineRow[] = [];
  private inOrder = false;
  private drawn = ROWS_AT_ONCE;
  private readonly lines = h("div", {});
  private readonly store: Store;

  constructor(store: Store) {
    this.store = store;
  }

  // What is compared is looked for once it is to be seen: it takes seconds for a million lines.
  show(pair: Pair | null): void {
    this.pair = pair;
    this.element.replaceChildren();
    if (this.element.offsetParent !== null) this.build();
  }

  build(): void {
    const { pair } = this;
    if (!pair || this.element.firstChild) return;
    const dead = [pair.base, pair.other].find(({ plan }) => plan.cycle_s === undefined);
    if (dead) {
      this.element.append(h("p", { class: "empty" }, `${dead.name} ${dead.plan.endsEarly ? "ends early" : "does not run"}: there is nothing to compare.`));
      return;
    }
    this.rows = lineRows(pair.base, pair.other);
    this.drawn = ROWS_AT_ONCE;
    const order = select("Order of the lines", [["difference", "largest difference first"], ["program", "as in the program"]] as const, this.inOrder ? "program" : "difference", (value) => {
      this.inOrder = value === "program";
      this.drawn = ROWS_AT_ONCE;
      this.drawLines();
    });
    this.element.append(this.wholeTable(pair), this.part("By limit", this.limitTable(pair)), this.part("By line", order, this.lines));
    this.drawLines();
  }

  private part(title: string, ...children: Node[]): HTMLElement {
    return h("div", { class: "part-of-answer" }, h("h3", {}, title), ...children);
  }

  private cells = ({ base_s, other_s }: Row): (string | Node)[] => [clock(base_s), clock(other_s), h("span", { class: other_s > base_s ? "bad" : "good" }, difference(base_s, other_s))];

  private wholeTable({ base, other }: Pair): HTMLElement {
    const [before, after] = [splitOf(base.plan.header.report), splitOf(other.plan.header.report)];
    const part = (name: string, base_s: number, other_s: number): (string | Node)[] => [name, ...this.cells({ base_s, other_s })];
    const kinds = SPLIT_NAMES.filter(([kind]) => before[kind] + after[kind] > 0);
    return table(["", base.name, other.name, "difference"], [part("cycle time", total(before), total(after)), ...kinds.map(([kind, name]) => part(name, before[kind], after[kind]))], "difference-whole");
  }

  private limitTable({ base, other }: Pair): HTMLElement {
    return table(["limit", base.name, other.name, "difference"], limitRows(base.plan, other.plan).map((row) => [wordsOf(row.key), ...this.cells(row)]), "difference-limits");
  }

  private drawLines(): void {
    const { rows } = this;
    const { base, other } = this.pair!;
    const shown = (this.inOrder ? rows : largestFirst(rows)).slice(0, this.drawn);
    const more = rows.length - shown.length;
    replaceKeepingFocus(
      this.lines,
      table(["line", "program", base.name, other.name, "difference"], shown.map((row) => [this.lineName(row), h("code", {}, row.text), ...this.cells(row)]), "difference-lines"),
      ...(more > 0 ? [h("button", { type: "button", click: () => this.drawMore() }, `${more} more lines`)] : []),
    );
  }

  private drawMore(): void {
    this.drawn *= 4;
    this.drawLines();
  }

  // "12", "12 → 14" where they are not the same, "20 to 24 → 22", and which of them is missing.
  private lineName({ base, baseLast, other, otherLast }: LineRow): Node | string {
    const [from, to] = [spanText(base, baseLast), spanText(other, otherLast)];
    const text = from === to ? from : from === "" ? `+ ${to}` : to === "" ? `\u2212 ${from}` : `${from} \u2192 ${to}`;
    const { shown, base: before, other: after } = this.pair!;
    const tick = shown === before.plan ? firstTickOf(before, base, baseLast) : firstTickOf(after, other, otherLast);
    if (tick === undefined) return text;
    return h("button", { type: "button", class: "link", click: () => this.store.set({ tick, hover: null, playing: false }, "answer") }, text);
  }
}
