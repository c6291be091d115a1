// Over the path: the axes' directions, the scale, and the names of places.
import * as THREE from "three";
import { hexOf } from "../colours.ts";
import { fitsOf, workOffsetsOf } from "../plan/account.ts";
import type { Path, Plan } from "../plan/plan.ts";
import { MM_PER_INCH, lengthText, lengthUnit, plain, type Units } from "../units.ts";
import type { Ground } from "./ground.ts";
import { Labels, type Corner } from "./labels.ts";
import type { Triple } from "./stretches.ts";

// A place with a name.
export interface Place {
  readonly at: Triple;
  readonly text: string;
  readonly over_mm?: number; // told after the text
}

// Where the program begins, where its zeros are, where it is farthest from the programmed path.
export function placesOf(plan: Plan, path: Path): Place[] {
  const at = (i: number): Triple => [path.xyz[0][i] ?? 0, path.xyz[1][i] ?? 0, path.xyz[2][i] ?? 0];
  const start = at(0);
  const zeros = workOffsetsOf(plan);
  const atStart = zeros.filter(({ origin_mm }) => origin_mm.every((mm, k) => Math.abs(mm - start[k]!) < 1e-6));
  const places: Place[] = [{ at: start, text: ["start", ...atStart.map(({ name }) => name)].join(", ") }];
  for (const zero of zeros) if (!atStart.includes(zero)) places.push({ at: [...zero.origin_mm], text: zero.name });
  const deviation = plan.header.report.deviation;
  const farthest = deviation?.at_mm;
  if (deviation && farthest && deviation.max_mm >= 5e-7) places.push({ at: [farthest["x"] ?? 0, farthest["y"] ?? 0, farthest["z"] ?? 0], text: "largest deviation" });
  // Where it is farthest out of the travel, by axis.
  fitsOf(plan).forEach(({ axis, over, min, travel }, k) => {
    const values = path.xyz[k];
    if (!values || over === 0) return;
    const isLow = travel[0] !== null && travel[0] - min === over;
    const worst = values.indexOf(values.reduce((a, b) => (isLow ? Math.min(a, b) : Math.max(a, b))));
    places.push({ at: at(worst), text: `${axis.toUpperCase()} ${isLow ? "below" : "above"} the travel`, over_mm: over });
  });
  return places;
}

export interface Overlay {
  readonly pen: CanvasRenderingContext2D; // in CSS pixels
  readonly width: number;
  readonly height: number;
  readonly camera: THREE.OrthographicCamera;
  readonly ground: Ground;
  readonly covered: Corner; // by the legend
}

export function drawOverlay(overlay: Overlay, units: Units, places: readonly Place[]): void {
  const { pen, width, height } = overlay;
  pen.clearRect(0, 0, width, height);
  pen.textBaseline = "middle";
  pen.font = "600 12px system-ui, sans-serif";
  pen.textAlign = "center";
  drawAxes(overlay);
  drawScale(overlay, units);
  drawPlaces(
    overlay,
    places.map(({ at, text, over_mm }) => ({ at, text: over_mm === undefined ? text : `${text} by ${lengthText(over_mm, units)} ${lengthUnit(units)}` })),
  );
}

function drawAxes({ pen, height, camera, ground }: Overlay): void {
  const turn = new THREE.Matrix4().extractRotation(camera.matrixWorldInverse);
  const colours = ground.dark ? ["#ff7b72", "#56d364", "#79c0ff"] : ["#c62828", "#1b7a34", "#1556b0"];
  ["X", "Y", "Z"].forEach((name, k) => {
    const way = new THREE.Vector3().setComponent(k, 1).applyMatrix4(turn);
    if (Math.hypot(way.x, way.y) < 0.05) return;
    pen.strokeStyle = pen.fillStyle = colours[k]!;
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(40, height - 40);
    pen.lineTo(40 + 24 * way.x, height - 40 - 24 * way.y);
    pen.stroke();
    pen.fillText(name, 40 + 33 * way.x, height - 40 - 33 * way.y);
  });
}

// A round length of some 100 pixels at most.
function drawScale({ pen, height, camera, ground }: Overlay, units: Units): void {
  const perUnit = units.length === "mm" ? camera.zoom : camera.zoom * MM_PER_INCH;
  const wanted = 110 / perUnit;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const size = [5, 2, 1].map((n) => n * power).find((n) => n <= wanted) ?? power;
  const left = 88;
  pen.strokeStyle = pen.fillStyle = ground.text;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(left, height - 28);
  pen.lineTo(left, height - 22);
  pen.lineTo(left + size * perUnit, height - 22);
  pen.lineTo(left + size * perUnit, height - 28);
  pen.stroke();
  pen.fillText(`${plain(size, 1)} ${lengthUnit(units)}`, left + (size * perUnit) / 2, height - 34);
}

function drawPlaces({ pen, width, height, camera, ground, covered }: Overlay, places: readonly Place[]): void {
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "left";
  const labels = new Labels(covered);
  for (const { at, text } of places) {
    const point = new THREE.Vector3(...at).project(camera);
    const [x, y] = [((point.x + 1) * width) / 2, ((1 - point.y) * height) / 2];
    pen.strokeStyle = ground.text;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.arc(x, y, 4, 0, 2 * Math.PI);
    pen.stroke();
    // A rim in the colour of the ground keeps the words legible over lines.
    pen.strokeStyle = hexOf(ground.rgb);
    pen.lineWidth = 3.5;
    // To the left of a place at the right edge.
    const wide = pen.measureText(text).width;
    const left = x <= width && x + 8 + wide > width ? x - 8 - wide : x + 8;
    const top = labels.freeY({ left, width: wide, y: y - 9 });
    pen.strokeText(text, left, top);
    pen.fillStyle = ground.text;
    pen.fillText(text, left, top);
  }
}
