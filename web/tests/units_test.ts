// Numbers as they are read, and as they are typed in again.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boundText, clock } from "../src/units.ts";
import { timeText } from "../src/views/time_chart.ts";

test("a bound is rounded to the side on which it is kept", () => {
  const mm = { length: "mm", time: "s" } as const;
  const inch = { length: "inch", time: "s" } as const;
  assert.equal(boundText(466.66654, "most", mm), "466.666");
  assert.equal(boundText(466.66654, "least", mm), "466.667");
  assert.equal(boundText(-466.66654, "least", mm), "\u2212466.666");
  assert.equal(boundText(466.66654, "most", inch), "18.3726"); // 18.372698...
  assert.equal(boundText(466.66654, "least", inch), "18.3727");
  for (const bound of ["least", "most"] as const) {
    assert.equal(boundText(0.1 + 0.2, bound, mm), "0.300", "what a sum has rounded is no bound of its own");
    assert.equal(boundText(-0.0002, bound, mm), bound === "least" ? "0.000" : "\u22120.001");
  }
});

test("marks of the time axis that stand beside each other differ", () => {
  for (const at of [0.5, 61, 3700]) {
    for (const step of [0.001, 0.002, 0.02, 0.05, 0.5, 1, 10]) {
      const texts = [0, 1, 2, 3].map((i) => timeText(at + i * step, step));
      assert.equal(new Set(texts).size, texts.length, texts.join(" "));
    }
  }
  assert.equal(timeText(83.456, 0.001), "1:23.456");
  assert.equal(timeText(500, 100), "8:20");
  assert.equal(timeText(7200, 600), "2:00:00");
  assert.equal(timeText(7205.5, 0.5), "2:00:05.5");
  assert.equal(timeText(0.25, 0.05), "0.25 s");
  assert.equal(clock(123.456), "2:03.46");
});
