// What the hand points at in the view of the path: the instant, its line and place.
import type { Matrix4 } from "three";
import type { Plan } from "../plan/plan.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { lengthText, lengthUnit } from "../units.ts";
import { pointingOf, tickNear } from "./pick.ts";

const PICK_PIXELS = 12;

export class PathPointer {
  readonly tip = h("div", { class: "tip", hidden: true });
  private plan: Plan | null = null;
  private readonly store: Store;
  private readonly canvas: HTMLElement;
  private readonly projection: () => Matrix4;

  constructor(store: Store, canvas: HTMLElement, projection: () => Matrix4) {
    this.store = store;
    this.canvas = canvas;
    this.projection = projection;
    let moved: PointerEvent | null = null;
    canvas.addEventListener("pointermove", (event) => {
      if (moved === null) {
        requestAnimationFrame(() => {
          if (moved) this.hover(moved);
          moved = null;
        });
      }
      moved = event;
    });
    canvas.addEventListener("pointerleave", () => {
      moved = null;
      this.leave();
    });
    store.listen((state, change, origin) => {
      if (state.playing || (origin !== "path" && change.hover === null)) this.tip.hidden = true;
    });
    let down: [number, number] = [0, 0];
    canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    canvas.addEventListener("click", (event) => {
      const way = Math.hypot(event.clientX - down[0], event.clientY - down[1]);
      const tick = way < 4 ? this.pick(event) : null;
      if (tick !== null) store.set({ tick, hover: null, playing: false }, "path");
    });
  }

  // null: nothing can be pointed at.
  show(plan: Plan | null): void {
    this.plan = plan;
    this.tip.hidden = true;
  }

  // The tick at which the tool passes nearest to the pointer; null: nowhere near it.
  private pick(event: MouseEvent): number | null {
    if (!this.plan?.motion) return null;
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const pointing = pointingOf(this.projection().elements, { width, height }, { x: event.clientX - left, y: event.clientY - top });
    return tickNear(this.plan.motion.path, pointing, PICK_PIXELS);
  }

  private hover(event: PointerEvent): void {
    if (event.buttons !== 0 || this.store.state.playing) return;
    const tick = this.pick(event);
    if (tick === null) {
      this.leave();
      return;
    }
    this.showTip(event, tick);
    this.store.set({ hover: tick }, "path"); // after the tip, which asks for its size: so nothing else is laid out for that
  }

  private showTip(event: PointerEvent, tick: number): void {
    const { units } = this.store.state;
    const at = this.plan!.positionAt(tick);
    this.tip.textContent = `${this.plan!.placeAt(tick)}   ${at.map((mm, k) => `${"XYZ"[k]} ${lengthText(mm, units)}`).join("  ")} ${lengthUnit(units)}`;
    this.tip.hidden = false;
    const rect = this.canvas.getBoundingClientRect();
    const left = Math.min(event.clientX - rect.left + 14, rect.width - this.tip.offsetWidth - 6);
    const top = event.clientY - rect.top + 18;
    this.tip.style.left = `${left}px`;
    this.tip.style.top = `${top + this.tip.offsetHeight > rect.height ? top - 56 : top}px`;
  }

  private leave(): void {
    this.tip.hidden = true;
    if (this.store.state.hover !== null) this.store.set({ hover: null }, "path");
  }
}
