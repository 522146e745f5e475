import type { Vector3 } from 'three';
import type { Motion } from '../motion';
import type { Scene, Solid } from '../protocol/scene';
import { heightOf } from './shapes';

const kHeights = [1, 0.75, 0.5, 0.25, 0]; // height fractions sampled by oblique rays

/** The model with the highest intersection of its body and the ray; null if there is none. */
export function thingAt(scene: Scene, motion: Motion, ray: (z: number) => Vector3 | null): number | null {
  let found: number | null = null;
  let highest = -Infinity;
  scene.models.forEach((model, row) => {
    if (model.shape === undefined) return;
    const solids = scene.shapes[model.shape];
    const [ox, oy, , oa] = model.origin ?? [0, 0, 0, 0];
    for (const part of kHeights) {
      const z = motion.z[row] + part * heightOf(solids);
      const p = z > highest ? ray(z) : null;
      if (!p) continue;
      const [x, y] = turned(p.x - motion.x[row], p.y - motion.y[row], -motion.a[row]);
      const [bx, by] = turned(x - ox, y - oy, -oa);
      if (!solids.some((solid) => holds(solid, bx, by))) continue;
      found = row;
      highest = z;
    }
  });
  return found;
}

function turned(x: number, y: number, a: number): [number, number] {
  return [Math.cos(a) * x - Math.sin(a) * y, Math.sin(a) * x + Math.cos(a) * y];
}

/** Point in solid by the even-odd rule. */
export function holds({ loops }: Solid, x: number, y: number): boolean {
  let inside = false;
  for (const loop of loops) {
    for (let k = 0, before = loop.length - 2; k < loop.length; before = k, k += 2) {
      const [ax, ay, bx, by] = [loop[before], loop[before + 1], loop[k], loop[k + 1]];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
    }
  }
  return inside;
}
