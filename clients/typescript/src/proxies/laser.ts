import { Device } from '../device.js';
import { laser } from '../generated/index.js';
import { Scan, type Geometry } from '../values.js';
import { contents, geometryOf, spread } from './convert.js';

/** A laser scanner; its data include the directions of the beams. */
export class Laser extends Device {
  scan(): Scan {
    const { value: { minAngle, maxAngle, maxRange, ranges }, time } = this.stamped(laser.DATA_SCAN);
    return new Scan(ranges, spread(minAngle, maxAngle, ranges.length), maxRange, time);
  }

  /** Reads for ever: one Scan per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Scan, never, void> {
    return this.follow(() => this.scan(), timeout);
  }

  /** In m, from the first beam's angle to the last one's. */
  get ranges(): Float32Array {
    return this.stamped(laser.DATA_SCAN).value.ranges;
  }

  /** One per range, in the device's unit; empty if it measures none. */
  get intensities(): Uint8Array {
    return this.stamped(laser.DATA_SCAN).value.intensity;
  }

  config(): Promise<laser.Config> {
    return contents(this.request(laser.REQ_GET_CONFIG));
  }

  async setConfig(config: laser.Config): Promise<void> {
    await this.request(laser.REQ_SET_CONFIG, config);
  }

  async geometry(): Promise<Geometry> {
    return geometryOf(await contents(this.request(laser.REQ_GET_GEOM)));
  }
}
