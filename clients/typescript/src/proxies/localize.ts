import { Device } from '../device.js';
import { NoData } from '../errors.js';
import { localize } from '../generated/index.js';
import type { Covariance, Hypothesis, Particle, Pose } from '../values.js';
import { contents, poseOf, wirePose } from './convert.js';

/** Localization of a robot on a map. */
export class Localize extends Device {
  /** Where the robot may be, the most likely first. */
  get hypotheses(): Hypothesis[] {
    return this.stamped(localize.DATA_HYPOTHS).value.hypoths.map(({ mean, cov, alpha }) => {
      const [xx = 0, yy = 0, aa = 0, xy = 0, ya = 0, xa = 0] = cov;
      return { pose: poseOf(mean), covariance: { xx, yy, aa, xy, ya, xa }, weight: alpha };
    });
  }

  /** Reads for ever: one list per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Hypothesis[], never, void> {
    return this.follow(() => this.hypotheses, timeout);
  }

  /** The pose on the map of the most likely hypothesis. Throws NoData also if there is none. */
  get pose(): Pose {
    const [first] = this.hypotheses;
    if (!first) throw new NoData(`${this.session.peer}: ${this.name} has no hypothesis`);
    return first.pose;
  }

  /**
   * Sets the estimate of the pose on the map; the robot does not move. Throws RequestRefused if the driver takes none of
   * this covariance.
   */
  async setPose({ x, y, a }: Pose, { xx, yy, aa, xy, ya, xa }: Covariance): Promise<void> {
    this.insistOnFinite({ x, y, a, xx, yy, aa, xy, ya, xa });
    const cov = Float64Array.of(xx, yy, aa, xy, ya, xa);
    await this.request(localize.REQ_SET_POSE, { mean: wirePose({ x, y, a }), cov });
  }

  /** All particles of the filter; none before its first step. */
  async particles(): Promise<Particle[]> {
    const { particles } = await contents(this.request(localize.REQ_GET_PARTICLES));
    return particles.map(({ pose, alpha }) => ({ pose: poseOf(pose), weight: alpha }));
  }
}
