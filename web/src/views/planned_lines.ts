// Lines of the text that was planned in the text as it is now: it goes on being written beside its plan.
import { ChangeSet, StateEffect, StateField, Text, type ChangeDesc, type Transaction } from "@codemirror/state";
import { withLineFeeds, type Plan } from "../plan/plan.ts";

// The editor would split it by a pattern, which takes twice as long for a million lines.
export const linesOf = (text: string): Text => Text.of(withLineFeeds(text).split("\n"));

const PIECE = 1 << 20; // characters of a step

// The same of a text whose lines end with LF, in steps.
export function* linesInSteps(text: string): Generator<void, Text> {
  let lines = Text.empty;
  for (let begin = 0; begin < text.length; ) {
    const end = text.indexOf("\n", begin + PIECE) + 1 || text.length;
    lines = lines.append(linesOf(text.slice(begin, end)));
    begin = end;
    yield;
  }
  return lines;
}

export const setPlan = StateEffect.define<Plan>(); // of the text as it is now

export class PlannedLines {
  readonly planned: Text;
  private readonly now: Text;
  private readonly since: ChangeDesc; // what was written since it was planned
  private readonly back: ChangeDesc;

  constructor(planned: Text, now = planned, since: ChangeDesc = ChangeSet.empty(planned.length).desc) {
    this.planned = planned;
    this.now = now;
    this.since = since;
    this.back = since.invertedDesc;
  }

  with({ newDoc, changes }: Transaction): PlannedLines {
    return changes.empty ? this : new PlannedLines(this.planned, newDoc, this.since.composeDesc(changes.desc));
  }

  // Where a line that was planned is now; 0: it is gone.
  nowOf(line: number): number {
    const now = this.moved(line, this.planned, this.since, this.now);
    return now > 0 && this.moved(now, this.now, this.back, this.planned) === line ? now : 0;
  }

  // What a line was when it was planned; 0: it is new.
  plannedOf(line: number): number {
    const planned = this.moved(line, this.now, this.back, this.planned);
    return planned > 0 && this.moved(planned, this.planned, this.since, this.now) === line ? planned : 0;
  }

  private moved(line: number, from: Text, way: ChangeDesc, to: Text): number {
    if (line < 1 || line > from.lines) return 0;
    return way.empty ? line : to.lineAt(way.mapPos(from.line(line).from, 1)).number;
  }
}

// Nothing is left of the text before, as where another file is opened.
export function isReplaced({ docChanged, changes }: Transaction): boolean {
  let isLeft = false;
  changes.iterGaps(() => (isLeft = true));
  return docChanged && !isLeft;
}

// null: nothing of this text is planned.
export const plannedLines = StateField.define<PlannedLines | null>({
  create: () => null,
  update(lines, transaction) {
    if (transaction.effects.some((effect) => effect.is(setPlan))) return new PlannedLines(transaction.newDoc);
    return isReplaced(transaction) ? null : (lines?.with(transaction) ?? null);
  },
});
