import { Device } from '../device.js';
import { bumper } from '../generated/index.js';
import type { Face } from '../values.js';
import { contents, pose3dOf } from './convert.js';

/** Contact switches. */
export class Bumper extends Device {
  /** One per switch, in the order of faces(). */
  get pressed(): boolean[] {
    return Array.from(this.stamped(bumper.DATA_STATE).value.bumpers, (state) => state !== 0);
  }

  /** Reads for ever: one list per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<boolean[], never, void> {
    return this.follow(() => this.pressed, timeout);
  }

  /** Faces of the switches on the robot. */
  async faces(): Promise<Face[]> {
    const { bumperDef } = await contents(this.request(bumper.REQ_GET_GEOM));
    return bumperDef.map(({ pose, length, radius }) => ({ pose: pose3dOf(pose), length, radius }));
  }
}
