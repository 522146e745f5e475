import { Device } from '../device.js';
import { imu } from '../generated/index.js';
import type { Attitude, Inertia, Pose3d } from '../values.js';
import type { AnyMessage } from '../wire.js';
import { pose3dOf } from './convert.js';

/** An inertial unit. send() selects the data message; initially it is that of `pose`. */
export class Imu extends Device {
  /**
   * One of imu.DATA_STATE (`pose`), DATA_CALIB (`inertia`), DATA_QUAT (`inertia` and `quaternion`), DATA_EULER (`inertia`
   * and `attitude`) and DATA_FULLSTATE (`pose` and `velocity`), for all subscribers of the device.
   */
  async send(datatype: AnyMessage): Promise<void> {
    await this.request(imu.REQ_SET_DATATYPE, { value: datatype.subtype });
  }

  /** Estimated pose. */
  get pose(): Pose3d {
    return pose3dOf(this.newestOf<imu.DataState | imu.DataFullstate>(imu.DATA_STATE, imu.DATA_FULLSTATE).pose);
  }

  /** Estimated velocity, along and about its own axes. */
  get velocity(): Pose3d {
    return pose3dOf(this.stamped(imu.DATA_FULLSTATE).value.vel);
  }

  get inertia(): Inertia {
    type Data = imu.DataCalib | imu.DataQuat | imu.DataEuler;
    const data = this.newestOf<Data>(imu.DATA_CALIB, imu.DATA_QUAT, imu.DATA_EULER);
    const one = 'calibData' in data ? data.calibData : data;
    return {
      acceleration: [one.accelX, one.accelY, one.accelZ],
      turnRate: [one.gyroX, one.gyroY, one.gyroZ],
      field: [one.magnX, one.magnY, one.magnZ],
    };
  }

  get attitude(): Attitude {
    const { proll, ppitch, pyaw } = this.stamped(imu.DATA_EULER).value.orientation;
    return { roll: proll, pitch: ppitch, yaw: pyaw };
  }

  /** Orientation, the real part first. */
  get quaternion(): [number, number, number, number] {
    const { q0, q1, q2, q3 } = this.stamped(imu.DATA_QUAT).value;
    return [q0, q1, q2, q3];
  }

  /** Makes the current heading, or the whole current orientation, the reference. */
  async resetOrientation(allAxes = false): Promise<void> {
    await this.request(imu.REQ_RESET_ORIENTATION, { value: Number(allAxes) });
  }

  /** Sets the current orientation, in rad. */
  async resetAttitude({ roll, pitch, yaw }: Attitude): Promise<void> {
    this.insistOnFinite({ roll, pitch, yaw });
    const orientation = { px: 0, py: 0, pz: 0, proll: roll, ppitch: pitch, pyaw: yaw };
    await this.request(imu.REQ_RESET_EULER, { orientation });
  }

  protected override lackOf(message: AnyMessage): string {
    const why = super.lackOf(message);
    const constant = message.name.replace('imu.', '').replaceAll('.', '_').toUpperCase();
    return this.hasData ? `${why}; send(imu.${constant}) selects it` : why;
  }

  /** The newest value of several kinds of data. Throws NoData if there is none. */
  private newestOf<T>(...kinds: AnyMessage[]): T {
    const known = kinds.filter((kind) => this.latest(kind) !== undefined);
    const values = (known.length > 0 ? known : kinds.slice(0, 1)).map((kind) => this.stamped<T>(kind));
    return values.reduce((a, b) => (b.time > a.time ? b : a)).value;
  }
}
