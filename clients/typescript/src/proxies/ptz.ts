import { Device } from '../device.js';
import { ptz } from '../generated/index.js';
import type { Geometry, View } from '../values.js';
import { contents, geometryOf } from './convert.js';

/** A pan-tilt-zoom mount of a camera. */
export class Ptz extends Device {
  /** The current direction and field of view. */
  get view(): View {
    const { pan, tilt, zoom, panspeed, tiltspeed } = this.stamped(ptz.DATA_STATE).value;
    return { pan, tilt, zoom, panSpeed: panspeed, tiltSpeed: tiltspeed };
  }

  /** Reads for ever: one view per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<View, never, void> {
    return this.follow(() => this.view, timeout);
  }

  /** Turns to these angles in rad, in position control; a zoom of 0 keeps the field of view. */
  async look(pan: number, tilt = 0, zoom = 0): Promise<void> {
    this.insistOnFinite({ pan, tilt, zoom });
    await this.command(ptz.CMD_STATE, { pan, tilt, zoom });
  }

  /** Turns at these speeds in rad/s; requires setVelocityControl(true). */
  async turn(panSpeed: number, tiltSpeed = 0): Promise<void> {
    this.insistOnFinite({ panSpeed, tiltSpeed });
    await this.command(ptz.CMD_STATE, { panspeed: panSpeed, tiltspeed: tiltSpeed });
  }

  /** Selects velocity control, or position control. */
  async setVelocityControl(on: boolean): Promise<void> {
    await this.request(ptz.REQ_CONTROL_MODE, { mode: on ? ptz.VELOCITY_CONTROL : ptz.POSITION_CONTROL });
  }

  async geometry(): Promise<Geometry> {
    const { pos, size } = await contents(this.request(ptz.REQ_GEOM));
    return geometryOf({ pose: pos, size });
  }
}
