import { Group, Vector3, type LineSegments, type Mesh, type Points } from 'three';
import { expect, test } from 'vitest';
import type { Motion } from '../motion';
import type { DrawnRun, Replica } from '../protocol/replica';
import type { Stage } from '../kinds/kind_page';
import { ClientDrawings, cornersOf } from './client_drawings';

const kLine: DrawnRun = { corners: 2, flat: true, color: 0xff0000ff, points: Float32Array.of(0, 0, 0, 1, 0, 0) };
const kPoint: DrawnRun = { corners: 1, flat: false, color: 0x00ff0080, points: Float32Array.of(1, 2, 3) };

/** One model at (5, 0, 0.5), turned to the left. */
function stageOf(drawings: Map<number, DrawnRun[]>) {
  const motion = { x: [5], y: [0], z: [0.5], a: [Math.PI / 2], tilted: new Map() } as unknown as Motion;
  return { replica: { drawings } as Replica, motion } as Stage;
}

test('corners have the color of their run', () => {
  const { positions, colors } = cornersOf([kLine, kPoint]);
  expect(positions).toEqual([0, 0, 0, 1, 0, 0, 1, 2, 3]);
  expect(colors).toEqual([1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 128 / 255]);
});

test('a drawing moves with its model, is replaced and goes', () => {
  const drawings = new Map([[0, [kLine, kPoint]]]);
  const stage = stageOf(drawings);
  const drawn = new ClientDrawings(stage);
  drawn.draw();
  const group = drawn.object.children[0] as Group;
  expect(group.children.map((object) => (object as LineSegments | Points).type)).toEqual(['LineSegments', 'Points']);
  const end = new Vector3(1, 0, 0).applyMatrix4(group.matrix);
  expect([end.x, end.y, end.z].map((value) => Math.round(value * 1e6) / 1e6)).toEqual([5, 1, 0.5]);
  (stage.motion.x as unknown as number[])[0] = 6;
  drawn.draw();
  expect(drawn.object.children).toEqual([group]);
  expect(new Vector3().applyMatrix4(group.matrix).x).toBe(6);
  drawings.set(0, [{ ...kLine, corners: 3, points: new Float32Array(9) }]);
  drawn.draw();
  expect((drawn.object.children[0].children[0] as Mesh).type).toBe('Mesh');
  drawings.delete(0);
  drawn.draw();
  expect(drawn.object.children).toEqual([]);
});
