// Two runs side by side: where one takes longer than the other, by line and by limit.
import type { Account } from "./account.ts";
import type { Plan } from "./plan.ts";

// Lines of both programs that stand for each other, from the first to the last; last < first: none.
export interface LinePair {
  readonly base: number;
  readonly baseLast: number;
  readonly other: number;
  readonly otherLast: number;
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
  readonly text: string; // of the first line, as the other program has it; empty: it is not in the page
}
export interface LimitRow extends Row {
  readonly key: string;
}

// Those first that differ most.
export function largestFirst<T extends Row>(rows: readonly T[]): T[] {
  return [...rows].sort((a, b) => Math.abs(b.other_s - b.base_s) - Math.abs(a.other_s - a.base_s));
}

// What a line says: without comments, blanks and N, in capitals. A slash before N stays.
const meaning = (line: string): string => line.replace(/\([^)]*\)?|;[^]*|[ \t-\r]+/g, "").toUpperCase().replace(/^(\/\d*)?N\d+/, "$1");

// As kerf numbers them: after the end of the last line none begins.
const linesOf = (text: string): string[] => text.replace(/\n$/, "").split("\n");

const DEEPEST = 64; // gaps within gaps: bounds what a text can cost

interface Gap {
  depth: number;
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

const onePair = (base: number, other: number): LinePair => ({ base, baseLast: base, other, otherLast: other });

// What lies between lines that are found in both: one by one where both have as many, else all of it together.
function addBetween({ a, aEnd, b, bEnd }: Gap, pairs: LinePair[]): void {
  if (aEnd - a !== bEnd - b) pairs.push({ base: a + 1, baseLast: aEnd, other: b + 1, otherLast: bEnd });
  else while (a < aEnd) pairs.push(onePair(++a, ++b));
}

// All lines of both texts, in their order, each in one pair: the pairs of `kerf compare` (compare/line_match.cpp).
export function pairLines(base: string, other: string): LinePair[] {
  const [a, b] = [base, other].map((text) => linesOf(text).map(meaning)) as [string[], string[]];
  const pairs: LinePair[] = [];
  const gaps: Gap[] = [{ depth: 0, a: 0, aEnd: a.length, b: 0, bEnd: b.length }]; // the next one last
  for (let gap = gaps.pop(); gap; gap = gaps.pop()) {
    while (gap.a < gap.aEnd && gap.b < gap.bEnd && a[gap.a] === b[gap.b]) pairs.push(onePair(++gap.a, ++gap.b));
    const ends = { a: gap.aEnd, b: gap.bEnd };
    while (gap.aEnd > gap.a && gap.bEnd > gap.b && a[gap.aEnd - 1] === b[gap.bEnd - 1]) (--gap.aEnd, --gap.bEnd);
    const depth = gap.depth + 1;
    if (gap.aEnd < ends.a) gaps.push({ depth, a: gap.aEnd, aEnd: ends.a, b: gap.bEnd, bEnd: ends.b });
    const anchors = gap.depth < DEEPEST ? anchorsOf(a, b, gap) : [];
    if (anchors.length === 0) {
      addBetween(gap, pairs);
      continue;
    }
    for (let i = anchors.length - 1; i >= 0; --i) {
      const [next, last] = [anchors[i + 1] ?? [gap.aEnd, gap.bEnd], anchors[i]!];
      gaps.push({ depth, a: last[0], aEnd: next[0], b: last[1], bEnd: next[1] });
    }
    gaps.push({ depth, a: gap.a, aEnd: anchors[0]![0], b: gap.b, bEnd: anchors[0]![1] });
  }
  return pairs;
}

function secondsOf({ plan, account }: Ran, first: number, last: number): number {
  let ticks = 0;
  for (let line = first; line <= last; ++line) ticks += account.lines.get(line) ?? 0;
  return ticks * plan.period_s;
}

// The lines that take time in either, in their order. Without the texts lines of one number are one.
export function lineRows(base: Ran, other: Ran): LineRow[] {
  const texts = [base, other].map(({ plan }) => plan.source);
  const isSame = texts[0] === null || texts[1] === null || texts[0] === texts[1];
  const numbers = new Set<number>();
  for (const { account } of [base, other]) account.lines.forEach((_ticks, line) => numbers.add(line));
  const pairs = isSame ? [...numbers].sort((x, y) => x - y).map((line) => onePair(line, line)) : pairLines(texts[0]!, texts[1]!);
  const lines = texts.map((text) => text?.split("\n") ?? []);
  const textOf = (k: 0 | 1, first: number, last: number): string | undefined => (first <= last ? lines[k]![first - 1] : undefined);
  return pairs
    .map((pair) => ({
      ...pair,
      text: (textOf(1, pair.other, pair.otherLast) ?? textOf(0, pair.base, pair.baseLast) ?? "").trim(),
      base_s: secondsOf(base, pair.base, pair.baseLast),
      other_s: secondsOf(other, pair.other, pair.otherLast),
    }))
    .filter((row) => row.base_s > 0 || row.other_s > 0);
}

export function limitRows(base: Plan, other: Plan): LimitRow[] {
  const seconds = (plan: Plan, key: string): number => plan.header.report.speed_limits?.[key]?.time_s ?? 0;
  const keys = new Set([base, other].flatMap((plan) => Object.keys(plan.header.report.speed_limits ?? {})));
  return largestFirst([...keys].map((key) => ({ key, base_s: seconds(base, key), other_s: seconds(other, key) })));
}
