import { Device } from '../device.js';
import { speech } from '../generated/index.js';
import { cString } from '../text.js';

/** Speech output of a robot. */
export class Speech extends Device {
  /** Sets the text that the robot says, replacing the previous one; "": none. */
  async say(text: string): Promise<void> {
    await this.command(speech.CMD_SAY, { string: cString(text) });
  }
}
