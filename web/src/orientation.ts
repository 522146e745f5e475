import { Quaternion, Vector3 } from 'three';

/** Rotation about a horizontal axis, applied before the heading: axis times angle [rad]. As in playhouse/geom/orientation.h. */
export interface Standing {
  a: number; // heading
  tiltX: number;
  tiltY: number;
}

const kUp = new Vector3(0, 0, 1);

export function orientationOf({ a, tiltX, tiltY }: Standing): Quaternion {
  const heading = new Quaternion().setFromAxisAngle(kUp, a);
  const angle = Math.hypot(tiltX, tiltY);
  if (angle === 0) return heading;
  return heading.multiply(new Quaternion().setFromAxisAngle(new Vector3(tiltX / angle, tiltY / angle, 0), angle));
}

export function standingOf({ w, x, y, z }: Quaternion): Standing {
  const n = Math.hypot(w, z);
  const [c, s] = n > 0 ? [w / n, z / n] : [1, 0];
  const [swingX, swingY] = [c * x + s * y, c * y - s * x];
  const sine = Math.hypot(swingX, swingY);
  const scale = sine > 0 ? (2 * Math.atan2(sine, n)) / sine : 0;
  return { a: 2 * Math.atan2(s, c), tiltX: scale * swingX, tiltY: scale * swingY };
}
