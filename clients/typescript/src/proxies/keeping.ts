import { Device } from '../device.js';
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
