// Feed, acceleration and jerk over time with their limits, and under them what limits the feed.
import uPlot from "uplot";
import { hexOf, rgbOf, visibleOn } from "../colours.ts";
import type { Plan, Quantity } from "../plan/plan.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { clock, plain, unitOf } from "../units.ts";
import { chartAfter } from "./chart_keys.ts";
import { drawnColumns, drawnLimits, type Span } from "./columns.ts";
import type { Ground } from "./ground.ts";

const QUANTITIES: readonly (readonly [Quantity, string])[] = [
  ["v", "feed"],
  ["a", "accel."],
  ["j", "jerk"],
];
const AXIS_PIXELS = 62;
const RIGHT_PIXELS = 12;
const TIME_AXIS_PIXELS = 22;
const NEAREST_TICKS = 8; // the closest zoom

// Between two marks of the time axis.
const TIME_STEPS_S = [
  ...[-5, -4, -3, -2, -1, 0].flatMap((power) => [1, 2, 5].map((digit) => digit * 10 ** power)),
  ...[10, 15, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 36000, 86400, 864000],
];
// "0.25 s", but "8:20" and "2:00:00" from a minute on.
function timeText(seconds: number): string {
  const text = seconds >= 60 ? clock(seconds) : `${Number(seconds.toPrecision(6))} s`;
  return seconds >= 60 ? text.replace(/\.0*$/, "") : text;
}

interface Chart {
  readonly quantity: Quantity;
  readonly name: HTMLElement;
  readonly value: HTMLElement;
  readonly limit: HTMLElement;
  readonly host: HTMLElement;
  plot: uPlot | null;
}

export class TimeView {
  readonly element: HTMLElement;
  private readonly charts: Chart[];
  private readonly band = h("canvas", { class: "band", "aria-hidden": "true" });
  private readonly limitNow = h("div", { class: "limit-now", "data-test": "limit-now" });
  private readonly note = h("div", { class: "note" });
  private readonly line = h("div", { class: "now-line" });
  private readonly area: HTMLElement;
  private plan: Plan | null = null;
  private span: Span = { from: 0, to: 1 };
  private scheduled = false;
  private ground: Ground;
  private readonly store: Store;

  constructor(store: Store, ground: Ground) {
    this.store = store;
    this.ground = ground;
    this.charts = QUANTITIES.map(([quantity, name]) => ({
      quantity,
      name: h("div", { class: "chart-name" }, name),
      value: h("div", { class: "chart-value", "data-test": `now-${quantity}` }),
      limit: h("div", { class: "chart-limit" }),
      host: h("div", { class: "chart-host" }),
      plot: null,
    }));
    const rows = this.charts.map((chart) =>
      h("div", { class: "chart" }, h("div", { class: "chart-label" }, chart.name, chart.value, chart.limit), chart.host),
    );
    const bandRow = h("div", { class: "chart band-row" }, h("div", { class: "chart-label" }, h("div", { class: "chart-name" }, "limited by"), this.limitNow), h("div", { class: "chart-host" }, this.band));
    this.area = h("div", { class: "charts" }, ...rows, bandRow, this.line);
    this.element = h("div", { class: "time-view", tabindex: "0", role: "application", "aria-label": "Feed, acceleration and jerk over time. Drag or wheel to zoom, double click for all; arrow keys move the instant and zoom" }, this.area, this.note);
    this.listen();
    new ResizeObserver(() => this.build()).observe(this.area);
    store.listen((_state, change) => {
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("track" in change || "units" in change) this.build();
    });
  }

  show(plan: Plan): void {
    this.plan = plan.motion ? plan : null;
    const last = Math.max(1, plan.motion?.lastTick ?? 1);
    const [from, to] = this.store.state.span ?? [0, last];
    this.span = from < last ? { from, to: Math.min(to, last) } : { from: 0, to: last };
    const perColumn = plan.motion?.ticksPerColumn ?? 1;
    this.note.textContent =
      perColumn > 1 ? `The finest level of this report is ${perColumn} ticks (${plain(perColumn * plan.period_s, 3)} s) a column; minimum and maximum are kept.` : "";
    this.build();
  }

  setGround(ground: Ground): void {
    this.ground = ground;
    this.build();
  }

  // All of the program, or as near as the wheel goes.
  zoomTo(span: Span): void {
    if (!this.plan) return;
    const last = this.plan.motion!.lastTick;
    const nearest = Math.min(NEAREST_TICKS * this.plan.motion!.ticksPerColumn, Math.max(1, last));
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
    const over = (event: MouseEvent): number | null => {
      const plot = this.charts[0]?.plot;
      if (!plot || !this.plan) return null;
      const x = event.clientX - plot.over.getBoundingClientRect().left;
      const share = x / plot.over.clientWidth;
      return share < 0 || share > 1 ? null : this.span.from + share * (this.span.to - this.span.from);
    };
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
    for (const chart of this.charts) {
      chart.plot?.destroy();
      chart.plot = null;
      chart.name.textContent = QUANTITIES.find(([quantity]) => quantity === chart.quantity)![1];
      chart.value.textContent = chart.limit.textContent = "";
    }
    if (!this.plan) {
      this.band.width = 0;
      this.limitNow.replaceChildren();
    }
    if (!this.plan || this.area.clientWidth === 0) return;
    this.charts.forEach((chart, i) => this.buildChart(chart, i === this.charts.length - 1));
    this.update();
    this.showInstant();
  }

  private buildChart(chart: Chart, isLast: boolean): void {
    const plan = this.plan!;
    const { units } = this.store.state;
    const { factor, unit } = unitOf(chart.quantity, plan.unitOf(this.track), units);
    const limit = plan.limitOf(this.track, chart.quantity);
    const pyramid = plan.series(`${this.track}.${chart.quantity}`);
    const signed = pyramid.range(0, plan.motion!.columns).min < 0;
    // By what is seen; the limit is where it is not far above that.
    const range = (): [number, number] => {
      const perColumn = plan.motion!.ticksPerColumn;
      const { min, max } = pyramid.range(this.span.from / perColumn, this.span.to / perColumn + 1);
      const peak = Math.max(Math.abs(min), Math.abs(max), 1e-9);
      const most = 1.1 * (limit !== null && limit <= 3 * peak ? Math.max(limit, peak) : peak) * factor;
      return [signed ? -most : 0, most];
    };
    chart.name.textContent = `${QUANTITIES.find(([quantity]) => quantity === chart.quantity)![1]}, ${unit}`;
    chart.limit.textContent = limit === null ? "no limit" : `limit ${plain(limit * factor)}`;
    const { ground } = this;
    const axis: uPlot.Axis = { stroke: ground.text, grid: { stroke: ground.faint, width: 0.5 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const options: uPlot.Options = {
      width: chart.host.clientWidth,
      height: chart.host.clientHeight,
      padding: [4, RIGHT_PIXELS, 2, 0],
      legend: { show: false },
      cursor: { show: true, x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
      scales: { x: { time: false, range: () => [this.span.from * plan.period_s, this.span.to * plan.period_s] }, y: { range } },
      axes: [
        { ...axis, size: isLast ? TIME_AXIS_PIXELS : 0, values: isLast ? (_u, ticks) => ticks.map(timeText) : () => [], gap: 2, space: 90, incrs: TIME_STEPS_S },
        { ...axis, size: AXIS_PIXELS, space: 18, values: (_u, ticks) => ticks.map((value) => Number(value.toPrecision(6)).toLocaleString("en").replaceAll(",", "\u2009")) },
      ],
      series: [{}, { stroke: ground.accent, width: 1.25, points: { show: false } }, { stroke: ground.accent, width: 1.25, points: { show: false } }],
      bands: [{ series: [1, 2], fill: `${ground.accent}55` }],
      hooks: {
        draw: [(u) => this.drawLimit(u, limit === null ? null : limit * factor, signed)],
        setSelect: [
          (u) => {
            if (u.select.width < 4) return;
            const size = this.span.to - this.span.from;
            const at = (pixel: number): number => this.span.from + (pixel / u.over.clientWidth) * size;
            const chosen = { from: at(u.select.left), to: at(u.select.left + u.select.width) };
            u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
            this.zoomTo(chosen);
          },
        ],
      },
    };
    chart.plot = new uPlot(options, [[], [], []], chart.host);
  }

  private drawLimit(u: uPlot, limit: number | null, signed: boolean): void {
    if (limit === null) return;
    const pen = u.ctx;
    pen.save();
    pen.strokeStyle = this.ground.dark ? "#ff9a8f" : "#b3261e";
    pen.lineWidth = window.devicePixelRatio;
    pen.setLineDash([5 * window.devicePixelRatio, 4 * window.devicePixelRatio]);
    for (const value of (signed ? [limit, -limit] : [limit]).filter((one) => Math.abs(one) <= u.scales["y"]!.max!)) {
      const y = Math.round(u.valToPos(value, "y", true)) + 0.5;
      pen.beginPath();
      pen.moveTo(u.bbox.left, y);
      pen.lineTo(u.bbox.left + u.bbox.width, y);
      pen.stroke();
    }
    pen.restore();
  }

  private update(): void {
    if (this.scheduled || !this.plan) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      const { plan, span } = this;
      if (!plan) return;
      for (const chart of this.charts) {
        if (!chart.plot) continue;
        const { factor } = unitOf(chart.quantity, plan.unitOf(this.track), this.store.state.units);
        const drawn = drawnColumns(plan, `${this.track}.${chart.quantity}`, span, chart.plot.over.clientWidth);
        const scaled = (values: Float64Array): number[] => Array.from(values, (value) => value * factor);
        chart.plot.setData([Array.from(drawn.tick, (tick) => tick * plan.period_s), scaled(drawn.max), scaled(drawn.min)]);
      }
      this.drawBand();
      this.showInstant();
    });
  }

  private drawBand(): void {
    const plot = this.charts[0]?.plot;
    if (!plot || !this.plan) return;
    const ratio = window.devicePixelRatio;
    const pixels = Math.max(1, Math.round(plot.over.clientWidth * ratio));
    this.band.width = pixels;
    this.band.height = 1;
    this.band.style.left = `${AXIS_PIXELS}px`;
    this.band.style.width = `${plot.over.clientWidth}px`;
    const pen = this.band.getContext("2d")!;
    const limits = drawnLimits(this.plan, this.span, pixels);
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
    const plot = this.charts[0]?.plot;
    this.line.hidden = !plot || !this.plan;
    if (!plot || !this.plan) return;
    const tick = this.store.instant;
    const share = (tick - this.span.from) / (this.span.to - this.span.from);
    this.line.hidden = share < 0 || share > 1;
    const left = plot.over.getBoundingClientRect().left - this.area.getBoundingClientRect().left;
    this.line.style.transform = `translateX(${left + share * plot.over.clientWidth}px)`;
    for (const chart of this.charts) {
      const { factor } = unitOf(chart.quantity, this.plan.unitOf(this.track), this.store.state.units);
      const { min, max } = this.plan.valueAt(`${this.track}.${chart.quantity}`, tick);
      // Digits below a 100,000th of the largest are the rounding of differences.
      const { min: lowest, max: highest } = this.plan.series(`${this.track}.${chart.quantity}`).range(0, this.plan.motion!.columns);
      const least = 1e-5 * Math.max(-lowest, highest);
      const text = (value: number): string => plain(Math.abs(value) < least ? 0 : value * factor, min === max ? 4 : 3);
      chart.value.textContent = min === max ? text(max) : `${text(min)}\u2026${text(max)}`;
    }
    const limit = this.plan.header.constraints[this.plan.motion!.limit[this.plan.columnAt(tick)]!];
    this.limitNow.textContent = limit?.text ?? "";
    this.limitNow.title = clock(tick * this.plan.period_s);
  }
}
