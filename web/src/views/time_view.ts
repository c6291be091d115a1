// Feed, acceleration and jerk over time with their limits, and under them what limits the feed.
import { hexOf, rgbOf, visibleOn } from "../colours.ts";
import type { Plan } from "../plan/plan.ts";
import type { PartOf } from "../plan/source.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { clock } from "../units.ts";
import { chartAfter } from "./chart_keys.ts";
import { listenToFingers } from "./chart_touch.ts";
import { drawnLimits, finenessText, type Span } from "./columns.ts";
import { Finer } from "./finer.ts";
import type { Ground } from "./ground.ts";
import { AXIS_PIXELS, TimeChart, type Charted } from "./time_chart.ts";

const NEAREST_TICKS = 8; // the closest zoom

export class TimeView {
  readonly element: HTMLElement;
  private readonly charts: readonly TimeChart[];
  private readonly band = h("canvas", { class: "band", "aria-hidden": "true" });
  private readonly limitNow = h("div", { class: "limit-now", "data-test": "limit-now" });
  private readonly note = h("div", { class: "note" });
  private readonly line = h("div", { class: "now-line" });
  private readonly area: HTMLElement;
  private plan: Plan | null = null;
  private readonly finer = new Finer(() => this.update());
  private span: Span = { from: 0, to: 1 };
  private curves: { left: number; width: number } | null = null; // where they are in the area, in pixels; null: nowhere
  private scheduled = false;
  private ground: Ground;
  private readonly store: Store;

  constructor(store: Store, ground: Ground) {
    this.store = store;
    this.ground = ground;
    const zoomTo = (span: Span): void => this.zoomTo(span);
    this.charts = [new TimeChart("v", "feed", zoomTo), new TimeChart("a", "accel.", zoomTo), new TimeChart("j", "jerk", zoomTo)];
    const bandRow = h("div", { class: "chart band-row" }, h("div", { class: "chart-label" }, h("div", { class: "chart-name" }, "limited by"), this.limitNow), h("div", { class: "chart-host" }, this.band));
    this.area = h("div", { class: "charts" }, ...this.charts.map((chart) => chart.row), bandRow, this.line);
    this.element = h("div", { class: "time-view", tabindex: "0", role: "application", "aria-label": "Feed, acceleration and jerk over time. Drag, wheel or two fingers to zoom, double click for all; arrow keys move the instant and zoom" }, this.area, this.note);
    this.listen();
    new ResizeObserver(() => this.build()).observe(this.area);
    store.listen((_state, change) => {
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("track" in change || "units" in change) this.build();
    });
  }

  // partOf: of plans with columns of several ticks; null: there is nobody to ask.
  show(plan: Plan, partOf: PartOf | null): void {
    this.plan = plan.motion ? plan : null;
    this.finer.show(this.plan, partOf);
    const last = Math.max(1, plan.motion?.lastTick ?? 1);
    if (this.plan && (this.store.state.span?.[0] ?? 0) >= last) this.store.set({ span: null }, "time"); // it ends before
    const [from, to] = this.store.state.span ?? [0, last];
    this.span = { from: Math.min(from, last), to: Math.min(to, last) };
    this.showNote(plan);
    this.build();
  }

  private showNote(plan: Plan): void {
    this.note.textContent = finenessText(plan, this.finer.within(this.span));
  }

  setGround(ground: Ground): void {
    this.ground = ground;
    this.build();
  }

  // All of the program, or as near as the wheel goes.
  zoomTo(span: Span): void {
    if (!this.plan || Number.isNaN(span.from + span.to)) return;
    const last = this.plan.motion!.lastTick;
    const ticks = NEAREST_TICKS * (this.finer.canAsk ? 1 : this.plan.motion!.ticksPerColumn);
    const nearest = Math.min(ticks, Math.max(1, last));
    const size = Math.min(Math.max(span.to - span.from, nearest), Math.max(1, last));
    const from = Math.min(Math.max(0, span.from), Math.max(0, last - size));
    this.span = { from, to: from + size };
    this.store.set({ span: size >= last ? null : [from, from + size] }, "time");
    this.update();
  }

  private get track(): string {
    const { track } = this.store.state;
    return this.plan?.tracks.includes(track) ? track : "path";
  }

  private listen(): void {
    const shareAt = (event: MouseEvent): number | null => {
      const curve = this.charts[0]!.over;
      if (!curve || !this.plan) return null;
      const share = (event.clientX - curve.getBoundingClientRect().left) / curve.clientWidth;
      return share < 0 || share > 1 ? null : share;
    };
    const over = (event: MouseEvent): number | null => {
      const share = shareAt(event);
      return share === null ? null : this.span.from + share * (this.span.to - this.span.from);
    };
    listenToFingers(this.area, shareAt, () => this.span, (span) => this.zoomTo(span));
    let pressed: number | null = null;
    this.area.addEventListener("pointermove", (event) => {
      const tick = over(event);
      if (tick === null || this.store.state.playing) return;
      this.store.set({ hover: Math.round(tick) }, "time");
    });
    this.area.addEventListener("pointerleave", () => {
      if (this.store.state.hover !== null) this.store.set({ hover: null }, "time");
    });
    this.area.addEventListener("pointerdown", (event) => (pressed = event.clientX));
    this.area.addEventListener("click", (event) => {
      const tick = over(event);
      if (tick !== null && pressed !== null && Math.abs(event.clientX - pressed) < 4) {
        this.store.set({ tick: Math.round(tick), hover: null, playing: false }, "time");
      }
    });
    this.element.addEventListener("keydown", (event) => this.key(event));
    this.area.addEventListener("dblclick", () => this.zoomTo({ from: 0, to: Infinity }));
    this.area.addEventListener(
      "wheel",
      (event) => {
        const tick = over(event);
        if (tick === null) return;
        event.preventDefault();
        const size = this.span.to - this.span.from;
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
          const way = (Math.sign(event.deltaX || event.deltaY) * size) / 12;
          this.zoomTo({ from: this.span.from + way, to: this.span.to + way });
          return;
        }
        const factor = 1.25 ** Math.sign(event.deltaY);
        this.zoomTo({ from: tick - (tick - this.span.from) * factor, to: tick + (this.span.to - tick) * factor });
      },
      { passive: false },
    );
  }

  private key(event: KeyboardEvent): void {
    if (!this.plan || event.ctrlKey || event.metaKey || event.altKey) return;
    const after = chartAfter(event.key, event.shiftKey, { tick: this.store.state.tick, span: this.span, last: this.plan.motion!.lastTick });
    if (!after) return;
    event.preventDefault();
    this.zoomTo(after.span);
    if (after.tick !== this.store.state.tick) this.store.set({ tick: after.tick, hover: null, playing: false }, "time");
  }

  // The charts anew: for another size, track, unit or theme.
  private build(): void {
    for (const chart of this.charts) chart.clear();
    if (!this.plan) {
      this.band.width = 0;
      this.limitNow.replaceChildren();
      this.line.hidden = true;
    }
    this.curves = null;
    if (!this.plan || this.area.clientWidth === 0) return;
    const charted = this.charted(this.plan);
    this.charts.forEach((chart, i) => chart.build(charted, i === this.charts.length - 1));
    this.update();
    this.showInstant();
  }

  private charted(plan: Plan): Charted {
    return { plan, seen: this.finer.in(this.span), track: this.track, units: this.store.state.units, ground: this.ground, span: this.span };
  }

  private update(): void {
    if (this.scheduled || !this.plan) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      if (!this.plan) return;
      const charted = this.charted(this.plan);
      for (const chart of this.charts) chart.draw(charted);
      this.showNote(this.plan);
      this.measure();
      this.drawBand();
      this.showInstant();
      this.finer.see(this.span, this.charts[0]!.over?.clientWidth ?? 0);
    });
  }

  // Where the charts lie: they do so a moment after they are built.
  private measure(): void {
    const curve = this.charts[0]!.over?.getBoundingClientRect();
    this.curves = curve ? { left: curve.left - this.area.getBoundingClientRect().left, width: curve.width } : null;
  }

  private drawBand(): void {
    const curve = this.charts[0]!.over;
    if (!curve || !this.plan) return;
    const ratio = window.devicePixelRatio;
    const pixels = Math.max(1, Math.round(curve.clientWidth * ratio));
    this.band.width = pixels;
    this.band.height = 1;
    this.band.style.left = `${AXIS_PIXELS}px`;
    this.band.style.width = `${curve.clientWidth}px`;
    const pen = this.band.getContext("2d")!;
    const limits = drawnLimits(this.finer.in(this.span), this.span, pixels);
    let begin = 0;
    for (let i = 1; i <= pixels; ++i) {
      if (i < pixels && limits[i] === limits[begin]) continue;
      const constraint = this.plan.header.constraints[limits[begin]!];
      if (constraint) {
        pen.fillStyle = hexOf(visibleOn(rgbOf(constraint.colour), this.ground.rgb));
        pen.fillRect(begin, 0, i - begin, 1);
      }
      begin = i;
    }
  }

  private showInstant(): void {
    const { curves } = this;
    this.line.hidden = !curves || !this.plan;
    if (!curves || !this.plan) return;
    const tick = this.store.instant;
    const share = (tick - this.span.from) / (this.span.to - this.span.from);
    this.line.hidden = share < 0 || share > 1;
    this.line.style.transform = `translateX(${curves.left + share * curves.width}px)`;
    const seen = this.finer.in({ from: tick, to: tick });
    const charted = { ...this.charted(this.plan), seen };
    for (const chart of this.charts) chart.showInstant(charted, tick);
    const limit = this.plan.header.constraints[seen.motion!.limit[seen.columnAt(tick)]!];
    this.limitNow.textContent = limit?.text ?? "";
    this.limitNow.title = clock(tick * this.plan.period_s);
  }
}
