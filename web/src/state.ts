// What the views share: the plan that is shown, the present instant, how things are shown. The URL's fragment keeps it.
import { USUAL_UNITS, type Units } from "./units.ts";

export const COLOURS = ["feed", "limit", "acceleration", "jerk", "deviation", "tool", "following"] as const;
export type ColourBy = (typeof COLOURS)[number];
// How much faster than the machine it plays.
export const SPEEDS = [0.01, 0.1, 0.25, 1, 4, 20, 100] as const;
export type Theme = "auto" | "light" | "dark";
// Who has moved the instant: the others follow.
export type Origin = "path" | "time" | "program" | "play" | "answer" | "page";

export interface State {
  plan: number;
  tick: number; // the present instant
  hover: number | null; // an instant that is looked at in passing
  colourBy: ColourBy;
  shown: readonly number[] | null; // of a legend of parts: those that are not dimmed; null: all
  track: string; // whose v, a and j stand over time
  span: readonly [number, number] | null; // the ticks that the charts show; null: all
  tab: string; // what stands beside the path
  units: Units;
  theme: Theme;
  camera: string; // what the view from the path's side needs to come back
  playing: boolean;
  speed: number;
}

export type Change = Partial<State>;
type Listener = (state: Readonly<State>, change: Change, origin: Origin) => void;

export class Store {
  readonly state: State;
  private readonly listeners: Listener[] = [];

  constructor(state: State) {
    this.state = state;
  }

  listen(listener: Listener): void {
    this.listeners.push(listener);
  }

  set(change: Change, origin: Origin): void {
    Object.assign(this.state, change);
    for (const listener of this.listeners) listener(this.state, change, origin);
  }

  // Another of the plans that stand side by side, from its begin.
  showPlan(plan: number, origin: Origin): void {
    this.set({ plan, tick: 0, hover: null, shown: null, span: null, camera: "", playing: false }, origin);
  }

  // Plans in place of those that are shown: of the same program, as of one that is typed, the eye, the instant and what the charts
  // show stay.
  replacePlans(isSameProgram: boolean, origin: Origin): void {
    if (isSameProgram) this.set({ plan: 0, hover: null, playing: false }, origin);
    else this.showPlan(0, origin);
  }

  // The instant that is shown.
  get instant(): number {
    return this.state.hover ?? this.state.tick;
  }
}

export function initialState(): State {
  return {
    plan: 0,
    tick: 0,
    hover: null,
    colourBy: "feed",
    shown: null,
    track: "path",
    span: null,
    tab: "program",
    units: USUAL_UNITS,
    theme: "auto",
    camera: "",
    playing: false,
    speed: 1,
  };
}

// usual: the units of the program that is shown first.
export function toFragment(state: Readonly<State>, usual: Units = USUAL_UNITS): string {
  const words = new URLSearchParams();
  if (state.plan > 0) words.set("plan", String(state.plan + 1));
  if (state.tick > 0) words.set("tick", String(Math.round(state.tick)));
  if (state.colourBy !== "feed") words.set("colour", state.colourBy);
  if (state.shown) words.set("shown", state.shown.join(","));
  if (state.track !== "path") words.set("track", state.track);
  if (state.span) words.set("span", state.span.map((tick) => String(Number(tick.toFixed(3)))).join(","));
  if (state.tab !== "program") words.set("tab", state.tab);
  if (state.units.length !== usual.length) words.set("length", state.units.length);
  if (state.units.time !== usual.time) words.set("per", state.units.time);
  if (state.theme !== "auto") words.set("theme", state.theme);
  if (state.speed !== 1) words.set("speed", String(state.speed));
  if (state.camera !== "") words.set("view", state.camera);
  return words.toString();
}

// What the fragment says; what it says wrongly is left out.
export function fromFragment(fragment: string, usual: Units = USUAL_UNITS): Change {
  const words = new URLSearchParams(fragment.replace(/^#/, ""));
  const change: Change = {};
  const whole = (name: string): number | null => {
    const text = words.get(name);
    return text !== null && /^\d{1,12}$/.test(text) ? Number(text) : null;
  };
  const plan = whole("plan");
  if (plan !== null && plan > 0) change.plan = plan - 1;
  const tick = whole("tick");
  if (tick !== null) change.tick = tick;
  const colour = COLOURS.find((name) => name === words.get("colour"));
  if (colour) change.colourBy = colour;
  const shown = words.get("shown");
  if (shown !== null && /^\d{1,9}(,\d{1,9}){0,999}$/.test(shown)) change.shown = shown.split(",").map(Number);
  const track = words.get("track");
  if (track !== null && /^[a-z]+$/.test(track)) change.track = track;
  const span = /^(\d{1,12}(?:\.\d+)?),(\d{1,12}(?:\.\d+)?)$/.exec(words.get("span") ?? "");
  if (span && Number(span[1]) < Number(span[2])) change.span = [Number(span[1]), Number(span[2])];
  const tab = words.get("tab");
  if (tab !== null && /^[a-z]+$/.test(tab)) change.tab = tab;
  const length = (["mm", "inch"] as const).find((name) => name === words.get("length"));
  const time = (["s", "min"] as const).find((name) => name === words.get("per"));
  change.units = { length: length ?? usual.length, time: time ?? usual.time };
  const theme = words.get("theme");
  if (theme === "light" || theme === "dark") change.theme = theme;
  const speed = SPEEDS.find((one) => String(one) === words.get("speed"));
  if (speed !== undefined) change.speed = speed;
  const view = words.get("view");
  if (view !== null && /^[-\d.,e]+$/.test(view)) change.camera = view;
  return change;
}
