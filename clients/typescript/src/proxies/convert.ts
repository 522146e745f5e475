/** Values of the wire to those of the proxies, and back. */

import { WireError } from '../errors.js';
import { wifi, type common } from '../generated/index.js';
import type { Attitude, Charging, Covariance, Pose, Pose3d, Rgb, Rgba, Size, Vector } from '../values.js';

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

export function sizeOf({ sl, sw, sh }: common.Bbox3d): Size {
  return { x: sl, y: sw, z: sh };
}

export function vectorOf({ px, py, pz }: common.Point3d): Vector {
  return [px, py, pz];
}

export function attitudeOf({ proll, ppitch, pyaw }: common.Orientation3d): Attitude {
  return { roll: proll, pitch: ppitch, yaw: pyaw };
}

export function covarianceOf([xx = 0, yy = 0, aa = 0, xy = 0, ya = 0, xa = 0]: Iterable<number>): Covariance {
  return { xx, yy, aa, xy, ya, xa };
}

export function rgbOf({ red, green, blue }: common.Color): Rgb {
  return [red, green, blue];
}

export function rgbaOf({ red, green, blue, alpha }: common.Color): Rgba {
  return [red, green, blue, alpha];
}

export function wireColor([red, green, blue]: Rgb): common.Color {
  return { alpha: 255, red, green, blue };
}

/** Of 0xRRGGBB. */
export function packedRgb(color: number): Rgb {
  return [(color >> 16) & 255, (color >> 8) & 255, color & 255];
}

export function charging(state: number): Charging {
  return Math.max(-1, Math.min(state, 1)) as Charging;
}

/** Levels in dBm are signed, all others are not. */
export function level(value: number, unit: number): number {
  return unit === wifi.QUAL_DBM ? value : value >>> 0;
}

/** Of a range each: those of the elements if there is one per range, else spread from `low` to `high`. */
export function directions(
  low: number, high: number, ranges: ArrayLike<number>, elements: common.Pose3d[] = [],
): Float64Array {
  const count = ranges.length;
  if (elements.length === count && count > 1) return Float64Array.from(elements, ({ pyaw }) => pyaw);
  const step = count > 1 ? (high - low) / (count - 1) : 0;
  return Float64Array.from({ length: count }, (_, i) => low + i * step);
}
