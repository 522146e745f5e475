import { opaque } from '../generated/index.js';
import { cString } from '../text.js';
import { Keeping } from './keeping.js';

/** Byte messages: those between robots for a simulated radio, driver-specific for other drivers. */
export class Opaque extends Keeping<Uint8Array> {
  /** Sends bytes, or text as UTF-8, to the driver; a radio broadcasts it to all radios in range. */
  async send(message: Uint8Array | string): Promise<void> {
    await this.command(opaque.CMD_DATA, { data: Buffer.from(message) });
  }

  /**
   * For a radio: sends to the radio with this network address, "" to broadcast. Returns when the message is queued.
   * Throws RequestRefused for an unknown address, a message that is too long, or a full queue.
   */
  async sendTo(address: string, message: Uint8Array | string): Promise<void> {
    await this.request(opaque.REQ_DATA, { data: Buffer.concat([cString(address), Buffer.from(message)]) });
  }

  /** Messages of read() since the last call, in order. */
  takeMessages(): Uint8Array[] {
    return this.takeKept();
  }

  protected override meaning(value: unknown): Uint8Array {
    return (value as opaque.Data).data;
  }
}
