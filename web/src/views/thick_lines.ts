// Lines of some pixels' width, one colour a stretch, dashed where they are rapids.
import * as THREE from "three";
import { countOf, type Stretches } from "./stretches.ts";

const VERTEX = `
attribute vec3 a;
attribute vec3 b;
attribute vec3 tint;
attribute float dashed;
attribute float along;
uniform vec2 viewport;
uniform float width;
uniform float pixelsPerMm;
varying vec3 vTint;
varying float vDashed;
varying float vAlong;
void main() {
  vec4 ca = projectionMatrix * modelViewMatrix * vec4(a, 1.0);
  vec4 cb = projectionMatrix * modelViewMatrix * vec4(b, 1.0);
  vec2 pa = ca.xy / ca.w * viewport * 0.5;
  vec2 pb = cb.xy / cb.w * viewport * 0.5;
  vec2 way = pb - pa;
  float size = length(way);
  vec2 ahead = size > 1e-4 ? way / size : vec2(1.0, 0.0);
  vec2 aside = vec2(-ahead.y, ahead.x);
  // Half a width beyond both ends, so that corners have no gap.
  vec2 at = (position.x < 0.5 ? pa - ahead * width * 0.5 : pb + ahead * width * 0.5) + aside * position.y * width * 0.5;
  vec4 c = position.x < 0.5 ? ca : cb;
  gl_Position = vec4(at / viewport * 2.0 * c.w, c.z, c.w);
  vTint = tint;
  vDashed = dashed;
  vAlong = (along + position.x * distance(a, b)) * pixelsPerMm;
}`;

const FRAGMENT = `
varying vec3 vTint;
varying float vDashed;
varying float vAlong;
uniform float opacity;
uniform float dash;
void main() {
  if (vDashed > 0.5 && fract(vAlong / dash) > 0.55) discard;
  gl_FragColor = vec4(vTint, opacity);
}`;

// Of the view, in the pixels that are drawn.
function pixelsPerMm(renderer: THREE.WebGLRenderer, camera: THREE.Camera): number {
  return (camera as THREE.OrthographicCamera).zoom * renderer.getPixelRatio();
}

// Of a stretch, in `data-vertices` and in the limit of 300,000.
export const VERTICES = 4;

// At most `capacity` stretches, each a quad of some pixels' width; others may take their place at any time.
export class Strokes {
  readonly object: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;
  private readonly attributes: Record<keyof Stretches, THREE.InstancedBufferAttribute>;

  constructor(capacity: number, width: number) {
    this.attributes = {
      a: new THREE.InstancedBufferAttribute(new Float32Array(3 * capacity), 3),
      b: new THREE.InstancedBufferAttribute(new Float32Array(3 * capacity), 3),
      tint: new THREE.InstancedBufferAttribute(new Uint8Array(3 * capacity), 3, true),
      dashed: new THREE.InstancedBufferAttribute(new Uint8Array(capacity), 1),
      along: new THREE.InstancedBufferAttribute(new Float32Array(capacity), 1),
    };
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    for (const [name, attribute] of Object.entries(this.attributes)) geometry.setAttribute(name, attribute);
    geometry.instanceCount = 1; // of no length, until it is filled
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { viewport: { value: new THREE.Vector2(1, 1) }, width: { value: width }, pixelsPerMm: { value: 1 }, opacity: { value: 1 }, dash: { value: 9 } },
      side: THREE.DoubleSide,
    });
    this.object = new THREE.Mesh(geometry, material);
    this.object.frustumCulled = false;
    this.object.onBeforeRender = (renderer, _scene, camera) => {
      renderer.getDrawingBufferSize(material.uniforms["viewport"]!.value as THREE.Vector2);
      const ratio = renderer.getPixelRatio();
      material.uniforms["width"]!.value = width * ratio;
      material.uniforms["pixelsPerMm"]!.value = pixelsPerMm(renderer, camera);
      material.uniforms["dash"]!.value = 9 * ratio;
    };
  }

  fill(parts: readonly Stretches[]): void {
    let count = 0;
    for (const part of parts) {
      for (const [name, attribute] of Object.entries(this.attributes)) attribute.array.set(part[name as keyof Stretches], count * attribute.itemSize);
      count += countOf(part);
    }
    for (const attribute of Object.values(this.attributes)) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.object.geometry.instanceCount = count;
  }
}
