// Where the path stands in its view.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as THREE from "three";
import { PathCamera, placeFor, type Box } from "../src/views/path_camera.ts";
import type { Triple } from "../src/views/stretches.ts";

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

// As large as the view, without a browser.
function elementOf(): HTMLElement {
  const rest = { style: {}, clientWidth: view.width, clientHeight: view.height, getRootNode: () => new EventTarget(), ownerDocument: new EventTarget() };
  return Object.assign(new EventTarget(), rest) as unknown as HTMLElement;
}

// told: what it says of its view each time that somebody has settled on one.
function cameraOver(box: Box, told: string[] = [], element = elementOf()): PathCamera {
  const camera: PathCamera = new PathCamera(element, () => undefined, () => told.push(camera.text));
  camera.setScene(box, []);
  camera.resize(view.width, view.height);
  return camera;
}

// Where a point is seen: from -1 to 1 in width, height and depth.
function seenAt(camera: PathCamera, point: Triple): number[] {
  camera.prepare();
  return new THREE.Vector3(...point).applyMatrix4(camera.projection).toArray();
}

const part: Box = { min: [0, 0, -5], max: [80, 60, 0] };
const large: Box = { min: [-2000, -2000, -5], max: [2000, 2000, 0] };

test("a view that comes back shows the same place of a scene that is another size", () => {
  for (const [before, after] of [[large, part], [part, large]] as const) {
    const old = cameraOver(before);
    old.restore("");
    old.look("front");
    const camera = cameraOver(after);
    camera.restore(old.text);
    const point: Triple = [40, 30, -2];
    const [was, is] = [seenAt(old, point), seenAt(camera, point)];
    assert.ok(Math.abs(is[0]! - was[0]!) < 1e-3 && Math.abs(is[1]! - was[1]!) < 1e-3, `${is} as ${was}`);
    assert.ok(Math.abs(is[2]!) < 1, `${is[2]} is in front of the eye and not too far`);
  }
});

test("a view that a button or a key asks for is told, and comes back as it was", () => {
  for (const side of ["top", "front", "right"] as const) {
    const told: string[] = [];
    const camera = cameraOver(part, told);
    camera.restore("");
    assert.deepEqual(told, [], "nobody has asked");
    camera.look(side);
    assert.deepEqual(told, [camera.text]);
    assert.notEqual(camera.text, "", side);
    const again = cameraOver(part);
    again.restore(camera.text);
    for (const point of [part.min, part.max]) {
      const [was, is] = [seenAt(camera, point), seenAt(again, point)];
      assert.ok(is.every((one, i) => Math.abs(one - was[i]!) < 1e-3), `${side}: ${is} as ${was}`);
    }
  }
});

test("a view that is fitted from where it is by itself needs no words", () => {
  const flat: Box = { min: [0, 0, 0], max: [80, 60, 0] };
  for (const [box, usual, other] of [[part, "iso", "top"], [flat, "top", "iso"]] as const) {
    const told: string[] = [];
    const camera = cameraOver(box, told);
    camera.restore("");
    camera.look(other);
    camera.look(usual);
    camera.fit();
    camera.look(other);
    camera.fit();
    assert.deepEqual(told.map((text) => text === ""), [false, true, true, false, false], usual);
  }
});

test("a view of no size is fitted once it has one, from the side that was asked for", () => {
  const hidden = Object.assign(elementOf(), { clientWidth: 0 });
  const camera = cameraOver(part, [], hidden);
  camera.restore("");
  Object.assign(hidden, { clientWidth: view.width });
  camera.resize(view.width, view.height);
  const usual = cameraOver(part);
  usual.restore("");
  assert.deepEqual(seenAt(camera, part.max), seenAt(usual, part.max));
  assert.equal(camera.text, "");
});

test("a view that was moved and is fitted again needs no words, one that was turned does", () => {
  const told: string[] = [];
  const element = elementOf();
  const camera = cameraOver(part, told, element);
  camera.restore("");
  const press = (key: string, shiftKey: boolean): void => void element.dispatchEvent(Object.assign(new Event("keydown"), { key, shiftKey }));
  press("ArrowLeft", true);
  camera.fit();
  press("ArrowLeft", false);
  camera.fit();
  assert.deepEqual(told.map((text) => text === ""), [false, true, false, false]);
});

test("an address that says no view is as one that says nothing", () => {
  const usual = cameraOver(part);
  usual.restore("");
  for (const text of [",,,,,,", "1,1,1,0,0,0,-5", "1,1,1,0,0,0,0", "1,1,1,0,0,0,1e999", "1,2,3,1,2,3,5", "1,1,1,0,0,0", "1,1,1,0,0,0,", "1e300,1,1,0,0,0,5", "-,1,1,0,0,0,5"]) {
    const camera = cameraOver(part);
    camera.restore(text);
    assert.equal(camera.text, "", text);
    assert.deepEqual(seenAt(camera, part.max), seenAt(usual, part.max), text);
  }
});

test("a view that is looked at closely comes back to a tenth of a pixel", () => {
  const [camera, again] = [cameraOver(large), cameraOver(large)];
  camera.restore("1234.56789,-1000,800,1234.56789,987.654321,-2,54321.9876");
  again.restore(camera.text);
  const point: Triple = [1234.57, 987.654, -2];
  const [was, is] = [seenAt(camera, point), seenAt(again, point)];
  const pixels = Math.hypot((is[0]! - was[0]!) * view.width, (is[1]! - was[1]!) * view.height) / 2;
  assert.ok(pixels < 0.1, `${pixels} pixels off`);
});
