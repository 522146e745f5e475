import { Vector3, type Matrix4 } from 'three';
import type { Motion } from '../motion';
import { orientationOf } from '../orientation';
import type { Pose } from '../protocol/scene';

/** A frame in the world: metres and radians. */
export interface Frame {
  x: number;
  y: number;
  z: number;
  a: number;
}

/** Current world frame of a part: the model's pose, then nested frames, outermost first. */
export function frameOf(motion: Motion, row: number, ...inside: (Pose | undefined)[]): Frame {
  let { x, y, z, a } = { x: motion.x[row], y: motion.y[row], z: motion.z[row], a: motion.a[row] };
  for (const pose of inside) {
    if (!pose) continue;
    const c = Math.cos(a);
    const s = Math.sin(a);
    [x, y] = [x + c * pose[0] - s * pose[1], y + s * pose[0] + c * pose[1]];
    z += pose[2];
    a += pose[3];
  }
  return { x, y, z, a };
}

/** Current transform from a model's body frame to the world; written to `to`. */
export function bodyMatrix(motion: Motion, row: number, [x, y, z, a]: Pose, to: Matrix4): Matrix4 {
  const tilted = motion.tilted.get(row);
  if (tilted) {
    const place = new Vector3(x, y, z).applyQuaternion(tilted).add(new Vector3(motion.x[row], motion.y[row], motion.z[row]));
    return to.makeRotationFromQuaternion(tilted.clone().multiply(orientationOf({ a, tiltX: 0, tiltY: 0 }))).setPosition(place);
  }
  const [c, s] = [Math.cos(motion.a[row]), Math.sin(motion.a[row])];
  const [cb, sb] = [Math.cos(motion.a[row] + a), Math.sin(motion.a[row] + a)];
  return to.set(
    cb, -sb, 0, motion.x[row] + c * x - s * y,
    sb, cb, 0, motion.y[row] + s * x + c * y,
    0, 0, 1, motion.z[row] + z,
    0, 0, 0, 1,
  );
}
