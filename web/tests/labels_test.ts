// Where names of places stand over the path.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINE_PX, Labels } from "../src/views/labels.ts";

test("a name that would lie over another one stands above it", () => {
  const labels = new Labels();
  assert.equal(labels.freeY({ left: 100, width: 80, y: 50 }), 50);
  assert.equal(labels.freeY({ left: 170, width: 80, y: 56 }), 50 - LINE_PX);
  assert.equal(labels.freeY({ left: 120, width: 80, y: 48 }), 50 - 2 * LINE_PX, "above both");
});

test("names beside each other stay where they are", () => {
  const labels = new Labels();
  assert.equal(labels.freeY({ left: 100, width: 80, y: 50 }), 50);
  assert.equal(labels.freeY({ left: 180, width: 80, y: 50 }), 50);
  assert.equal(labels.freeY({ left: 100, width: 80, y: 50 + LINE_PX }), 50 + LINE_PX);
});

test("a name keeps off what covers the lower right corner", () => {
  const labels = new Labels({ left: 200, top: 100 });
  assert.equal(labels.freeY({ left: 100, width: 80, y: 150 }), 150, "beside it");
  assert.equal(labels.freeY({ left: 150, width: 80, y: 60 }), 60, "above it");
  assert.equal(labels.freeY({ left: 150, width: 80, y: 150 }), 100 - LINE_PX / 2);
  assert.equal(labels.freeY({ left: 190, width: 80, y: 180 }), 100 - 1.5 * LINE_PX, "above the other");
});
