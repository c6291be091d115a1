// The ticks of the part that the charts show, where the plan has columns of several.
import type { Plan } from "../plan/plan.ts";
import type { PartOf } from "../plan/source.ts";
import type { Span } from "./columns.ts";

const REST_MS = 300; // a span that rests so long is asked for
const REACH_TICKS = 50_000; // to either side, for the next move: most of what a part takes is the way to it

const covers = (plan: Plan, span: Span): boolean => {
  const { firstTick, ticksPerColumn, columns } = plan.motion!;
  return firstTick <= span.from && span.to <= firstTick + columns * ticksPerColumn;
};

export class Finer {
  private whole: Plan | null = null;
  private partOf: PartOf | null = null;
  private part: Plan | null = null;
  private last: Span | null = null; // that was to be seen: what was refused is not asked for again and again
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asked = 0; // how often: an answer counts for the last time alone
  private waits = false;
  private readonly changed: () => void;

  // changed: there is another answer to in(), or isAsking.
  constructor(changed: () => void) {
    this.changed = changed;
  }

  show(plan: Plan | null, partOf: PartOf | null): void {
    this.forget();
    this.whole = plan;
    this.part = this.last = null;
    this.partOf = plan?.motion && plan.motion.ticksPerColumn > 1 ? partOf : null;
  }

  get canAsk(): boolean {
    return this.partOf !== null;
  }

  get isAsking(): boolean {
    return this.waits;
  }

  // Where the span is seen best; precondition: a plan is shown.
  in(span: Span): Plan {
    return this.part && covers(this.part, span) ? this.part : this.whole!;
  }

  // A chart of so many pixels shows the span.
  see(span: Span, pixels: number): void {
    if (span === this.last) return;
    this.last = span;
    clearTimeout(this.timer);
    const { partOf, whole } = this;
    if (!partOf || !whole || this.in(span) !== whole) return;
    const { ticksPerColumn, lastTick } = whole.motion!;
    if (span.to - span.from > pixels * ticksPerColumn) return;
    const part = { first: Math.max(0, Math.floor(span.from) - REACH_TICKS), last: Math.min(lastTick, Math.ceil(span.to) + REACH_TICKS) };
    this.timer = setTimeout(() => void this.ask(partOf(whole, part)), REST_MS);
  }

  private async ask(answer: Promise<Plan | null>): Promise<void> {
    const turn = ++this.asked;
    this.waits = true;
    this.changed();
    const part = await answer;
    if (turn !== this.asked) return;
    this.waits = false;
    this.part = part ?? this.part;
    this.changed();
  }

  private forget(): void {
    clearTimeout(this.timer);
    ++this.asked;
    this.waits = false;
  }
}
