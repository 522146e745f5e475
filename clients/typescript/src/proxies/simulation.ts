import { Device } from '../device.js';
import { RequestRefused, RunEnded } from '../errors.js';
import { simulation } from '../generated/index.js';
import type { RequestOptions } from '../session.js';
import { cString, joined, text } from '../text.js';
import type { Pose, Pose3d } from '../values.js';
import type { MessageType } from '../wire.js';
import { contents, pose3dOf, poseOf, wirePose, wirePose3d } from './convert.js';

const kEnded = 'the run has ended'; // the server's reason to refuse a step then

/** The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level model. */
export class Simulation extends Device {
  /** Throws RequestRefused if there is no model of that name. */
  async pose(name: string): Promise<Pose> {
    return poseOf((await contents(this.ofModel(name, simulation.REQ_GET_POSE2D, {}))).pose);
  }

  async setPose(name: string, { x, y, a }: Pose): Promise<void> {
    this.insistOnFinite({ x, y, a });
    await this.ofModel(name, simulation.REQ_SET_POSE2D, { pose: wirePose({ x, y, a }) });
  }

  /** As pose(). */
  async pose3d(name: string): Promise<Pose3d> {
    return pose3dOf((await contents(this.ofModel(name, simulation.REQ_GET_POSE3D, {}))).pose);
  }

  async setPose3d(name: string, pose: Pose3d): Promise<void> {
    this.insistOnFinite(pose);
    await this.ofModel(name, simulation.REQ_SET_POSE3D, { pose: wirePose3d(pose) });
  }

  /** Pauses or resumes the clock. */
  pause(): Promise<void> {
    return this.command(simulation.CMD_PAUSE);
  }

  /** Saves the current world to the file of `playhouse run --save-world`; without that option it has no effect. */
  save(): Promise<void> {
    return this.command(simulation.CMD_SAVE);
  }

  /**
   * Moves everything back to its pose in the world file, while time continues. With a seed the run restarts with that
   * seed: at tick 0, with the initial models and their ids, and devices have no data until new ones arrive. That
   * requires lock-step, else the server refuses: RequestRefused.
   */
  async reset(seed?: number | bigint): Promise<void> {
    if (seed === undefined) {
      await this.command(simulation.CMD_RESET);
      return;
    }
    this.insistOnWhole('seed', seed, 0, 2n ** 64n - 1n);
    const value = new Uint8Array(8);
    new DataView(value.buffer).setBigUint64(0, BigInt(seed), true);
    await this.ofWorld('reset', value, { answered: () => this.client.forgetRun() });
  }

  /**
   * Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps. Open
   * devices first. Throws RequestRefused with the reason.
   */
  async join(name: string): Promise<void> {
    await this.ofWorld('join', cString(name));
  }

  /**
   * Runs this number of ticks and waits until they are done, in lock-step until all members have requested them: at most
   * `timeout` s, without it for ever. In push mode all data of the ticks have then been delivered to the devices; in pull
   * mode they are queued for read(). Without lock-step a running world refuses: pause() first.
   */
  async step(ticks = 1, timeout = Infinity): Promise<void> {
    this.insistOnWhole('ticks', ticks, 1, 2 ** 20);
    const value = new Uint8Array(4);
    new DataView(value.buffer).setUint32(0, ticks, true);
    await this.ofWorld('step', value, { timeout });
    await this.client.deliverPushed();
  }

  /** Spawns a robot like the model `like` at a pose in the world; returns its name. */
  async spawn(like: string, { x, y, a }: Pose, name = ''): Promise<string> {
    this.insistOnFinite({ x, y, a });
    const pose = new Uint8Array(24);
    [x, y, a].forEach((number, i) => new DataView(pose.buffer).setFloat64(8 * i, number, true));
    const value = joined([pose, name ? cString(name) : new Uint8Array()]);
    return text((await this.ofWorld('spawn', value, {}, like)).value);
  }

  /** Removes a top-level model from the world, with its descendants. */
  async remove(name: string): Promise<void> {
    await this.ofWorld('remove', new Uint8Array(), {}, name);
  }

  private async ofWorld(
    prop: string, value: Uint8Array, { timeout, answered }: RequestOptions = {}, name = '',
  ): Promise<simulation.PropertyReq> {
    const request = simulation.PropertyReq.make({ name: cString(name), prop: cString(prop), value });
    try {
      return (await this.request(simulation.REQ_SET_PROPERTY, request, timeout, answered)) ?? request;
    } catch (error) {
      if (!(error instanceof RequestRefused)) throw error;
      const told = error.body.length > 0 ? text(simulation.PropertyReq.decode(error.body).value) : '';
      if (told === kEnded) throw new RunEnded(`${this.session.peer}: ${told}`);
      const why = error.body.length > 0 ? told : 'the server does not do that';
      throw new RequestRefused(`${this.session.peer}: ${prop} was refused: ${why}`);
    }
  }

  private ofModel<T extends { name: Uint8Array }>(
    name: string, message: MessageType<T>, request: Partial<Omit<T, 'name'>>,
  ): Promise<T | undefined> {
    const line = `${this.session.peer}: ${message.name} of model "${name}" was refused`;
    return this.orRefused(line, this.request(message, { ...request, name: cString(name) } as Partial<T>));
  }
}
