// The present instant: play, pause, speed, and the slider that moves it.
import type { Plan } from "../plan/plan.ts";
import { SPEEDS, type Store } from "../state.ts";
import { clock } from "../units.ts";
import { h, select } from "./dom.ts";

export class PlayBar {
  readonly elements: readonly HTMLElement[];
  private readonly instant = h("span", { class: "instant", "data-test": "instant" });
  private readonly play = h("button", { type: "button", class: "play", "aria-label": "Play" }, "\u25b6");
  private readonly scrub = h("input", { type: "range", class: "scrub", min: "0", step: "1", "aria-label": "Instant" });
  private plan: Plan | null = null;
  private lastFrame_ms = 0;
  private readonly store: Store;

  constructor(store: Store) {
    this.store = store;
    this.play.addEventListener("click", () => this.toggle());
    this.scrub.addEventListener("input", () => store.set({ tick: Number(this.scrub.value), hover: null, playing: false }, "page"));
    const speed = select("Speed of playing", SPEEDS.map((one) => [String(one), `${one}\u00d7`] as const), String(store.state.speed), (value) => store.set({ speed: Number(value) }, "page"));
    this.elements = [this.play, speed, this.scrub, this.instant];
    store.listen((_state, change) => {
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("playing" in change) this.showPlaying();
    });
  }

  show(plan: Plan): void {
    this.plan = plan;
    this.scrub.max = String(this.last);
    this.showInstant();
  }

  toggle(): void {
    if (!this.plan?.motion) return;
    const { playing, tick } = this.store.state;
    const again = tick >= this.last && !playing ? { tick: 0 } : {};
    this.store.set({ playing: !playing, hover: null, ...again }, "page");
  }

  step(ticks: number): void {
    if (!this.plan?.motion) return;
    const tick = Math.min(this.last, Math.max(0, Math.round(this.store.state.tick) + ticks));
    this.store.set({ tick, hover: null, playing: false }, "page");
  }

  private get last(): number {
    return this.plan?.motion?.lastTick ?? 0;
  }

  private showInstant(): void {
    if (!this.plan) return;
    if (!this.plan.motion) {
      this.instant.textContent = "";
      delete this.instant.dataset["tick"];
      this.scrub.removeAttribute("aria-valuetext");
      return;
    }
    const tick = this.store.instant;
    this.scrub.value = String(this.store.state.tick);
    const text = `${clock(tick * this.plan.period_s)}, tick ${Math.round(tick)}, ${this.plan.placeAt(tick)}`;
    this.instant.textContent = text;
    this.scrub.setAttribute("aria-valuetext", text);
    this.instant.dataset["tick"] = String(Math.round(tick));
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
    if (!state.playing || !this.plan?.motion) return;
    const passed_s = Math.max(0, now_ms - this.lastFrame_ms) / 1000;
    this.lastFrame_ms = now_ms;
    const tick = Math.min(this.last, state.tick + (passed_s * state.speed) / this.plan.period_s);
    this.store.set(tick >= this.last ? { tick, playing: false } : { tick }, "play");
    requestAnimationFrame((now) => this.frame(now));
  }
}
