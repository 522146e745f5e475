import { Device } from '../device.js';
import { gps } from '../generated/index.js';
import type { Fix } from '../values.js';

/** A satellite receiver. */
export class Gps extends Device {
  get fix(): Fix {
    const { value, time } = this.stamped(gps.DATA_STATE);
    return {
      latitude: value.latitude * 1e-7,
      longitude: value.longitude * 1e-7,
      altitude: value.altitude * 1e-3,
      easting: value.utmE,
      northing: value.utmN,
      speed: value.speed,
      course: value.course,
      quality: value.quality,
      satellites: value.numSats,
      horizontalError: value.errHorz,
      verticalError: value.errVert,
      time,
    };
  }

  /** Reads for ever: one Fix per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Fix, never, void> {
    return this.follow(() => this.fix, timeout);
  }
}
