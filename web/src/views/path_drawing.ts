// What draws the path: a canvas, its WebGL and the scene.
import * as THREE from "three";
import { h } from "../ui/dom.ts";
import { PathScene } from "./path_scene.ts";

export class PathDrawing {
  readonly canvas = h("canvas", { tabindex: "0", role: "application", "aria-label": "Tool path. Drag or arrow keys to turn, right drag or Shift to move, wheel, plus and minus to zoom" });
  readonly renderer: THREE.WebGLRenderer;
  readonly scene = new PathScene();

  // Throws where the browser has no WebGL. Its shaders are compiled beside what the page does next: made early, they are ready
  // by the first frame.
  constructor() {
    THREE.ColorManagement.enabled = false; // colours are drawn as they are
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.compile(this.scene.scene, new THREE.OrthographicCamera());
  }
}

// Null: no WebGL. The panel says so, and all else works.
export function pathDrawing(): PathDrawing | null {
  try {
    return new PathDrawing();
  } catch {
    return null;
  }
}
