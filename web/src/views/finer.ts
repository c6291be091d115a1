// The ticks of the part that the charts show, where the plan has columns of several.
import type { Plan } from "../plan/plan.ts";
import type { Part, PartOf } from "../plan/source.ts";
import type { Span, Ticks } from "./columns.ts";

const REST_MS = 300; // a span that rests so long is asked for
const BUSY_MS = 1000; // after which it is asked for again where the kernel had something else to do
const REACH_TICKS = 50_000; // to either side, for the next move: most of what a part takes is the way to it

const covers = ({ first, last }: Part, { from, to }: Span): boolean => first <= from && to <= last + 1;

const partIn = (plan: Plan): Part => {
  const { firstTick, ticksPerColumn, columns } = plan.motion!;
  return { first: firstTick, last: firstTick + columns * ticksPerColumn - 1 };
};

// A part that is asked for.
interface Asked {
  readonly part: Part;
  isRefused: boolean;
}

export class Finer {
  private whole: Plan | null = null;
  private partOf: PartOf | null = null;
  private seen: Plan | null = null; // the latest part that came
  private asked: Asked | null = null; // the latest that did not
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly changed: () => void;

  // changed: there is another answer to in() or within().
  constructor(changed: () => void) {
    this.changed = changed;
  }

  show(plan: Plan | null, partOf: PartOf | null): void {
    clearTimeout(this.timer);
    this.whole = plan;
    this.seen = this.asked = null;
    this.partOf = plan?.motion && plan.motion.ticksPerColumn > 1 ? partOf : null;
  }

  get canAsk(): boolean {
    return this.partOf !== null;
  }

  // Where the span is seen best; precondition: a plan is shown.
  in(span: Span): Plan {
    return this.seen && covers(partIn(this.seen), span) ? this.seen : this.whole!;
  }

  within(span: Span): Ticks {
    if (!this.partOf) return "gone";
    if (this.in(span) !== this.whole) return "seen";
    if (!this.asked || !covers(this.asked.part, span)) return "nearer";
    return this.asked.isRefused ? "refused" : "coming";
  }

  // A chart of so many pixels shows the span.
  see(span: Span, pixels: number): void {
    clearTimeout(this.timer);
    if (this.within(span) !== "nearer") return;
    const { ticksPerColumn, lastTick } = this.whole!.motion!;
    if (span.to - span.from > pixels * ticksPerColumn) return;
    const part = { first: Math.max(0, Math.floor(span.from) - REACH_TICKS), last: Math.min(lastTick, Math.ceil(span.to) + REACH_TICKS) };
    this.timer = setTimeout(() => void this.ask(part), REST_MS);
  }

  private async ask(part: Part): Promise<void> {
    const asked: Asked = { part, isRefused: false };
    this.asked = asked;
    this.changed();
    let seen: Plan | null = null;
    try {
      seen = await this.partOf!(this.whole!, part);
    } catch {
      asked.isRefused = true;
    }
    if (asked !== this.asked) return; // it is about another part by now, or another plan
    if (seen) {
      this.seen = seen;
      this.asked = null;
    } else if (!asked.isRefused) {
      setTimeout(() => asked === this.asked && void this.ask(part), BUSY_MS);
    }
    this.changed();
  }
}
