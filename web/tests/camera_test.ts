// Where the path stands in its view.
import assert from "node:assert/strict";
import { test } from "node:test";
import { placeFor } from "../src/views/path_camera.ts";

const view = { width: 800, height: 300 };
const legend = { width: 200, height: 100 };
const box = (width: number, height: number): [number, number][] => [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].map((y): [number, number] => [width * x, height * y]));

test("what would lie under the legend stands beside it", () => {
  const place = placeFor(box(150, 60), view, legend);
  assert.ok(Math.abs(place.zoom - (0.86 * 600) / 150) < 1e-9);
  assert.deepEqual([place.right, place.up], [-100, 0]);
});

test("what is long stands above the legend", () => {
  const place = placeFor(box(100, 16), view, legend);
  assert.ok(Math.abs(place.zoom - (0.86 * 800) / 100) < 1e-9);
  assert.deepEqual([place.right, place.up], [0, 50]);
});

test("a legend that leaves no room takes none", () => {
  const place = placeFor(box(80, 30), view, { width: 500, height: 250 });
  assert.deepEqual(place, { zoom: 0.86 * 10, right: 0, up: 0 });
  assert.deepEqual(placeFor(box(80, 30), view, { width: 0, height: 0 }), place);
});

test("what does not lead into its corner stands in the middle", () => {
  const zoom = 0.86 * 10;
  assert.deepEqual(placeFor(box(30, 30), view, legend), { zoom, right: 0, up: 0 });
  const diamond: [number, number][] = [[-40, 0], [0, 15], [40, 0], [0, -15]]; // as a flat part is seen from a corner
  assert.deepEqual(placeFor(diamond, view, { width: 120, height: 60 }), { zoom, right: 0, up: 0 });
});
