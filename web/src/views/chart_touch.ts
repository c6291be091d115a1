// Two fingers on the charts: what is under each stays under it.
import type { Span } from "./columns.ts";

const NEAREST = 0.02; // of the charts' width: fingers that are nearer say nothing of a span

// Where the two fingers were put down, and are: shares of the charts' width.
export interface Fingers {
  readonly first: number;
  readonly second: number;
}

// What is seen once the fingers have moved. Null: they are too near to each other.
export function spanAfter(span: Span, before: Fingers, now: Fingers): Span | null {
  const [was, is] = [before.second - before.first, now.second - now.first];
  if (Math.abs(was) < NEAREST || Math.abs(is) < NEAREST || was * is < 0) return null;
  const size = ((span.to - span.from) * was) / is;
  const from = span.from + before.first * (span.to - span.from) - now.first * size;
  return { from, to: from + size };
}

// share: where in the charts a finger is. seen: what they show.
export function listenToFingers(area: HTMLElement, share: (event: PointerEvent) => number | null, seen: () => Span, zoomTo: (span: Span) => void): void {
  const places = new Map<number, number>(); // of the fingers on the charts
  let begin: { span: Span; fingers: Fingers } | null = null;
  const fingers = (): Fingers => {
    const [first, second] = [...places.values()];
    return { first: first!, second: second! };
  };
  const put = (event: PointerEvent): void => {
    const place = share(event);
    if (event.pointerType !== "touch" || place === null) return;
    places.set(event.pointerId, place);
    begin = places.size === 2 ? { span: seen(), fingers: fingers() } : null;
  };
  const lift = (event: PointerEvent): void => {
    if (places.delete(event.pointerId)) begin = null;
  };
  area.addEventListener("pointerdown", put);
  area.addEventListener("pointermove", (event) => {
    const place = share(event);
    if (!places.has(event.pointerId) || place === null) return;
    places.set(event.pointerId, place);
    const span = begin && spanAfter(begin.span, begin.fingers, fingers());
    if (span) zoomTo(span);
  });
  for (const end of ["pointerup", "pointercancel"] as const) area.addEventListener(end, lift);
}
