import { BoxGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshLambertMaterial, Vector3, type LineSegments } from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Motion } from '../motion';
import { Replica } from '../protocol/replica';
import { sceneOf } from '../protocol/scene';
import type { Theme } from './theme';

let come: (file: { scene: Group }) => void;
let fail: (why: Error) => void;
vi.mock('three/addons/loaders/GLTFLoader.js', () => ({
  GLTFLoader: class {
    loadAsync() {
      return new Promise((resolve, reject) => ([come, fail] = [resolve, reject]));
    }
  },
}));
const { Bodies } = await import('./bodies');

let files = 0; // so that each test loads its own

/** A robot with a hat, and a house with a mesh. */
function world() {
  const box = [{ z: [0, 1] as [number, number], loops: [[-1, -1, 1, -1, 1, 1, -1, 1]] }];
  const start = (x: number): [number, number, number, number, number, number, number] => [x, 0, 0, 0, 0, 0xff0000ff, 0];
  const scene = sceneOf({
    protocol: 4, build: '', name: 'w', interval: 0.1, window: { center: [0, 0], scale: 0, pitch: 0, yaw: 0, sensors: true, follow: '' },
    light: null, shapes: [box, [...box]], addable: [],
    prototypes: [
      { type: 'robot', kind: 'position', size: [1, 1, 1], shape: 0 },
      { type: 'hat', kind: 'plain', size: [1, 1, 1], shape: 1 },
      { type: 'house', kind: 'plain', size: [1, 1, 1], shape: 0, mesh: `meshes/${++files}.glb` },
    ],
    models: [
      { id: 1, prototype: 0, name: 'r0', start: start(5000) },
      { id: 2, prototype: 1, parent: 1, name: 'r0.hat', start: start(0) },
      { id: 3, prototype: 2, name: 'house', start: start(9000) },
    ],
  } as Parameters<typeof sceneOf>[0]);
  const replica = new Replica(scene);
  return new Bodies(scene, replica, new Motion(scene, replica), { edge: 0 } as Theme, () => {});
}

/** Sizes at which the solids are drawn that are drawn at all. */
function sizes(bodies: InstanceType<typeof Bodies>): number[] {
  const solids = bodies.group.children.filter((child) => child instanceof InstancedMesh && child.visible) as InstancedMesh[];
  const matrix = new Matrix4();
  return solids.map((solid) => {
    solid.getMatrixAt(0, matrix);
    return new Vector3().setFromMatrixScale(matrix).x;
  });
}

const outlines = (bodies: InstanceType<typeof Bodies>) =>
  (bodies.group.children as LineSegments[]).filter((child) => child.type === 'LineSegments' && child.visible).length;

describe('Bodies', () => {
  let bodies: InstanceType<typeof Bodies>;
  beforeEach(() => (bodies = world()));

  it('hides a robot with all its parts, and shows it again', () => {
    const before = sizes(bodies); // body, hat, heading mark
    expect(before).toEqual([1, 1, 1]);
    bodies.hide(0);
    expect(sizes(bodies)).toEqual([0, 0, 0]);
    bodies.hide(null);
    expect(sizes(bodies)).toEqual(before);
  });

  it('draws outlines alone of a body whose mesh is not there yet, at any scale', () => {
    bodies.adapt(1);
    expect([sizes(bodies).length, outlines(bodies), bodies.files]).toEqual([3, 1, 0]);
  });

  it('draws the mesh when it is there', async () => {
    const scene = new Group();
    scene.add(new Mesh(new BoxGeometry(), new MeshLambertMaterial()));
    come({ scene });
    await bodies.filesThere();
    bodies.adapt(1);
    expect([sizes(bodies).length, outlines(bodies), bodies.files]).toEqual([3, 0, 1]);
  });

  it('draws the body if its mesh does not come', async () => {
    vi.spyOn(console, 'warn').mockImplementation(() => {});
    fail(new Error('404'));
    await bodies.filesThere();
    expect([sizes(bodies).length, bodies.files]).toEqual([4, 0]);
  });
});
