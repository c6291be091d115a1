// Two runs side by side: where one takes longer than the other, by line and by limit.
import type { Account } from "./account.ts";
import type { Plan } from "./plan.ts";

// One line of both programs; 0: the other program has none like it.
export interface LinePair {
  readonly base: number;
  readonly other: number;
}

export interface Ran {
  readonly plan: Plan;
  readonly account: Account;
}

export interface Row {
  readonly base_s: number;
  readonly other_s: number;
}
export interface LineRow extends LinePair, Row {
  readonly text: string; // as the other program has it; empty: it is not in the page
}
export interface LimitRow extends Row {
  readonly key: string;
}

// Those first that differ most.
export function largestFirst<T extends Row>(rows: readonly T[]): T[] {
  return [...rows].sort((a, b) => Math.abs(b.other_s - b.base_s) - Math.abs(a.other_s - a.base_s));
}

// What a line says, without its number and however it is spaced.
const meaning = (line: string): string => line.replace(/^\s*\/?\s*N\d+\s*/i, "").replace(/\s+/g, "").toUpperCase();

interface Gap {
  a: number;
  aEnd: number;
  b: number;
  bEnd: number;
}

// Those lines of a gap that stand once in both, in an order that both have: patience sorting.
function anchorsOf(a: readonly string[], b: readonly string[], gap: Gap): [number, number][] {
  const places = new Map<string, { inA: number; inB: number; a: number; b: number }>();
  const of = (text: string): { inA: number; inB: number; a: number; b: number } => {
    let place = places.get(text);
    if (!place) places.set(text, (place = { inA: 0, inB: 0, a: -1, b: -1 }));
    return place;
  };
  for (let i = gap.a; i < gap.aEnd; ++i) {
    const place = of(a[i]!);
    ++place.inA;
    place.a = i;
  }
  for (let i = gap.b; i < gap.bEnd; ++i) {
    const place = of(b[i]!);
    ++place.inB;
    place.b = i;
  }
  const once = [...places.values()].filter((place) => place.inA === 1 && place.inB === 1).sort((x, y) => x.a - y.a);
  const piles: number[] = []; // the last of each rising row, by its length
  const before = new Int32Array(once.length).fill(-1);
  once.forEach((place, i) => {
    let low = 0;
    let high = piles.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (once[piles[middle]!]!.b < place.b) low = middle + 1;
      else high = middle;
    }
    if (low > 0) before[i] = piles[low - 1]!;
    piles[low] = i;
  });
  const row: [number, number][] = [];
  for (let i = piles[piles.length - 1] ?? -1; i >= 0; i = before[i]!) row.push([once[i]!.a, once[i]!.b]);
  return row.reverse();
}

// Lines of both texts, in their order. What is equal stands together; of what is not, as many lines as both have.
export function pairLines(base: string, other: string): LinePair[] {
  const [a, b] = [base, other].map((text) => text.split("\n").map(meaning)) as [string[], string[]];
  const pairs: LinePair[] = [];
  const gaps: Gap[] = [{ a: 0, aEnd: a.length, b: 0, bEnd: b.length }]; // the next one last
  for (let gap = gaps.pop(); gap; gap = gaps.pop()) {
    while (gap.a < gap.aEnd && gap.b < gap.bEnd && a[gap.a] === b[gap.b]) pairs.push({ base: ++gap.a, other: ++gap.b });
    const ends = { a: gap.aEnd, b: gap.bEnd };
    while (gap.aEnd > gap.a && gap.bEnd > gap.b && a[gap.aEnd - 1] === b[gap.bEnd - 1]) (--gap.aEnd, --gap.bEnd);
    if (gap.aEnd < ends.a) gaps.push({ a: gap.aEnd, aEnd: ends.a, b: gap.bEnd, bEnd: ends.b });
    const anchors = anchorsOf(a, b, gap);
    if (anchors.length === 0) {
      while (gap.a < gap.aEnd || gap.b < gap.bEnd) pairs.push({ base: gap.a < gap.aEnd ? ++gap.a : 0, other: gap.b < gap.bEnd ? ++gap.b : 0 });
      continue;
    }
    for (let i = anchors.length - 1; i >= 0; --i) {
      const [next, last] = [anchors[i + 1] ?? [gap.aEnd, gap.bEnd], anchors[i]!];
      gaps.push({ a: last[0], aEnd: next[0], b: last[1], bEnd: next[1] });
    }
    gaps.push({ a: gap.a, aEnd: anchors[0]![0], b: gap.b, bEnd: anchors[0]![1] });
  }
  return pairs;
}

// The lines that take time in either, in their order. Without the texts lines of one number are one.
export function lineRows(base: Ran, other: Ran): LineRow[] {
  const texts = [base, other].map(({ plan }) => plan.source);
  const isSame = texts[0] === null || texts[1] === null || texts[0] === texts[1];
  const numbers = new Set<number>();
  for (const { account } of [base, other]) account.lines.forEach((_ticks, line) => numbers.add(line));
  const pairs = isSame ? [...numbers].sort((x, y) => x - y).map((line) => ({ base: line, other: line })) : pairLines(texts[0]!, texts[1]!);
  const lines = texts.map((text) => text?.split("\n") ?? []);
  const seconds = ({ plan, account }: Ran, line: number): number => (account.lines.get(line) ?? 0) * plan.period_s;
  return pairs
    .map((pair) => ({
      ...pair,
      text: (lines[1]![pair.other - 1] ?? lines[0]![pair.base - 1] ?? "").trim(),
      base_s: seconds(base, pair.base),
      other_s: seconds(other, pair.other),
    }))
    .filter((row) => row.base_s > 0 || row.other_s > 0);
}

export function limitRows(base: Plan, other: Plan): LimitRow[] {
  const seconds = (plan: Plan, key: string): number => plan.header.report.speed_limits?.[key]?.time_s ?? 0;
  const keys = new Set([base, other].flatMap((plan) => Object.keys(plan.header.report.speed_limits ?? {})));
  return largestFirst([...keys].map((key) => ({ key, base_s: seconds(base, key), other_s: seconds(other, key) })));
}
