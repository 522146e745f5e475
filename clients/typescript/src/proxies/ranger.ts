import { Device } from '../device.js';
import { ranger } from '../generated/index.js';
import { Scan, type Geometry } from '../values.js';
import { contents, geometryOf, spread } from './convert.js';

/** A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration. */
export class Ranger extends Device {
  /** The configuration in effect. */
  config = ranger.Config.make();
  geom = ranger.Geom.make();

  override async prepare(): Promise<void> {
    this.config = await contents(this.request(ranger.REQ_GET_CONFIG));
    this.geom = await contents(this.request(ranger.REQ_GET_GEOM));
  }

  /** In m, in the order of measurement. */
  get ranges(): Float64Array {
    return this.stamped(ranger.DATA_RANGE).value.ranges;
  }

  /** One per range, in the device's unit. Throws NoData also for a device without intensities. */
  get intensities(): Float64Array {
    return this.stamped(ranger.DATA_INTNS).value.intensities;
  }

  /** Ranges with directions: those of the elements if there is one per range, else spread over the field of view. */
  scan(): Scan {
    const { value: { ranges }, time } = this.stamped(ranger.DATA_RANGE);
    const poses = this.geom.elementPoses;
    const { minAngle, maxAngle, maxRange } = this.config;
    const angles = poses.length === ranges.length && ranges.length > 1
      ? Float64Array.from(poses, ({ pyaw }) => pyaw)
      : spread(minAngle, maxAngle, ranges.length);
    return new Scan(ranges, angles, maxRange, time);
  }

  /** Reads for ever: one Scan per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Scan, never, void> {
    return this.follow(() => this.scan(), timeout);
  }

  geometry(): Geometry {
    return geometryOf(this.geom);
  }

  async setPower(on: boolean): Promise<void> {
    await this.request(ranger.REQ_POWER, { state: Number(on) });
  }

  /** Enables or disables intensities. */
  async setIntensities(on: boolean): Promise<void> {
    await this.request(ranger.REQ_INTNS, { state: Number(on) });
  }

  /** Requests another configuration; `config` then has the values in effect. */
  async setConfig(config: ranger.Config): Promise<void> {
    await this.request(ranger.REQ_SET_CONFIG, config);
    this.config = await contents(this.request(ranger.REQ_GET_CONFIG));
  }
}
