import { BufferAttribute, BufferGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Vector3 } from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';
import type { Motion } from '../motion';
import { orientationOf } from '../orientation';
import type { Replica } from '../protocol/replica';
import type { PhysicsShapes as Shapes, PhysicsSolid } from '../protocol/scene';

const kFixed = 0x00a36c;
const kMoving = 0xff2d95;

/** Wireframes of collision shapes, drawn over the view: static ones, and those that move with their models. */
export class PhysicsShapes {
  readonly group = new Group();
  private readonly materials = [kFixed, kMoving].map((color) => new LineBasicMaterial({ color, depthTest: false, transparent: true, opacity: 0.85 }));
  private readonly bodies = new Map<number, LineSegments>(); // by id

  constructor() {
    this.group.visible = false;
    this.group.renderOrder = 9;
  }

  get count(): number {
    return this.bodies.size;
  }

  show({ fixed, bodies }: Shapes): void {
    this.clear();
    if (fixed.length > 0) this.group.add(this.lines(fixed, 0));
    for (const { model, solids } of bodies) {
      const lines = this.lines(solids, 1);
      this.bodies.set(model, lines);
      this.group.add(lines);
    }
  }

  /** Moves the shapes with their models; shapes of removed models are hidden. */
  move(replica: Replica, motion: Motion): void {
    for (const [id, lines] of this.bodies) {
      const row = replica.rows.get(id);
      lines.visible = row !== undefined;
      if (row === undefined) continue;
      lines.position.set(motion.x[row], motion.y[row], motion.z[row]);
      lines.quaternion.copy(motion.tilted.get(row) ?? orientationOf({ a: motion.a[row], tiltX: 0, tiltY: 0 }));
    }
  }

  clear(): void {
    for (const lines of this.group.children) (lines as LineSegments).geometry.dispose();
    this.group.clear();
    this.bodies.clear();
  }

  private lines(solids: PhysicsSolid[], material: number): LineSegments {
    const points = solids.flatMap(edgesOf);
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    const lines = new LineSegments(geometry, this.materials[material]);
    lines.frustumCulled = false;
    lines.renderOrder = 9;
    return lines;
  }
}

/** Line segments: pairs of x, y, z. */
export function edgesOf(solid: PhysicsSolid): number[] {
  if ('corners' in solid) return edgesOfHull(solid.corners);
  const { loop, z } = solid;
  const points: number[] = [];
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    for (const height of z) points.push(loop[j], loop[j + 1], height, loop[i], loop[i + 1], height);
    points.push(loop[i], loop[i + 1], z[0], loop[i], loop[i + 1], z[1]);
  }
  return points;
}

function edgesOfHull(corners: number[]): number[] {
  const points = Array.from({ length: corners.length / 3 }, (_, k) => new Vector3().fromArray(corners, 3 * k));
  if (points.length < 4) return [];
  const hull = new ConvexGeometry(points);
  const edges = new EdgesGeometry(hull, 1);
  const all = [...edges.attributes.position.array];
  hull.dispose();
  edges.dispose();
  return all;
}
