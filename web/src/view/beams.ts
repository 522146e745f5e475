import type { Sensor } from '../protocol/scene';

/** Bearing of beam k of a sensor: the first is rightmost; a single beam points ahead. */
export function bearingOf(sensor: Sensor, k: number): number {
  return sensor.samples < 2 ? 0 : -sensor.fov / 2 + (k * sensor.fov) / (sensor.samples - 1);
}
