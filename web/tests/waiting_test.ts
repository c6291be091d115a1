// What is said of a program's time while it is planned.
import assert from "node:assert/strict";
import { test } from "node:test";
import { waitingTexts } from "../src/views/waiting.ts";

const progress = { ticks: 61_000, path_mm: 7, left_s: 3.6, line: 12, lines: new Map([[12, 61_000]]) };

test("an estimate is called one, and has no digits that it does not have", () => {
  assert.deepEqual(waitingTexts(progress, 0.001), ["about 1:05", "an estimate; planned so far: 1:01, up to line 12"]);
  assert.deepEqual(waitingTexts({ ...progress, ticks: 2000, left_s: 40 }, 0.001), ["about 42 s", "an estimate; planned so far: 2 s, up to line 12"]);
  assert.deepEqual(waitingTexts({ ...progress, left_s: 7200 }, 0.001)[0], "about 2:01:01");
});

test("no line is named before one has ticks", () => {
  assert.deepEqual(waitingTexts({ ...progress, line: 0 }, 0.001), ["about 1:05", "an estimate; planned so far: 1:01"]);
});

test("no time is said where nothing is known of it", () => {
  assert.deepEqual(waitingTexts("none", 0.001), ["not planned", ""]);
  assert.deepEqual(waitingTexts(null, 0.001), ["planning\u2026", ""]);
  assert.deepEqual(waitingTexts({ ...progress, ticks: 0 }, 0.001), ["planning\u2026", ""]);
  assert.deepEqual(waitingTexts({ ...progress, left_s: null }, 0.001), ["planning\u2026", "planned so far: 1:01, up to line 12"]);
});
