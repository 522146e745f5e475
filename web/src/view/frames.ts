import type { Motion } from '../motion';
import type { Pose } from '../protocol/scene';

/** A frame in the world: metres and radians. */
export interface Frame {
  x: number;
  y: number;
  z: number;
  a: number;
}

/** Where a part of a model is at this moment: the pose of the model, then those of frames inside it, the outermost first. */
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
