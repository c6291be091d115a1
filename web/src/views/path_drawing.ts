// What draws the path: a canvas, its WebGL and the scene.
import * as THREE from "three";
import { h } from "../ui/dom.ts";
import { PathScene } from "./path_scene.ts";

export interface PathDrawing {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: THREE.WebGLRenderer;
  readonly scene: PathScene;
}

function rendererOn(canvas: HTMLCanvasElement): THREE.WebGLRenderer | null {
  try {
    return new THREE.WebGLRenderer({ canvas, antialias: true });
  } catch {
    return null;
  }
}

// Null: the browser has no WebGL. Its shaders are compiled beside what the page does next.
export function pathDrawing(): PathDrawing | null {
  THREE.ColorManagement.enabled = false; // colours are drawn as they are
  const canvas = h("canvas", { tabindex: "0", role: "application", "aria-label": "Tool path. Drag or arrow keys to turn, right drag or Shift to move, wheel, plus and minus to zoom" });
  const renderer = rendererOn(canvas);
  if (!renderer) return null;
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.debug.checkShaderErrors = false; // each is a question to another process; the browser says what it cannot draw
  const scene = new PathScene();
  renderer.compile(scene.scene, new THREE.OrthographicCamera());
  return { canvas, renderer, scene };
}

// Draws the scene once, before a plan is in it and the canvas in the page. A driver makes much of a shader when it is first drawn
// with: so it does that beside what the page does next, and the first frame need not wait.
export function warmUp({ renderer, scene }: PathDrawing): void {
  renderer.render(scene.scene, new THREE.OrthographicCamera());
}
