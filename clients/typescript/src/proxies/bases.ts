/** Bases of proxies: what an interface does besides its values and messages. */

import { Device } from '../device.js';
import { imu } from '../generated/index.js';
import type { AnyMessage } from '../wire.js';

/** Queue limit; the oldest are dropped. */
const kMostKept = 1024;

/** Base of devices whose data messages are queued until the program takes them. */
export abstract class Keeping<Kept> extends Device {
  private kept: Kept[] = [];

  /** Reads for ever: each message. Throws RequestTimeout after `timeout` s without. */
  async *updates(timeout?: number): AsyncGenerator<Kept, never, void> {
    for (;;) {
      while (this.kept.length > 0) yield this.kept.shift()!;
      await this.nextData(timeout);
    }
  }

  override take(message: AnyMessage, value: unknown, timestamp: number): void | Promise<void> {
    if (this.kept.length === kMostKept) this.kept.shift();
    this.kept.push(this.meaning(value));
    return super.take(message, value, timestamp);
  }

  override forgetData(): void {
    this.kept = [];
    super.forgetData();
  }

  protected abstract meaning(value: unknown): Kept;

  /** Empties the queue; returns what was in it, in order. */
  protected takeKept(): Kept[] {
    const taken = this.kept;
    this.kept = [];
    return taken;
  }
}

/** Base of devices that move. Closing one while it moves stops it first. */
export abstract class Mobile extends Device {
  protected moving = false;

  abstract drive(vx: number): Promise<void>;

  stop(): Promise<void> {
    return this.drive(0);
  }

  override async close(): Promise<void> {
    // Both are sent at once, so that no other task gets a command in between.
    const stopped = this.reachable && this.moving ? this.stop() : undefined;
    await Promise.all([stopped, super.close()]);
  }
}

/** Base of devices that send one of several data messages. */
export abstract class Selecting extends Device {
  /**
   * One of imu.DATA_STATE (`pose`), DATA_CALIB (`inertia`), DATA_QUAT (`inertia` and `quaternion`), DATA_EULER (`inertia`
   * and `attitude`) and DATA_FULLSTATE (`pose` and `velocity`), for all subscribers of the device.
   */
  async send(datatype: AnyMessage): Promise<void> {
    await this.request(imu.REQ_SET_DATATYPE, { value: datatype.subtype });
  }

  protected override lackOf(message: AnyMessage): string {
    const why = super.lackOf(message);
    const constant = message.name.replace('imu.', '').replaceAll('.', '_').toUpperCase();
    return this.hasData ? `${why}; send(imu.${constant}) selects it` : why;
  }
}
