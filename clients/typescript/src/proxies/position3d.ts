import { Device } from '../device.js';
import { common, position3d } from '../generated/index.js';
import type { Geometry, Pose3d, State3d } from '../values.js';
import { contents, geometryOf, pose3dOf, wirePose3d } from './convert.js';

/** A mobile base in space. Closing it while it moves stops it first. */
export class Position3d extends Device {
  private moving = false;

  get state(): State3d {
    const { value, time } = this.stamped(position3d.DATA_STATE);
    return { pose: pose3dOf(value.pos), velocity: pose3dOf(value.vel), stalled: value.stall !== 0, time };
  }

  /** Reads for ever: one State3d per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<State3d, never, void> {
    return this.follow(() => this.state, timeout);
  }

  /** Forward, to the left and upwards in m/s, turning in rad/s, until the next command. */
  async drive(vx: number, va = 0, vy = 0, vz = 0): Promise<void> {
    this.insistOnFinite({ vx, va, vy, vz });
    this.moving = vx !== 0 || vy !== 0 || vz !== 0 || va !== 0;
    const vel = common.Pose3d.make({ px: vx, py: vy, pz: vz, pyaw: va });
    await this.command(position3d.CMD_SET_VEL, { vel, state: 1 });
  }

  stop(): Promise<void> {
    return this.drive(0);
  }

  /** Moves to a pose in the frame of State3d.pose, by the driver's position control. */
  async goTo(pose: Pose3d): Promise<void> {
    this.insistOnFinite(pose);
    this.moving = true;
    await this.command(position3d.CMD_SET_POS, { pos: wirePose3d(pose), state: 1 });
  }

  async setMotorPower(on: boolean): Promise<void> {
    await this.request(position3d.REQ_MOTOR_POWER, { state: Number(on) });
  }

  /** Sets the pose estimate, State3d.pose. */
  async setOdometry(pose: Pose3d): Promise<void> {
    this.insistOnFinite(pose);
    await this.request(position3d.REQ_SET_ODOM, { pos: wirePose3d(pose) });
  }

  async resetOdometry(): Promise<void> {
    await this.request(position3d.REQ_RESET_ODOM);
  }

  async geometry(): Promise<Geometry> {
    return geometryOf(await contents(this.request(position3d.REQ_GET_GEOM)));
  }

  override async close(): Promise<void> {
    // Both are sent at once, so that no other task gets a command in between.
    const stopped = this.reachable && this.moving ? this.stop() : undefined;
    await Promise.all([stopped, super.close()]);
  }
}
