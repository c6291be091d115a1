// Lines of some pixels' width, one colour a stretch, dashed where they are rapids.
import * as THREE from "three";

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

const THIN_VERTEX = `
attribute vec3 tint;
attribute float dashed;
attribute float along;
varying vec3 vTint;
varying float vDashed;
varying float vAlong;
uniform float pixelsPerMm;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vTint = tint;
  vDashed = dashed;
  vAlong = along * pixelsPerMm;
}`;

export interface Stretches {
  readonly a: Float32Array; // x, y, z of each begin
  readonly b: Float32Array;
  readonly tint: Uint8Array; // r, g, b
  readonly dashed: Uint8Array;
  readonly along: Float32Array; // mm from where the dashes begin to the stretch
}

// Of the view, in the pixels that are drawn.
function pixelsPerMm(renderer: THREE.WebGLRenderer, camera: THREE.Camera): number {
  return (camera as THREE.OrthographicCamera).zoom * renderer.getPixelRatio();
}

// A quad has 4 vertices and a thin line 2: up to 75,000 stretches are quads.
export const MOST_QUADS = 75_000;

export function strokes(stretches: Stretches, width: number): THREE.Object3D {
  const count = stretches.dashed.length;
  return count <= MOST_QUADS ? quads(stretches, width) : thinLines(stretches);
}

function quads(stretches: Stretches, width: number): THREE.Object3D {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.setAttribute("a", new THREE.InstancedBufferAttribute(stretches.a, 3));
  geometry.setAttribute("b", new THREE.InstancedBufferAttribute(stretches.b, 3));
  geometry.setAttribute("tint", new THREE.InstancedBufferAttribute(stretches.tint, 3, true));
  geometry.setAttribute("dashed", new THREE.InstancedBufferAttribute(stretches.dashed, 1));
  geometry.setAttribute("along", new THREE.InstancedBufferAttribute(stretches.along, 1));
  geometry.instanceCount = stretches.dashed.length;
  const material = new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { viewport: { value: new THREE.Vector2(1, 1) }, width: { value: width }, pixelsPerMm: { value: 1 }, opacity: { value: 1 }, dash: { value: 9 } },
    side: THREE.DoubleSide,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.onBeforeRender = (renderer, _scene, camera) => {
    renderer.getDrawingBufferSize(material.uniforms["viewport"]!.value as THREE.Vector2);
    const ratio = renderer.getPixelRatio();
    material.uniforms["width"]!.value = width * ratio;
    material.uniforms["pixelsPerMm"]!.value = pixelsPerMm(renderer, camera);
    material.uniforms["dash"]!.value = 9 * ratio;
  };
  return mesh;
}

function twice(values: Uint8Array, size: number): Uint8Array {
  const doubled = new Uint8Array(2 * values.length);
  for (let i = 0; i < values.length / size; ++i) {
    const part = values.subarray(size * i, size * (i + 1));
    doubled.set(part, 2 * size * i);
    doubled.set(part, 2 * size * i + size);
  }
  return doubled;
}

function thinLines(stretches: Stretches): THREE.Object3D {
  const count = stretches.dashed.length;
  const position = new Float32Array(6 * count);
  const along = new Float32Array(2 * count);
  for (let i = 0; i < count; ++i) {
    const [a, b] = [stretches.a.subarray(3 * i, 3 * i + 3), stretches.b.subarray(3 * i, 3 * i + 3)];
    position.set(a, 6 * i);
    position.set(b, 6 * i + 3);
    along[2 * i] = stretches.along[i]!;
    along[2 * i + 1] = stretches.along[i]! + Math.hypot(b[0]! - a[0]!, b[1]! - a[1]!, b[2]! - a[2]!);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
  geometry.setAttribute("along", new THREE.BufferAttribute(along, 1));
  geometry.setAttribute("tint", new THREE.BufferAttribute(twice(stretches.tint, 3), 3, true));
  geometry.setAttribute("dashed", new THREE.BufferAttribute(twice(stretches.dashed, 1), 1));
  const material = new THREE.ShaderMaterial({
    vertexShader: THIN_VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { pixelsPerMm: { value: 1 }, opacity: { value: 1 }, dash: { value: 9 } },
  });
  const lines = new THREE.LineSegments(geometry, material);
  lines.frustumCulled = false;
  lines.onBeforeRender = (renderer, _scene, camera) => {
    material.uniforms["pixelsPerMm"]!.value = pixelsPerMm(renderer, camera);
    material.uniforms["dash"]!.value = 9 * renderer.getPixelRatio();
  };
  return lines;
}
