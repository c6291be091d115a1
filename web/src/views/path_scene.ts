// What stands in the view of the path: the path itself, the line that the tool is in, travel, zeros and the tool.
import * as THREE from "three";
import { workOffsetsOf } from "../plan/account.ts";
import type { Path, Plan } from "../plan/plan.ts";
import type { Ground } from "./ground.ts";
import type { Colouring } from "./path_colours.ts";
import { MOST_STRETCHES, PathPaint } from "./path_paint.ts";
import { MOST_OF_MARK, markOf, type Triple } from "./stretches.ts";
import { Strokes } from "./thick_lines.ts";

const PAINT_MS = 3; // at once, for lines in other fineness

// From 0 to 1 along each axis.
function unitBox(): THREE.LineSegments<THREE.EdgesGeometry, THREE.LineBasicMaterial> {
  const geometry = new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1));
  geometry.translate(0.5, 0.5, 0.5);
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial());
}

function toolCone(): THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial> {
  const cone = new THREE.Mesh(new THREE.ConeGeometry(6, 17, 24), new THREE.MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.85 }));
  cone.geometry.rotateX(-Math.PI / 2).translate(0, 0, 8.5);
  cone.renderOrder = 10;
  return cone;
}

export class PathScene {
  readonly scene = new THREE.Scene();
  private readonly lines = new Strokes(MOST_STRETCHES, 2.2);
  private readonly mark = new Strokes(MOST_OF_MARK + 2, 8); // a broad band below the path, whose colours stay as they are
  private readonly travel = unitBox();
  private readonly zero = new THREE.AxesHelper(26); // its copies and the tool are placed in millimetres and drawn in pixels
  private readonly zeros = new THREE.Group();
  private readonly tool = toolCone();
  private paint: PathPaint | null = null;
  private markedRun = "";

  constructor() {
    const { material } = this.mark.object;
    material.depthTest = material.depthWrite = false;
    this.mark.object.renderOrder = -1;
    (this.zero.material as THREE.LineBasicMaterial).depthTest = false;
    this.zero.renderOrder = 5;
    this.zeros.add(this.zero); // until a plan is shown: whoever draws the scene before has all that it draws after
    this.scene.add(this.lines.object, this.mark.object, this.travel, this.zeros, this.tool);
  }

  show(path: Path | null): void {
    this.paint = path ? new PathPaint(path) : null;
    this.lines.fill([]);
    this.mark.fill([]);
    this.markedRun = "";
    this.zeros.visible = path !== null;
    this.tool.visible = false;
  }

  // Travel box and work offsets.
  furnish(plan: Plan, ground: Ground): void {
    const travel = plan.header.machine.axes.slice(0, 3).map((axis) => axis.travel);
    this.travel.visible = plan.path !== null && travel.every(([min, max]) => min !== null && max !== null);
    this.travel.position.set(...travel.map(([min]) => min ?? 0) as Triple);
    this.travel.scale.set(...travel.map(([min, max]) => (max ?? 0) - (min ?? 0)) as Triple);
    this.travel.material.color.set(ground.faint);
    this.zeros.clear();
    for (const { origin_mm } of workOffsetsOf(plan)) {
      const zero = this.zero.clone();
      zero.position.set(...origin_mm);
      this.zeros.add(zero);
    }
    this.tool.material.color.set(ground.accent);
    this.scene.background = new THREE.Color(...ground.rgb);
    this.markedRun = "";
  }

  colour(colouring: Colouring, shown: readonly number[] | null, ground: Ground): void {
    this.paint?.colour(colouring, shown, ground);
  }

  placeTool(at: Triple): void {
    this.tool.visible = true;
    this.tool.position.set(...at);
  }

  // The stretches of the run that the instant is in, and of its neighbours of the same line.
  markRun(plan: Plan, run: number, ground: Ground): void {
    const { runs } = plan.motion!;
    let first = run;
    let last = run;
    while (first > 0 && plan.isSameLine(first - 1, run)) --first;
    while (last + 1 < runs.line.length && plan.isSameLine(last + 1, run)) ++last;
    const name = `${first} ${last}`;
    if (name === this.markedRun) return;
    this.markedRun = name;
    this.mark.fill([markOf(plan, { first, last }, ground)]);
  }

  // Some of the lines that a view lacks. True: now it has all.
  makeLines(projection: THREE.Matrix4, pixelsPerMm: number): boolean {
    return this.paint?.makeFor({ projection: projection.elements, pixelsPerMm }, performance.now() + PAINT_MS) ?? true;
  }

  // Before a frame. False: not all lines are as fine as they should be.
  prepare(projection: THREE.Matrix4, pixelsPerMm: number): boolean {
    for (const object of [...this.zeros.children, this.tool]) object.scale.setScalar(1 / pixelsPerMm);
    const painted = this.paint?.paintFor({ projection: projection.elements, pixelsPerMm }, performance.now() + PAINT_MS);
    if (painted) this.lines.fill(painted.parts);
    return painted?.isWhole ?? true;
  }

  get joinsRests(): boolean {
    return this.paint?.joinsRests ?? false;
  }

  get vertices(): number {
    let vertices = 0;
    this.scene.traverseVisible((object) => {
      const geometry = (object as THREE.Mesh).geometry as THREE.BufferGeometry | undefined;
      if (!geometry) return;
      const copies = geometry instanceof THREE.InstancedBufferGeometry ? geometry.instanceCount : 1;
      vertices += copies * (geometry.getAttribute("position")?.count ?? 0);
    });
    return vertices;
  }
}
