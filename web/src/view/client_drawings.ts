import {
  BufferGeometry, Color, DoubleSide, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Points,
  PointsMaterial, type Material, type Object3D,
} from 'three';
import type { Drawing, Stage } from '../kinds/kind_page';
import type { DrawnRun } from '../protocol/replica';
import { bodyMatrix } from './frames';

const kPoint = 5; // px
const kOrder = 2; // above marks of the floor, below names

/** Triangles under lines under points, so that outlines and marks in one plane stay visible. */
const kForms: { corners: DrawnRun['corners']; make: (geometry: BufferGeometry, material: Material) => Object3D }[] = [
  { corners: 3, make: (geometry, material) => new Mesh(geometry, material) },
  { corners: 2, make: (geometry, material) => new LineSegments(geometry, material) },
  { corners: 1, make: (geometry, material) => new Points(geometry, material) },
];

/** Positions [m] and colors of the corners of those runs. */
export function cornersOf(runs: DrawnRun[]): { positions: number[]; colors: number[] } {
  const [positions, colors]: number[][] = [[], []];
  const ink = new Color();
  for (const { color, points } of runs) {
    ink.setHex(color >>> 8);
    for (let k = 0; k < points.length; k += 3) {
      positions.push(points[k], points[k + 1], points[k + 2]);
      colors.push(ink.r, ink.g, ink.b, (color & 0xff) / 255);
    }
  }
  return { positions, colors };
}

/** The drawing of one model, as the replica has it. */
interface Held {
  runs: DrawnRun[];
  group: Group;
}

/** What clients have drawn, in the frames of their models. */
export class ClientDrawings implements Drawing {
  readonly layer = 'drawings';
  readonly object = new Group();
  private readonly held = new Map<number, Held>();
  private readonly materials = [true, false].map((flat) => materialsOf(flat));

  constructor(private readonly stage: Stage) {}

  draw(): void {
    const { replica, motion } = this.stage;
    for (const [row, { group }] of this.held) if (!replica.drawings.has(row)) this.drop(row, group);
    for (const [row, runs] of replica.drawings) {
      const group = this.groupOf(row, runs);
      bodyMatrix(motion, row, [0, 0, 0, 0], group.matrix);
      group.matrixWorldNeedsUpdate = true;
    }
  }

  dispose(): void {
    for (const [row, { group }] of this.held) this.drop(row, group);
    for (const material of this.materials.flat()) material.dispose();
  }

  private groupOf(row: number, runs: DrawnRun[]): Group {
    const held = this.held.get(row);
    if (held?.runs === runs) return held.group;
    if (held) this.drop(row, held.group);
    const group = new Group();
    group.matrixAutoUpdate = false;
    group.add(...this.objectsOf(runs));
    this.object.add(group);
    this.held.set(row, { runs, group });
    return group;
  }

  private objectsOf(runs: DrawnRun[]): Object3D[] {
    const objects: Object3D[] = [];
    [true, false].forEach((flat, kind) =>
      kForms.forEach(({ corners, make }, form) => {
        const { positions, colors } = cornersOf(runs.filter((run) => run.corners === corners && run.flat === flat));
        if (positions.length === 0) return;
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
        geometry.setAttribute('color', new Float32BufferAttribute(colors, 4));
        const object = make(geometry, this.materials[kind][form]);
        object.renderOrder = kOrder + form / 10;
        objects.push(object);
      }),
    );
    return objects;
  }

  private drop(row: number, group: Group): void {
    this.object.remove(group);
    for (const object of group.children) (object as Mesh).geometry.dispose();
    this.held.delete(row);
  }
}

/** In the order of kForms. What is flat covers what was drawn before; other shapes cover what is behind them. */
function materialsOf(flat: boolean): Material[] {
  const look = { vertexColors: true, transparent: true, depthWrite: !flat };
  return [
    new MeshBasicMaterial({ ...look, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
    new LineBasicMaterial(look),
    new PointsMaterial({ ...look, size: kPoint, sizeAttenuation: false }),
  ];
}
