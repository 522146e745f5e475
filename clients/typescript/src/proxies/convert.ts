/** Values of the wire to those of the proxies, and back. */

import { WireError } from '../errors.js';
import type { common } from '../generated/index.js';
import type { Geometry, Pose, Pose3d } from '../values.js';

/** The contents of an answer. Throws WireError if it has none. */
export async function contents<T>(answer: Promise<T | undefined>): Promise<T> {
  const value = await answer;
  if (value === undefined) throw new WireError('an answer came without its contents');
  return value;
}

export function poseOf({ px, py, pa }: common.Pose2d): Pose {
  return { x: px, y: py, a: pa };
}

export function wirePose({ x, y, a }: Pose): common.Pose2d {
  return { px: x, py: y, pa: a };
}

export function pose3dOf(pose: common.Pose3d): Pose3d {
  return { x: pose.px, y: pose.py, z: pose.pz, roll: pose.proll, pitch: pose.ppitch, yaw: pose.pyaw };
}

export function wirePose3d({ x, y, z, roll, pitch, yaw }: Pose3d): common.Pose3d {
  return { px: x, py: y, pz: z, proll: roll, ppitch: pitch, pyaw: yaw };
}

export function geometryOf(geom: { pose: common.Pose3d; size: common.Bbox3d }): Geometry {
  return { pose: pose3dOf(geom.pose), size: { x: geom.size.sl, y: geom.size.sw, z: geom.size.sh } };
}

/** `count` angles from low to high. */
export function spread(low: number, high: number, count: number): Float64Array {
  const step = count > 1 ? (high - low) / (count - 1) : 0;
  return Float64Array.from({ length: count }, (_, i) => low + i * step);
}
