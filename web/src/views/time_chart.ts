// One quantity over time: what is drawn of it, its limit, and its value at the instant.
import uPlot from "uplot";
import type { Plan, Quantity } from "../plan/plan.ts";
import { clock, plain, unitOf, type Units } from "../units.ts";
import { h } from "../ui/dom.ts";
import { drawnColumns, type Span } from "./columns.ts";
import type { Ground } from "./ground.ts";

export const AXIS_PIXELS = 62;
const RIGHT_PIXELS = 12;
const TIME_AXIS_PIXELS = 22;
const HALF_LABEL_PIXELS = 7; // of the 0 at the lower end of an axis

// Between two marks of the time axis.
const TIME_STEPS_S = [
  ...[-5, -4, -3, -2, -1, 0].flatMap((power) => [1, 2, 5].map((digit) => digit * 10 ** power)),
  ...[10, 15, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 36000, 86400, 864000],
];
// "0.25 s", but "8:20" and "2:00:00" from a minute on; with the decimals that marks so far apart need.
export function timeText(seconds: number, step_s: number): string {
  if (seconds < 60) return `${Number(seconds.toPrecision(6))} s`;
  const decimals = Math.max(0, -Math.floor(Math.log10(step_s) + 1e-9));
  return clock(seconds, decimals);
}

// What all charts show.
export interface Charted {
  readonly plan: Plan;
  readonly seen: Plan; // the same, or a part of it with each tick
  readonly track: string;
  readonly units: Units;
  readonly ground: Ground;
  readonly span: Span;
}

export class TimeChart {
  readonly row: HTMLElement;
  private readonly quantity: Quantity;
  private readonly title: string;
  private readonly name = h("div", { class: "chart-name" });
  private readonly value: HTMLElement;
  private readonly limit = h("div", { class: "chart-limit" });
  private readonly host = h("div", { class: "chart-host" });
  private readonly zoomTo: (span: Span) => void;
  private plot: uPlot | null = null;
  private span: Span = { from: 0, to: 1 };
  private seen: Plan | null = null; // of what was charted last

  // zoomTo: a span has been dragged over.
  constructor(quantity: Quantity, title: string, zoomTo: (span: Span) => void) {
    this.quantity = quantity;
    this.title = title;
    this.zoomTo = zoomTo;
    this.value = h("div", { class: "chart-value", "data-test": `now-${quantity}` });
    this.row = h("div", { class: "chart" }, h("div", { class: "chart-label" }, this.name, this.value, this.limit), this.host);
    this.clear();
  }

  // Where the curve is; null: there is none.
  get over(): HTMLElement | null {
    return this.plot?.over ?? null;
  }

  clear(): void {
    this.plot?.destroy();
    this.plot = null;
    this.name.textContent = this.title;
    this.value.textContent = this.limit.textContent = "";
  }

  // hasTimes: the marks of the time stand below it.
  build(charted: Charted, hasTimes: boolean): void {
    const { plan, track, units, ground } = charted;
    this.span = charted.span;
    this.seen = charted.seen;
    const { factor, unit } = unitOf(this.quantity, plan.unitOf(track), units);
    const limit = plan.limitOf(track, this.quantity);
    this.name.textContent = `${this.title}, ${unit}`;
    this.limit.textContent = limit === null ? "no limit" : `limit ${plain(limit * factor)}`;
    const signed = plan.series(`${track}.${this.quantity}`).range(0, plan.motion!.columns).min < 0;
    const axis: uPlot.Axis = { stroke: ground.text, grid: { stroke: ground.faint, width: 0.5 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const options: uPlot.Options = {
      width: this.host.clientWidth,
      height: this.host.clientHeight,
      padding: [4, RIGHT_PIXELS, hasTimes ? 2 : HALF_LABEL_PIXELS, 0],
      legend: { show: false },
      cursor: { show: true, x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
      scales: { x: { time: false, range: () => [this.span.from * plan.period_s, this.span.to * plan.period_s] }, y: { range: () => this.rangeSeen(charted, signed) } },
      axes: [
        { ...axis, size: hasTimes ? TIME_AXIS_PIXELS : 0, values: hasTimes ? (_u, ticks, _axis, _space, step) => ticks.map((seconds) => timeText(seconds, step)) : () => [], gap: 2, space: 90, incrs: TIME_STEPS_S },
        { ...axis, size: AXIS_PIXELS, space: 18, values: (_u, ticks) => ticks.map((value) => Number(value.toPrecision(6)).toLocaleString("en").replaceAll(",", "\u2009")) },
      ],
      series: [{}, { stroke: ground.accent, width: 1.25, points: { show: false } }, { stroke: ground.accent, width: 1.25, points: { show: false } }],
      bands: [{ series: [1, 2], fill: `${ground.accent}55` }],
      hooks: {
        draw: [(u) => drawLimit(u, limit === null ? null : limit * factor, signed, ground)],
        setSelect: [(u) => this.dragged(u)],
      },
    };
    this.plot = new uPlot(options, [[], [], []], this.host);
  }

  // By what is seen; the limit is where it is not far above that.
  private rangeSeen({ plan, track, units }: Charted, signed: boolean): [number, number] {
    const seen = this.seen ?? plan;
    const { factor } = unitOf(this.quantity, plan.unitOf(track), units);
    const limit = plan.limitOf(track, this.quantity);
    const { firstTick, ticksPerColumn } = seen.motion!;
    const columnOf = (tick: number): number => (tick - firstTick) / ticksPerColumn;
    const { min, max } = seen.series(`${track}.${this.quantity}`).range(columnOf(this.span.from), columnOf(this.span.to) + 1);
    const peak = Math.max(Math.abs(min), Math.abs(max), 1e-9);
    const most = 1.1 * (limit !== null && limit <= 3 * peak ? Math.max(limit, peak) : peak) * factor;
    return [signed ? -most : 0, most];
  }

  private dragged(u: uPlot): void {
    if (u !== this.plot || u.select.width < 4) return; // one that is gone still hears where the drag ends
    const size = this.span.to - this.span.from;
    const at = (pixel: number): number => this.span.from + (pixel / u.over.clientWidth) * size;
    const chosen = { from: at(u.select.left), to: at(u.select.left + u.select.width) };
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.zoomTo(chosen);
  }

  // For another span.
  draw({ plan, seen, track, units, span }: Charted): void {
    if (!this.plot) return;
    this.span = span;
    this.seen = seen;
    const { factor } = unitOf(this.quantity, plan.unitOf(track), units);
    const drawn = drawnColumns(seen, `${track}.${this.quantity}`, span, this.plot.over.clientWidth);
    const scaled = (values: Float64Array): number[] => Array.from(values, (value) => value * factor);
    this.plot.setData([Array.from(drawn.tick, (tick) => tick * plan.period_s), scaled(drawn.max), scaled(drawn.min)]);
  }

  showInstant({ plan, seen, track, units }: Charted, tick: number): void {
    const { factor } = unitOf(this.quantity, plan.unitOf(track), units);
    const { min, max } = seen.valueAt(`${track}.${this.quantity}`, tick);
    // Digits below a 100,000th of the largest are the rounding of differences.
    const { min: lowest, max: highest } = plan.series(`${track}.${this.quantity}`).range(0, plan.motion!.columns);
    const least = 1e-5 * Math.max(-lowest, highest);
    const text = (value: number): string => plain(Math.abs(value) < least ? 0 : value * factor, min === max ? 4 : 3);
    this.value.textContent = min === max ? text(max) : `${text(min)}\u2026\u200b${text(max)}`;
  }
}

function drawLimit(u: uPlot, limit: number | null, signed: boolean, ground: Ground): void {
  if (limit === null) return;
  const pen = u.ctx;
  pen.save();
  pen.strokeStyle = ground.dark ? "#ff9a8f" : "#b3261e";
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
