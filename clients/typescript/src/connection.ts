/** One connection to a Player server: banner, framing, deadlines. It interprets headers only. */

import { after, Bell, now } from './bell.js';
import { ConnectionLost, InvalidValue, RunEnded, WireError } from './errors.js';
import type { Route, Stream } from './stream.js';
import { joined, shown } from './text.js';
import { decodeHeader, encodeHeader, HEADER_BYTES, MAX_BODY_BYTES, type Header } from './wire.js';

const kBannerBytes = 32;
/** Received bytes beyond which nothing more is received before they are taken, if a message is among them. */
const kEnough = 1 << 18;

/** A header and the undecoded body. */
export interface Message {
  header: Header;
  body: Uint8Array;
}

/** Checks a time-out: 0 or more, infinity included. Throws InvalidValue. */
export function checkedSeconds(timeout: number): number {
  if (!(typeof timeout === 'number' && timeout >= 0)) throw new InvalidValue(`invalid time-out of ${shown(timeout)} s: 0 or more is valid`);
  return timeout;
}

/**
 * Sends and receives complete messages. If the server disconnects, messages it had sent can still be taken; then every
 * call throws the reason.
 */
export class Connection {
  /** HOST:PORT of the server, or its URL. */
  readonly peer: string;
  /** The server's port; 0 if that is not known. */
  readonly port: number;
  /** The server's greeting. */
  banner = '';
  /** Rings when bytes have arrived, and at the end of the connection. */
  readonly news = new Bell();
  private stream: Stream | undefined;
  private fault = ''; // why nothing can be sent
  private lastWord = ''; // why nothing more will be received
  private ended = false; // by the server, in order
  private closing = false;
  private bytes = new Uint8Array(1 << 16);
  private start = 0;
  private end = 0;

  private constructor(route: Route, private readonly timeout: number) {
    this.peer = route.peer;
    this.port = route.port;
  }

  /** Connects and reads the banner within `timeout` s. Throws ConnectionLost. */
  static async open(route: Route, timeout: number): Promise<Connection> {
    const made = new Connection(route, checkedSeconds(timeout));
    const deadline = now() + timeout;
    await made.connect(route, deadline);
    await made.readBanner(deadline);
    return made;
  }

  get alive(): boolean {
    return this.stream !== undefined && !this.fault;
  }

  /** Sends a message; returns when the system has taken it. Throws ConnectionLost; WireError for one that is too long. */
  send(header: Header, body: Uint8Array): Promise<void> {
    if (body.length > MAX_BODY_BYTES) {
      throw new WireError(`a message of ${body.length} bytes is over the wire's limit of ${MAX_BODY_BYTES}`);
    }
    const { stream } = this;
    if (!stream || this.fault) throw this.lost();
    return new Promise((resolve, reject) => {
      const fail = (why: string): void => {
        this.fault ||= `the server is gone: ${why}`; // a partially sent message cannot be continued
        reject(this.lost());
      };
      const cancel = after(this.timeout, () => fail('timed out'));
      stream.write(joined([encodeHeader(header), body]), (why) => {
        cancel();
        if (why) fail(why);
        else resolve();
      });
    });
  }

  /** The next message, undefined if none has arrived as a whole. Throws ConnectionLost. */
  take(): Message | undefined {
    const size = this.nextSize();
    if (size > HEADER_BYTES + MAX_BODY_BYTES) {
      throw this.drop(`a header announces ${size - HEADER_BYTES} bytes, over the limit`);
    }
    if (this.available >= size) {
      const header = decodeHeader(this.bytes, this.start);
      const body = this.bytes.slice(this.start + HEADER_BYTES, this.start + size);
      this.start += size;
      return { header, body };
    }
    if (!this.stream || this.lastWord) throw this.drop(this.lastWord);
    this.stream.resume();
    return undefined;
  }

  /** Whether take() returns a message, or throws, without waiting. */
  buffered(): boolean {
    const size = this.nextSize();
    return this.available >= size || size > HEADER_BYTES + MAX_BODY_BYTES;
  }

  /**
   * Shuts down sending and waits up to `timeout` s until the server has read everything: closing with unread data makes
   * TCP discard data in transit, such as a last stop command.
   */
  async close(timeout: number): Promise<void> {
    const { stream } = this;
    if (stream && !this.lastWord) {
      const deadline = now() + timeout;
      this.closing = true;
      this.start = this.end = 0;
      stream.resume();
      stream.finish();
      while (!this.lastWord && (await this.news.wait(deadline)));
    }
    if (stream) this.drop('the connection is closed');
  }

  private get available(): number {
    return this.end - this.start;
  }

  /** Bytes of the next message, those of its header if it has not arrived. */
  private nextSize(): number {
    return this.available < HEADER_BYTES ? HEADER_BYTES : HEADER_BYTES + decodeHeader(this.bytes, this.start).size;
  }

  private async connect(route: Route, deadline: number): Promise<void> {
    let connected = false;
    try {
      this.stream = route.open({
        connected: () => {
          connected = true;
          this.news.ring();
        },
        data: (bytes) => this.append(bytes),
        end: (why, inOrder = false) => {
          if (inOrder) this.noMore('the run ended: the server closed the connection', true);
          else this.noMore(`${connected ? 'the server is gone' : 'cannot connect'}: ${why}`);
        },
      });
    } catch (error) { // the port or the host is invalid
      throw this.drop(`cannot connect: ${(error as Error).message}`);
    }
    while (!connected) { // the server may have said its last already
      if (this.lastWord) throw this.drop(this.lastWord);
      if (!(await this.news.wait(deadline))) throw this.drop('cannot connect: timed out');
    }
  }

  private async readBanner(deadline: number): Promise<void> {
    while (this.available < kBannerBytes) {
      if (this.lastWord) throw this.drop(this.lastWord);
      if (!(await this.news.wait(deadline))) throw this.drop('cannot connect: no banner in time');
    }
    const banner = String.fromCharCode(...this.bytes.subarray(this.start, this.start + kBannerBytes));
    this.start += kBannerBytes;
    if (!banner.startsWith('Player v.')) throw this.drop(`not a Player server (it says ${shown(banner)})`);
    this.banner = banner.replace(/\0+$/, '');
  }

  private append(chunk: Uint8Array): void {
    if (this.closing) return;
    if (this.end + chunk.length > this.bytes.length) this.makeRoom(chunk.length);
    this.bytes.set(chunk, this.end);
    this.end += chunk.length;
    if (this.available >= kEnough && this.buffered()) this.stream?.pause();
    this.news.ring();
  }

  private makeRoom(count: number): void {
    const { available } = this;
    const from = this.bytes.subarray(this.start, this.end);
    const capacity = Math.max(this.bytes.length, 2 * (available + count));
    const fits = available + count <= this.bytes.length / 2;
    const to = fits ? this.bytes : new Uint8Array(capacity);
    to.set(from, 0);
    this.bytes = to;
    this.start = 0;
    this.end = available;
  }

  private noMore(why: string, inOrder = false): void {
    if (!this.lastWord) {
      this.ended = inOrder;
      this.lastWord = why;
      if (!inOrder) this.fault ||= why;
    }
    this.news.ring();
  }

  private lost(): ConnectionLost {
    return new (this.ended && this.lastWord === this.fault ? RunEnded : ConnectionLost)(`${this.peer}: ${this.fault}`);
  }

  /** Closes the connection and returns the error to throw, with the first reason found. */
  private drop(fault: string): ConnectionLost {
    this.fault ||= fault;
    this.lastWord ||= fault;
    const { stream } = this;
    this.stream = undefined;
    stream?.destroy();
    this.news.ring();
    return this.lost();
  }
}
