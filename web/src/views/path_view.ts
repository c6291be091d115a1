// The path in space: what is drawn, from where, and what is pointed at.
import type * as THREE from "three";
import type { Plan } from "../plan/plan.ts";
import type { Store } from "../state.ts";
import { h } from "../ui/dom.ts";
import type { Ground } from "./ground.ts";
import { PathCamera, type Size, type Side } from "./path_camera.ts";
import { chosenParts, colouringOf, type Colouring } from "./path_colours.ts";
import type { PathDrawing } from "./path_drawing.ts";
import { drawOverlay, placesOf, type Place } from "./path_overlay.ts";
import { PathPointer } from "./path_pointer.ts";
import type { PathScene } from "./path_scene.ts";
import { boxOfCut } from "./stretches.ts";

const SHOW_MS = 250; // so often a view that becomes finer is drawn
const PAUSE_MS = 5; // for all else that the page has to do
const NOTES = {
  thinned: "more rapids than the path has points here: some are joined with what is beside them",
  coarse: "more rests and rapids than fit this view: some are joined with what is beside them; zoom in",
};

export class PathView {
  readonly element: HTMLElement;
  colouring: Colouring | null = null;
  onColouring: (colouring: Colouring) => void = () => undefined;
  private readonly canvas: HTMLCanvasElement;
  private readonly overlay = h("canvas", { class: "overlay", "aria-hidden": "true" });
  private readonly note = h("div", { class: "path-note", "data-test": "path-note" });
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene: PathScene;
  private readonly camera: PathCamera;
  private readonly pointer: PathPointer;
  private places: Place[] = [];
  private avoided: HTMLElement | null = null; // what stands over its lower right corner
  private corner: Size = { width: 0, height: 0 }; // that it covers
  private size = ""; // in pixels of the screen; empty: it is not seen
  private plan: Plan | null = null; // null: it has no path
  private furnished: Plan | null = null; // also one without a path
  private scheduled = false;
  private refining: ReturnType<typeof setTimeout> | undefined;
  private ground: Ground;
  private readonly store: Store;

  constructor({ canvas, renderer, scene }: PathDrawing, store: Store, ground: Ground) {
    this.canvas = canvas;
    this.renderer = renderer;
    this.scene = scene;
    this.store = store;
    this.ground = ground;
    this.camera = new PathCamera(this.canvas, () => this.draw(), () => store.set({ camera: this.camera.text }, "path"));
    this.pointer = new PathPointer(store, this.canvas, () => this.camera.projection);
    this.element = h("div", { class: "path-view" }, this.canvas, this.overlay, this.note, this.pointer.tip);
    new ResizeObserver(() => this.measure()).observe(this.element);
    store.listen((_state, change) => {
      if ("tick" in change || "hover" in change) this.showInstant();
      if ("colourBy" in change) this.paint();
      else if ("shown" in change) this.repaint();
      if ("units" in change) this.draw();
    });
  }

  show(plan: Plan): void {
    this.plan = plan.path ? plan : null;
    this.pointer.show(this.plan);
    this.scene.show(plan.path);
    this.furnished = plan;
    this.scene.furnish(plan, this.ground);
    if (plan.path) {
      const travel = plan.header.machine.axes.slice(0, 3).flatMap((axis) => axis.travel.map((end) => end ?? 0));
      this.camera.setScene(boxOfCut(plan.path), travel);
      this.places = placesOf(plan, plan.path);
    }
    this.paint();
    this.showInstant();
  }

  setGround(ground: Ground): void {
    this.ground = ground;
    if (this.furnished) this.scene.furnish(this.furnished, ground);
    this.paint();
    this.showInstant();
  }

  look(side: Side): void {
    this.camera.look(side);
  }

  fit(): void {
    this.camera.fit();
  }

  // All panels are there.
  restore(camera: string): void {
    this.measure(); // else the first frame would be drawn twice: before the observers speak, and after
    if (this.plan) this.camera.restore(camera);
  }

  private paint(): void {
    this.colouring = this.plan?.path ? colouringOf(this.plan, this.plan.path, this.store.state.colourBy, this.ground) : null;
    if (this.colouring) this.onColouring(this.colouring);
    this.repaint();
  }

  private repaint(): void {
    if (this.colouring) this.scene.colour(this.colouring, chosenParts(this.colouring.legend, this.store.state.shown), this.ground);
    this.draw();
  }

  private showInstant(): void {
    if (!this.plan?.motion) return;
    const tick = this.store.instant;
    this.scene.placeTool(this.plan.positionAt(tick));
    this.scene.markRun(this.plan, this.plan.runAt(tick), this.ground);
    this.draw();
  }

  // What stands over its lower right corner: names of places keep off it.
  avoid(element: HTMLElement): void {
    this.avoided = element;
    new ResizeObserver(() => this.measure()).observe(element);
  }

  private measure(): void {
    if (this.avoided) this.cover(this.avoided);
    const { clientWidth: width, clientHeight: height } = this.element;
    const size = width === 0 || height === 0 ? "" : `${width} ${height} ${window.devicePixelRatio}`;
    if (size === this.size) return;
    this.size = size;
    if (size !== "") this.resize(width, height);
  }

  private cover(element: HTMLElement): void {
    const { clientWidth: width, clientHeight: height } = element;
    const margin = width > 0 ? parseFloat(getComputedStyle(element).right) || 0 : 0;
    const corner = { width: width + margin, height: height + margin };
    if (corner.width === this.corner.width && corner.height === this.corner.height) return;
    this.corner = corner;
    this.camera.cover(corner);
    this.draw();
  }

  private resize(width: number, height: number): void {
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.overlay.width = width * window.devicePixelRatio;
    this.overlay.height = height * window.devicePixelRatio;
    this.camera.resize(width, height);
    this.draw();
  }

  private draw(): void {
    if (this.scheduled || this.size === "") return;
    this.scheduled = true;
    clearTimeout(this.refining); // the frame sees to it
    requestAnimationFrame(() => {
      this.scheduled = false;
      const began = performance.now();
      this.render();
      // What the frame cost, for who wants to know.
      this.canvas.dataset["scriptMs"] = (performance.now() - began).toFixed(2);
    });
  }

  private render(): void {
    this.camera.prepare();
    const { camera } = this.camera;
    const isWhole = this.scene.prepare(this.camera.projection, camera.zoom);
    this.renderer.render(this.scene.scene, camera);
    const note = this.plan?.header.path_tells_rapids === false ? NOTES.thinned : this.scene.joinsRests ? NOTES.coarse : "";
    if (this.note.textContent !== note) this.note.textContent = note;
    this.canvas.dataset["vertices"] = String(this.scene.vertices);
    const { clientWidth: width, clientHeight: height } = this.element;
    const pen = this.overlay.getContext("2d")!;
    pen.setTransform(window.devicePixelRatio, 0, 0, window.devicePixelRatio, 0, 0);
    const covered = { left: width - this.corner.width, top: height - this.corner.height };
    drawOverlay({ pen, width, height, camera, ground: this.ground, covered }, this.store.state.units, this.plan ? this.places : []);
    this.canvas.dataset["whole"] = String(isWhole);
    if (!isWhole) this.refine();
  }

  // Makes finer lines until the view has all or more of them are worth a frame: where the processor draws, one takes long.
  private refine(): void {
    const drawn_ms = performance.now();
    const goOn = (): void => {
      const isWhole = this.scene.makeLines(this.camera.projection, this.camera.camera.zoom);
      if (isWhole || performance.now() > drawn_ms + SHOW_MS) this.draw();
      else this.refining = setTimeout(goOn, PAUSE_MS);
    };
    goOn();
  }
}
