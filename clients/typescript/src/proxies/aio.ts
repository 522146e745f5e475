import { Device } from '../device.js';
import { aio } from '../generated/index.js';

/** Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands outputs. */
export class Aio extends Device {
  /** One per input, in V. */
  get voltages(): Float32Array {
    return this.stamped(aio.DATA_STATE).value.voltages;
  }

  /** Reads for ever: one list per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Float32Array, never, void> {
    return this.follow(() => this.voltages, timeout);
  }

  /** Sets one output, in V. */
  async set(output: number, voltage: number): Promise<void> {
    this.insistOnFinite({ voltage });
    await this.command(aio.CMD_STATE, { id: output, voltage });
  }
}
