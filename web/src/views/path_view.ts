// The path in space: orbit, pan, zoom, pick.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Plan } from "../plan/plan.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import { lengthText, lengthUnit } from "../units.ts";
import type { Ground } from "./ground.ts";
import { colouringOf, type Colouring } from "./path_colours.ts";
import { drawOverlay, placesOf, type Place } from "./path_overlay.ts";
import { pointingOf, tickNear } from "./pick.ts";
import { boxOfCut, markOf, stretchesOf, type Triple } from "./stretches.ts";
import { strokes } from "./thick_lines.ts";

export const SIDES = ["top", "front", "right", "iso"] as const;
export type Side = (typeof SIDES)[number];
const DIRECTIONS: Record<Side, Triple> = { top: [0, 0, 1], front: [0, -1, 0], right: [1, 0, 0], iso: [-1, -1.4, 1.1] };

const PICK_PIXELS = 12;

function lineBox(min: Triple, max: Triple, colour: string): THREE.LineSegments {
  const geometry = new THREE.EdgesGeometry(new THREE.BoxGeometry(max[0] - min[0], max[1] - min[1], max[2] - min[2]));
  const box = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }));
  box.position.set((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
  return box;
}

// What is placed in millimetres and drawn in pixels.
interface Marker {
  readonly object: THREE.Object3D;
  at: Triple;
}

export class PathView {
  readonly element: HTMLElement;
  colouring: Colouring | null = null;
  onColouring: (colouring: Colouring) => void = () => undefined;
  private readonly canvas = h("canvas", { tabindex: "0", "aria-label": "Tool path. Drag to turn, right drag to move, wheel to zoom" });
  private readonly overlay = h("canvas", { class: "overlay", "aria-hidden": "true" });
  private readonly tip = h("div", { class: "tip", hidden: true });
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera();
  private readonly controls: OrbitControls;
  private path: THREE.Object3D | null = null;
  private lineMark: THREE.Object3D | null = null;
  private markedRun = "";
  private furniture = new THREE.Group();
  private markers: Marker[] = [];
  private places: Place[] = [];
  private tool: Marker;
  private plan: Plan | null = null;
  private box: { min: Triple; max: Triple } = { min: [0, 0, 0], max: [0, 0, 0] };
  private scheduled = false;
  private ground: Ground;
  private readonly store: Store;

  // Throws where the browser has no WebGL.
  constructor(store: Store, ground: Ground) {
    this.store = store;
    this.ground = ground;
    THREE.ColorManagement.enabled = false; // colours are drawn as they are
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.renderer.info.autoReset = true;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("end", () => this.store.set({ camera: this.cameraText() }, "path"));
    const cone = new THREE.Mesh(new THREE.ConeGeometry(6, 17, 24), new THREE.MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.85 }));
    cone.geometry.rotateX(-Math.PI / 2).translate(0, 0, 8.5);
    cone.renderOrder = 10;
    this.tool = { object: cone, at: [0, 0, 0] };
    this.scene.add(cone, this.furniture);
    this.element = h("div", { class: "path-view" }, this.canvas, this.overlay, this.tip);
    let moved: PointerEvent | null = null;
    this.canvas.addEventListener("pointermove", (event) => {
      if (moved === null) {
        requestAnimationFrame(() => {
          if (moved) this.hover(moved);
          moved = null;
        });
      }
      moved = event;
    });
    this.canvas.addEventListener("pointerleave", () => {
      moved = null;
      this.leave();
    });
    let down: [number, number] = [0, 0];
    this.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener("click", (event) => {
      const moved = Math.hypot(event.clientX - down[0], event.clientY - down[1]);
      const tick = moved < 4 ? this.pick(event) : null;
      if (tick !== null) this.store.set({ tick, hover: null, playing: false }, "path");
    });
    new ResizeObserver(() => this.resize()).observe(this.element);
    store.listen((_state, change) => {
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("colourBy" in change) this.paint();
      else if ("shown" in change) this.repaint();
      if ("units" in change) this.draw();
    });
  }

  show(plan: Plan): void {
    this.plan = plan.motion ? plan : null;
    this.markedRun = "";
    this.furniture.clear();
    this.markers = [];
    if (!this.plan) {
      this.paint();
      return;
    }
    this.box = boxOfCut(plan);
    this.furnish(plan);
    this.paint();
    this.showInstant();
  }

  setGround(ground: Ground): void {
    this.ground = ground;
    if (this.plan) {
      this.furniture.clear();
      this.markers = [];
      this.furnish(this.plan);
    }
    this.markedRun = "";
    this.paint();
    this.showInstant();
  }

  // Travel, work offset, machine zero, start.
  private furnish(plan: Plan): void {
    const axes = plan.header.machine.axes.slice(0, 3);
    const travel = axes.map((axis) => axis.travel);
    if (travel.every(([min, max]) => min !== null && max !== null)) {
      const corner = (i: 0 | 1): Triple => [travel[0]![i]!, travel[1]![i]!, travel[2]![i]!];
      this.furniture.add(lineBox(corner(0), corner(1), this.ground.faint));
    }
    const place = (at: Triple, size: number): void => {
      const object = new THREE.AxesHelper(size);
      (object.material as THREE.LineBasicMaterial).depthTest = false;
      object.renderOrder = 5;
      this.furniture.add(object);
      this.markers.push({ object, at });
    };
    const work = plan.header.machine.work_offsets[0];
    place(work ? [...work.origin_mm] : [0, 0, 0], 26);
    this.places = placesOf(plan);
    (this.tool.object as THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>).material.color.set(this.ground.accent);
  }

  private paint(): void {
    if (this.plan) {
      this.colouring = colouringOf(this.plan, this.store.state.colourBy, this.ground);
      this.onColouring(this.colouring);
    }
    this.repaint();
  }

  private repaint(): void {
    if (this.path) {
      this.scene.remove(this.path);
      (this.path as THREE.Mesh).geometry.dispose();
      this.path = null;
    }
    if (this.plan && this.colouring) {
      this.path = strokes(stretchesOf(this.plan, this.colouring, this.store.state.shown, this.ground), 2.2);
      this.scene.add(this.path);
    }
    this.scene.background = new THREE.Color(...this.ground.rgb);
    this.draw();
  }

  private showInstant(): void {
    if (!this.plan) return;
    const tick = this.store.instant;
    this.tool.at = this.plan.positionAt(tick);
    this.markLine(this.plan.runAt(tick));
    this.draw();
  }

  // The stretches of the run that the instant is in, and of its neighbours of the same line.
  private markLine(run: number): void {
    const { runs } = this.plan!.motion!;
    let first = run;
    let last = run;
    while (first > 0 && runs.line[first - 1] === runs.line[run]) --first;
    while (last + 1 < runs.line.length && runs.line[last + 1] === runs.line[run]) ++last;
    const name = `${first} ${last}`;
    if (name === this.markedRun) return;
    this.markedRun = name;
    if (this.lineMark) {
      this.scene.remove(this.lineMark);
      (this.lineMark as THREE.Mesh).geometry.dispose();
    }
    // A broad band below the path, whose colours stay as they are.
    this.lineMark = strokes(markOf(this.plan!, { first, last }, this.ground), 8);
    const { material } = this.lineMark as THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
    material.depthTest = material.depthWrite = false;
    this.lineMark.renderOrder = -1;
    this.scene.add(this.lineMark);
  }

  look(side: Side): void {
    const direction = new THREE.Vector3(...DIRECTIONS[side]).normalize();
    const far = this.reach();
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.controls.target).addScaledVector(direction, far);
    if (side === "top") this.camera.position.y -= far * 1e-4; // y stays upwards
    this.fit();
  }

  // As near as all of the cut is seen.
  fit(): void {
    const { min, max } = this.box;
    const middle = new THREE.Vector3(...min).add(new THREE.Vector3(...max)).multiplyScalar(0.5);
    const offset = this.camera.position.clone().sub(this.controls.target).setLength(this.reach());
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(offset);
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    let [width, height] = [0, 0];
    for (let corner = 0; corner < 8; ++corner) {
      const point = new THREE.Vector3(corner & 1 ? max[0] : min[0], corner & 2 ? max[1] : min[1], corner & 4 ? max[2] : min[2]);
      point.applyMatrix4(this.camera.matrixWorldInverse);
      width = Math.max(width, 2 * Math.abs(point.x));
      height = Math.max(height, 2 * Math.abs(point.y));
    }
    const { clientWidth, clientHeight } = this.element;
    const zoom = 0.86 * Math.min(clientWidth / Math.max(width, 1e-3), clientHeight / Math.max(height, 1e-3));
    this.camera.zoom = Math.min(zoom, 1e5);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  // Farther than anything that is drawn.
  private reach(): number {
    const all = [...this.box.min, ...this.box.max, ...(this.plan?.header.machine.axes.slice(0, 3).flatMap((axis) => [axis.travel[0] ?? 0, axis.travel[1] ?? 0]) ?? [])];
    return 4 * Math.max(1, ...all.map(Math.abs));
  }

  // From the fragment; a fitted view from above the corner where it says nothing.
  restore(camera: string): void {
    const numbers = camera.split(",").map(Number);
    const [px, py, pz, tx, ty, tz, zoom] = numbers;
    if (camera === "" || numbers.length !== 7 || !numbers.every(Number.isFinite)) {
      const { min, max } = this.box;
      const flat = max[2] - min[2] <= 0.002 * Math.max(max[0] - min[0], max[1] - min[1]);
      this.look(flat ? "top" : "iso");
      return;
    }
    this.controls.target.set(tx!, ty!, tz!);
    this.camera.position.set(px!, py!, pz!);
    this.camera.zoom = zoom!;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  private cameraText(): string {
    const numbers = [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom];
    return numbers.map((number) => String(Number(number.toPrecision(6)))).join(",");
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.overlay.width = width * window.devicePixelRatio;
    this.overlay.height = height * window.devicePixelRatio;
    Object.assign(this.camera, { left: -width / 2, right: width / 2, top: height / 2, bottom: -height / 2 });
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  private draw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      const began = performance.now();
      this.render();
      // What the frame cost, for who wants to know.
      this.canvas.dataset["scriptMs"] = (performance.now() - began).toFixed(2);
    });
  }

  private render(): void {
    const reach = this.reach();
    this.camera.near = -4 * reach;
    this.camera.far = 8 * reach;
    this.camera.updateProjectionMatrix();
    for (const marker of [...this.markers, this.tool]) {
      marker.object.position.set(...marker.at);
      marker.object.scale.setScalar(1 / this.camera.zoom);
    }
    this.tool.object.visible = this.plan !== null;
    this.renderer.render(this.scene, this.camera);
    this.canvas.dataset["vertices"] = String(this.countVertices());
    const { clientWidth: width, clientHeight: height } = this.element;
    const pen = this.overlay.getContext("2d")!;
    pen.setTransform(window.devicePixelRatio, 0, 0, window.devicePixelRatio, 0, 0);
    drawOverlay({ pen, width, height, camera: this.camera, ground: this.ground }, this.store.state.units, this.plan ? this.places : []);
  }

  private countVertices(): number {
    let vertices = 0;
    this.scene.traverseVisible((object) => {
      const geometry = (object as THREE.Mesh).geometry as THREE.BufferGeometry | undefined;
      if (!geometry) return;
      const copies = geometry instanceof THREE.InstancedBufferGeometry ? geometry.instanceCount : 1;
      vertices += copies * (geometry.getAttribute("position")?.count ?? 0);
    });
    return vertices;
  }

  // The tick at which the tool passes nearest to the pointer; null: nowhere near it.
  private pick(event: MouseEvent): number | null {
    if (!this.plan) return null;
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const projection = new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const pointing = pointingOf(projection.elements, { width, height }, { x: event.clientX - left, y: event.clientY - top });
    return tickNear(this.plan.motion!.path, pointing, PICK_PIXELS);
  }

  private hover(event: PointerEvent): void {
    if (event.buttons !== 0 || this.store.state.playing) return;
    const tick = this.pick(event);
    if (tick === null) {
      this.leave();
      return;
    }
    this.store.set({ hover: tick }, "path");
    const { units } = this.store.state;
    const at = this.plan!.positionAt(tick);
    const line = this.plan!.motion!.runs.line[this.plan!.runAt(tick)]!;
    this.tip.textContent = `line ${line}   ${at.map((mm, k) => `${"XYZ"[k]} ${lengthText(mm, units)}`).join("  ")} ${lengthUnit(units)}`;
    this.tip.hidden = false;
    const rect = this.element.getBoundingClientRect();
    const left = Math.min(event.clientX - rect.left + 14, rect.width - this.tip.offsetWidth - 6);
    const top = event.clientY - rect.top + 18;
    this.tip.style.left = `${left}px`;
    this.tip.style.top = `${top + this.tip.offsetHeight > rect.height ? top - 56 : top}px`;
  }

  private leave(): void {
    this.tip.hidden = true;
    if (this.store.state.hover !== null) this.store.set({ hover: null }, "path");
  }
}
