import { Device } from '../device.js';
import { fiducial } from '../generated/index.js';
import { Marker, type Geometry } from '../values.js';
import { contents, geometryOf, pose3dOf } from './convert.js';

/** A fiducial finder. */
export class Fiducial extends Device {
  /** Markers in view. */
  get markers(): Marker[] {
    return this.stamped(fiducial.DATA_SCAN).value.fiducials.map(({ id, pose }) => new Marker(id, pose3dOf(pose)));
  }

  /** Reads for ever: one list per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Marker[], never, void> {
    return this.follow(() => this.markers, timeout);
  }

  fieldOfView(): Promise<fiducial.Fov> {
    return contents(this.request(fiducial.REQ_GET_FOV));
  }

  /** Ranges in m, the full field of view in rad. */
  async setFieldOfView(minRange: number, maxRange: number, viewAngle: number): Promise<void> {
    this.insistOnFinite({ minRange, maxRange, viewAngle });
    await this.request(fiducial.REQ_SET_FOV, { minRange, maxRange, viewAngle });
  }

  async geometry(): Promise<Geometry> {
    return geometryOf(await contents(this.request(fiducial.REQ_GET_GEOM)));
  }
}
