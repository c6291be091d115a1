// From where the path is seen: orbit, pan, zoom, and the views of the buttons.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Triple } from "./stretches.ts";

export const SIDES = ["top", "front", "right", "iso"] as const;
export type Side = (typeof SIDES)[number];
const DIRECTIONS: Record<Side, Triple> = { top: [0, 0, 1], front: [0, -1, 0], right: [1, 0, 0], iso: [-1, -1.4, 1.1] };

const SAME_DIRECTION = 1e-7; // even from above, whose direction leans by 1e-4, a turn of a pixel is more

// To the eye, of length 1.
function directionOf(side: Side): THREE.Vector3 {
  const direction = new THREE.Vector3(...DIRECTIONS[side]).normalize();
  if (side === "top") direction.y -= 1e-4; // y stays upwards
  return direction.normalize();
}

const WAYS: Readonly<Record<string, readonly [right: number, down: number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const TEXT_DIGITS = 9; // of a metre a hundredth of a micrometre: a pixel of the closest view
const LEAST_SHARE = 0.75;
const MOST_ZOOM = 1e5;
const KEY_ANGLE_RAD = Math.PI / 36;
const KEY_PIXELS = 40;
const KEY_ZOOM = 1.25;

export interface Box {
  readonly min: Triple;
  readonly max: Triple;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

type Point = readonly [right: number, up: number];

// Whether one of the lines between the points comes into the lower right corner of a view about their middle.
function leadsInto(corner: Size, view: Size, points: readonly Point[]): boolean {
  const STEPS = 16;
  const isIn = (right: number, up: number): boolean => right > view.width / 2 - corner.width && up < corner.height - view.height / 2;
  return points.some((a, i) =>
    points.slice(i).some((b) => {
      for (let step = 0; step <= STEPS; ++step) {
        const share = step / STEPS;
        if (isIn(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]))) return true;
      }
      return false;
    }),
  );
}

// Where the corners of something, about its middle, fit into a view whose lower right corner is covered: in pixels from the
// view's middle, and how large. In all of the view where they keep off that corner or would be much smaller beside it; else
// beside or above what covers it.
export function placeFor(points: readonly Point[], view: Size, covered: Size): { zoom: number; right: number; up: number } {
  const size = { width: 2 * Math.max(...points.map(([right]) => Math.abs(right))), height: 2 * Math.max(...points.map(([, up]) => Math.abs(up))) };
  const fits = (width: number, height: number): number => Math.min(0.86 * Math.min(width / Math.max(size.width, 1e-3), height / Math.max(size.height, 1e-3)), MOST_ZOOM);
  const whole = { zoom: fits(view.width, view.height), right: 0, up: 0 };
  if (!leadsInto(covered, view, points.map(([right, up]) => [whole.zoom * right, whole.zoom * up]))) return whole;
  const beside = { zoom: fits(view.width - covered.width, view.height), right: -covered.width / 2, up: 0 };
  const above = { zoom: fits(view.width, view.height - covered.height), right: 0, up: covered.height / 2 };
  const free = beside.zoom > above.zoom ? beside : above;
  return free.zoom > LEAST_SHARE * whole.zoom ? free : whole;
}

// The numbers of a view as text(): null where they are none.
function viewOf(text: string): { target: THREE.Vector3; direction: THREE.Vector3; zoom: number } | null {
  const words = text.split(",");
  const [px, py, pz, tx, ty, tz, zoom] = words.map(Number);
  if (words.length !== 7 || words.includes("") || !(zoom! > 0 && zoom! < Infinity)) return null;
  const target = new THREE.Vector3(tx, ty, tz);
  const direction = new THREE.Vector3(px, py, pz).sub(target);
  const away = direction.length(); // not finite where one of them is not
  return away > 0 && away < Infinity ? { target, direction: direction.divideScalar(away), zoom: zoom! } : null;
}

export class PathCamera {
  private covered: Size = { width: 0, height: 0 }; // of the lower right corner
  readonly camera = new THREE.OrthographicCamera();
  private readonly controls: OrbitControls;
  private box: Box = { min: [0, 0, 0], max: [0, 0, 0] }; // of what is to be seen
  private reach = 4; // farther than anything that is drawn
  private isFitted = false; // and no hand has moved it
  private isHeld = false; // by a hand that moves it now
  private isToFit = false; // once the view has a size
  private readonly element: HTMLElement;
  private readonly settled: () => void;

  // changed: the view is another one. settled: and the hand has let go.
  constructor(element: HTMLElement, changed: () => void, settled: () => void) {
    this.element = element;
    this.settled = settled;
    element.addEventListener("keydown", (event) => this.key(event));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => {
      this.isHeld = true;
      this.isFitted = false;
    });
    this.controls.addEventListener("end", () => {
      this.isHeld = false;
      settled();
    });
  }

  // all: whatever is drawn beside it.
  setScene(box: Box, all: readonly number[]): void {
    this.box = box;
    this.reach = 4 * Math.max(1, ...[...box.min, ...box.max, ...all].map(Math.abs));
  }

  resize(width: number, height: number): void {
    Object.assign(this.camera, { left: -width / 2, right: width / 2, top: height / 2, bottom: -height / 2 });
    this.camera.updateProjectionMatrix();
    if (this.isToFit) this.fitBox();
  }

  // Before a frame is drawn.
  prepare(): void {
    this.camera.near = -4 * this.reach;
    this.camera.far = 8 * this.reach;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  get projection(): THREE.Matrix4 {
    return new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
  }

  look(side: Side): void {
    this.turnTo(side);
    this.settled();
  }

  // As near as all of the box is seen.
  fit(): void {
    this.fitBox();
    this.settled();
  }

  // What covers the corner is another one: a view that nobody has moved makes room for the first.
  cover(size: Size): void {
    const isFirst = this.covered.width === 0;
    this.covered = size;
    if (isFirst && this.isFitted) this.fitBox();
  }

  private turnTo(side: Side): void {
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.controls.target).addScaledVector(directionOf(side), this.reach);
    this.fitBox();
  }

  private fitBox(): void {
    const { min, max } = this.box;
    const middle = new THREE.Vector3(...min).add(new THREE.Vector3(...max)).multiplyScalar(0.5);
    const offset = this.camera.position.clone().sub(this.controls.target).setLength(this.reach);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(offset);
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    const corners = Array.from({ length: 8 }, (_, corner): Point => {
      const point = new THREE.Vector3(corner & 1 ? max[0] : min[0], corner & 2 ? max[1] : min[1], corner & 4 ? max[2] : min[2]);
      point.applyMatrix4(this.camera.matrixWorldInverse);
      return [point.x, point.y];
    });
    const { clientWidth: width, clientHeight: height } = this.element;
    this.isFitted = true;
    this.isToFit = width === 0 || height === 0;
    if (this.isToFit) return;
    const { zoom, right, up } = placeFor(corners, { width, height }, this.covered);
    this.camera.zoom = zoom;
    const shift = new THREE.Vector3(-right, -up, 0).divideScalar(this.camera.zoom).applyQuaternion(this.camera.quaternion);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.update();
  }

  // From the fragment; a fitted view from above, of what is flat, or from a corner where it says nothing that is one. A view
  // that is being turned stays in the hand.
  restore(text: string): void {
    if (this.isHeld) return;
    const found = viewOf(text);
    if (!found) {
      this.turnTo(this.usualSide);
      return;
    }
    this.isFitted = this.isToFit = false;
    this.controls.target.copy(found.target);
    // As far as this scene asks for: the view may be of another one.
    this.camera.position.copy(found.target).addScaledVector(found.direction, this.reach);
    this.camera.zoom = found.zoom;
    this.update();
  }

  private get usualSide(): Side {
    const { min, max } = this.box;
    const flat = max[2] - min[2] <= 0.002 * Math.max(max[0] - min[0], max[1] - min[1]);
    return flat ? "top" : "iso";
  }

  // What restore() needs: nothing where it is the view that nobody has moved.
  get text(): string {
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    if (this.isFitted && direction.distanceTo(directionOf(this.usualSide)) < SAME_DIRECTION) return "";
    const numbers = [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom];
    return numbers.map((number) => String(Number(number.toPrecision(TEXT_DIGITS)))).join(",");
  }

  // As the mouse does: an arrow turns what is seen its way, with Shift it moves it.
  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { controls } = this;
    const way = WAYS[event.key];
    if (way && event.shiftKey) {
      controls.pan(KEY_PIXELS * way[0], KEY_PIXELS * way[1]);
    } else if (way) {
      controls.rotateLeft(KEY_ANGLE_RAD * way[0]);
      controls.rotateUp(KEY_ANGLE_RAD * way[1]);
    } else if (event.key === "+" || event.key === "-") {
      controls.dollyIn(event.key === "+" ? 1 / KEY_ZOOM : KEY_ZOOM);
    } else {
      return;
    }
    this.isFitted = false;
    event.preventDefault();
    this.settled();
  }

  private update(): void {
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.controls.dispatchEvent({ type: "change" });
  }
}
