import { Device } from '../device.js';
import { position2d } from '../generated/index.js';
import type { Geometry, Pose, State, Velocity } from '../values.js';
import { contents, geometryOf, poseOf, wirePose } from './convert.js';

/** A mobile base. Closing it while it moves stops it first. */
export class Position2d extends Device {
  private moving = false;

  get state(): State {
    const { value, time } = this.stamped(position2d.DATA_STATE);
    return { pose: poseOf(value.pos), velocity: poseOf(value.vel), stalled: value.stall !== 0, time };
  }

  /** Reads for ever: one State per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<State, never, void> {
    return this.follow(() => this.state, timeout);
  }

  /** The robot's pose estimate: State.pose. */
  get pose(): Pose {
    return this.state.pose;
  }

  get velocity(): Velocity {
    return this.state.velocity;
  }

  get stalled(): boolean {
    return this.state.stalled;
  }

  /** Forward and to the left in m/s, turning in rad/s, until the next command. */
  async drive(vx: number, va = 0, vy = 0): Promise<void> {
    this.insistOnFinite({ vx, va, vy });
    this.moving = vx !== 0 || vy !== 0 || va !== 0;
    await this.command(position2d.CMD_VEL, { vel: { px: vx, py: vy, pa: va }, state: 1 });
  }

  stop(): Promise<void> {
    return this.drive(0);
  }

  /** For a base with car steering: speed in m/s, and steering angle in rad, positive to the left. */
  async driveCar(speed: number, steering: number): Promise<void> {
    this.insistOnFinite({ speed, steering });
    this.moving = speed !== 0;
    await this.command(position2d.CMD_CAR, { velocity: speed, angle: steering });
  }

  /** Drives to a pose in the frame of State.pose, by the driver's position control; speed 0: the driver's choice. */
  async goTo({ x, y, a }: Pose, speed = 0): Promise<void> {
    this.insistOnFinite({ x, y, a, speed });
    this.moving = true;
    await this.command(position2d.CMD_POS, { pos: wirePose({ x, y, a }), vel: { px: speed, py: 0, pa: 0 }, state: 1 });
  }

  async setMotorPower(on: boolean): Promise<void> {
    await this.request(position2d.REQ_MOTOR_POWER, { state: Number(on) });
  }

  /** Sets the pose estimate; the robot does not move. */
  async setOdometry({ x, y, a }: Pose): Promise<void> {
    this.insistOnFinite({ x, y, a });
    await this.request(position2d.REQ_SET_ODOM, { pose: wirePose({ x, y, a }) });
  }

  async resetOdometry(): Promise<void> {
    await this.request(position2d.REQ_RESET_ODOM);
  }

  async geometry(): Promise<Geometry> {
    return geometryOf(await contents(this.request(position2d.REQ_GET_GEOM)));
  }

  override async close(): Promise<void> {
    // Both are sent at once, so that no other task gets a command in between.
    const stopped = this.reachable && this.moving ? this.stop() : undefined;
    await Promise.all([stopped, super.close()]);
  }
}
