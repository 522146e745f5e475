import { Device } from '../device.js';
import { pointcloud3d } from '../generated/index.js';
import type { Point } from '../values.js';

/** A 3D point cloud, such as that of a lidar with several rings. */
export class PointCloud3d extends Device {
  get points(): Point[] {
    return this.stamped(pointcloud3d.DATA_STATE).value.points.map(({ point: { px, py, pz }, color }) => ({
      x: px,
      y: py,
      z: pz,
      color: [color.red, color.green, color.blue, color.alpha],
    }));
  }

  /** Reads for ever: one list per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Point[], never, void> {
    return this.follow(() => this.points, timeout);
  }
}
