// What a key does in the charts: it moves the instant, or what is seen.
import type { Span } from "./columns.ts";

export interface Chart {
  readonly tick: number; // the present instant
  readonly span: Span; // what is seen
}

const STEP = 1 / 100; // of what is seen
const MOVE = 1 / 10;
const ZOOM = 1.5;

// The instant at `tick`, and what is seen moved as far as it takes to see it: then it is in the middle.
function at(tick: number, span: Span, last: number): Chart {
  const inside = Math.min(last, Math.max(0, tick));
  if (inside >= span.from && inside <= span.to) return { tick: inside, span };
  const size = span.to - span.from;
  const from = Math.min(Math.max(0, last - size), Math.max(0, inside - size / 2));
  return { tick: inside, span: { from, to: from + size } };
}

// last: the program's last tick. Null: the key does nothing here.
export function chartAfter(key: string, shift: boolean, { tick, span, last }: Chart & { readonly last: number }): Chart | null {
  const size = span.to - span.from;
  const zoomed = (factor: number): Chart => {
    const middle = Math.min(span.to, Math.max(span.from, tick));
    return { tick, span: { from: middle - (middle - span.from) * factor, to: middle + (span.to - middle) * factor } };
  };
  const step = (way: 1 | -1): Chart => {
    if (!shift) return at(Math.round(tick) + way * Math.max(1, Math.round(STEP * size)), span, last);
    const by = way * MOVE * size;
    return { tick, span: { from: span.from + by, to: span.to + by } };
  };
  switch (key) {
    case "ArrowLeft":
      return step(-1);
    case "ArrowRight":
      return step(1);
    case "ArrowUp":
    case "+":
      return zoomed(1 / ZOOM);
    case "ArrowDown":
    case "-":
      return zoomed(ZOOM);
    case "Home":
      return at(0, span, last);
    case "End":
      return at(last, span, last);
    default:
      return null;
  }
}
