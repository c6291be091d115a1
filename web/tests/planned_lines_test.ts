// Which line of the text that was planned is which, while it goes on being written.
import assert from "node:assert/strict";
import { test } from "node:test";
import { EditorState, type ChangeSpec } from "@codemirror/state";
import { plannedLines, setPlan, type PlannedLines } from "../src/views/planned_lines.ts";
import { planOf } from "./helper.ts";

const TEXT = "one\ntwo\nthree\nfour";
const at = (line: string): number => TEXT.indexOf(line);

function afterwards(...changes: ChangeSpec[]): PlannedLines | null {
  let state = EditorState.create({ doc: TEXT, extensions: plannedLines });
  state = state.update({ effects: setPlan.of(planOf([], TEXT)) }).state;
  for (const change of changes) state = state.update({ changes: change }).state;
  return state.field(plannedLines);
}

const planned = (lines: PlannedLines | null, count: number): number[] => Array.from({ length: count }, (_, i) => lines!.plannedOf(i + 1));
const now = (lines: PlannedLines | null): number[] => [1, 2, 3, 4].map((line) => lines!.nowOf(line));

test("without a change each line is itself", () => {
  assert.deepEqual(planned(afterwards(), 4), [1, 2, 3, 4]);
  assert.deepEqual(now(afterwards()), [1, 2, 3, 4]);
});

test("a line that is written on stays the same", () => {
  for (const place of [at("two"), at("two") + 1, at("two") + 3]) assert.deepEqual(planned(afterwards({ from: place, insert: "(x)" }), 4), [1, 2, 3, 4]);
  assert.deepEqual(planned(afterwards({ from: at("two"), to: at("two") + 3, insert: "2" }), 4), [1, 2, 3, 4]);
});

test("a new line is none that was planned, and those after it move", () => {
  for (const change of [{ from: at("two"), insert: "new\n" }, { from: at("two") - 1, insert: "\nnew" }]) {
    assert.deepEqual(planned(afterwards(change), 5), [1, 0, 2, 3, 4]);
    assert.deepEqual(now(afterwards(change)), [1, 3, 4, 5]);
  }
});

test("a line that is deleted is gone, and those after it move", () => {
  const deleted = afterwards({ from: at("two"), to: at("three") });
  assert.deepEqual(planned(deleted, 3), [1, 3, 4]);
  assert.deepEqual(now(deleted), [1, 0, 2, 3]);
});

test("several changes add up", () => {
  const lines = afterwards({ from: 0, insert: "new\n" }, { from: 4 + at("three"), to: 4 + at("four") }, { from: 0, to: 4 });
  assert.deepEqual(planned(lines, 3), [1, 2, 4]);
});

test("of another text in its place nothing is planned", () => {
  assert.equal(afterwards({ from: 0, to: TEXT.length, insert: TEXT }), null);
});
