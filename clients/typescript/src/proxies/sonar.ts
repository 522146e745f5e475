import { Device } from '../device.js';
import { sonar } from '../generated/index.js';
import type { Pose3d } from '../values.js';
import { contents, pose3dOf } from './convert.js';

/** A ring of sonars. */
export class Sonar extends Device {
  /** In m, one per sonar, in the order of poses(). */
  get ranges(): Float32Array {
    return this.stamped(sonar.DATA_RANGES).value.ranges;
  }

  /** Poses of the sonars on the robot. */
  async poses(): Promise<Pose3d[]> {
    return (await contents(this.request(sonar.REQ_GET_GEOM))).poses.map(pose3dOf);
  }

  async setPower(on: boolean): Promise<void> {
    await this.request(sonar.REQ_POWER, { state: Number(on) });
  }
}
