// Which places have names over the path, and where these stand.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Plan } from "../src/plan/plan.ts";
import { LINE_PX, Labels } from "../src/views/labels.ts";
import { placesOf } from "../src/views/path_overlay.ts";
import { PathScene } from "../src/views/path_scene.ts";
import { planOf } from "./helper.ts";

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

// The zeros of a program that starts at X0 Y0 Z0, as named and as marked.
function zerosOf(used: readonly string[]): { names: [string, readonly number[]][]; marks: number[][] } {
  const plan: Plan = planOf([{ ticks: 5, line: 1, kind: 2 }], null, {}, { fit: { axes: {}, work_offsets: used.map((name) => ({ name, axes: {} })) } });
  const work_offsets = ["G54", "G55", "G56", "G57"].map((name, k) => ({ name, origin_mm: [[9, 9, 9], [0, 0, 0], [40, 20, -5], [0, 0, 0]][k], rotation_deg: 0 }));
  Object.assign(plan.header.machine, { work_offsets });
  const scene = new PathScene();
  scene.furnish(plan, { rgb: [1, 1, 1], dark: false, accent: "#000000", faint: "#000000", text: "" });
  const marks: number[][] = [];
  scene.scene.traverse((object) => object.type === "AxesHelper" && marks.push(object.position.toArray()));
  return { names: placesOf(plan, plan.path!).map(({ text, at }) => [text, at]), marks };
}

test("the work offsets that the program uses are marked, each with its name", () => {
  const two = zerosOf(["G55", "G56"]);
  assert.deepEqual(two.names, [["start, G55", [0, 0, 0]], ["G56", [40, 20, -5]]]);
  assert.deepEqual(two.marks, [[0, 0, 0], [40, 20, -5]]);
  assert.deepEqual(zerosOf(["G55", "G57"]).names, [["start, G55, G57", [0, 0, 0]]]);
});

test("where no work offset is known to be used G54 is marked", () => {
  const none = zerosOf([]);
  assert.deepEqual(none.names, [["start", [0, 0, 0]], ["G54", [9, 9, 9]]]);
  assert.deepEqual(none.marks, [[9, 9, 9]]);
});
