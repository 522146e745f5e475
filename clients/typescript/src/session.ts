/** One session with a server: matches answers to requests, queues data, and tracks rounds of data. */

import { now } from './bell.js';
import { checkedSeconds, type Connection, type Message } from './connection.js';
import { ConnectionLost, RequestRefused, RequestTimeout, WireError } from './errors.js';
import { findMessage, INTERFACES, player, type common } from './generated/index.js';
import { Kind, type AnyMessage, type Header } from './wire.js';

/**
 * Limit on data queued for the next read() while a request waits for its answer: the queue length of a server per
 * client. The oldest are dropped and counted.
 */
export const WAITING_LIMIT = 1024;

/** Access in an unrequested answer to an open request: the device was retired. (Failed requests have ERROR_MODE.) */
const kErrorLetter = 'e'.charCodeAt(0);

/** For instance "position2d:0"; with a number if the interface has no known name. */
export function deviceName(code: number, index: number): string {
  return `${INTERFACES.get(code) ?? code}:${index}`;
}

/** A request without its answer yet. */
interface Pending {
  code: number;
  index: number;
  subtype: number;
  sequence: number;
  answer?: Message;
  abandoned: boolean; // its time is up
  settled: boolean; // the answer to an abandoned request of this type arrived meanwhile
  answered(answer: Message): void;
}

/** Optional parts of a request. */
export interface RequestOptions {
  /** In s; without it the session's own. */
  timeout?: number | undefined;
  /** Called with an ACK before any later message is looked at. */
  answered?: (answer: Message) => void;
}

/**
 * Dispatches received messages: answers to pending requests, data to the queue; others are skipped. Any number of tasks
 * may wait for messages at the same time: when some arrive all of them wake up, take turns at dispatching, and look
 * whether what they wait for has come.
 */
export class Session {
  /** Data for the next read(). */
  waiting: Message[] = [];
  roundOpen = false;
  roundRefused = false;
  /** A device was retired. */
  told = false;
  overflowCount = 0;
  /** Those of them lost here. */
  unreadCount = 0;
  skippedCount = 0;
  private roundWaits = false; // it ended during a request: its data are queued
  private ownPort = 0;
  private pending: Pending[] = []; // in the order of sending
  private sequence = 0;

  /** `retire` is called with the address of a device that the server has retired. */
  constructor(
    readonly connection: Connection, readonly timeout: number, private readonly retire: (at: common.Devaddr) => void,
  ) {}

  /** The time-out (s) of the caller, or the session's own. */
  timeoutOrOwn(timeout: number | undefined): number {
    return timeout === undefined ? this.timeout : checkedSeconds(timeout);
  }

  /** HOST:PORT of the server. */
  get peer(): string {
    return this.connection.peer;
  }

  /** The server's port as reported in its answers; the connected port may be that of a forwarder. */
  get serverPort(): number {
    return this.ownPort || this.connection.port;
  }

  /** Sends a message: when this returns its promise, it is behind all messages sent before. */
  send(code: number, index: number, message: AnyMessage, body: Uint8Array, sequence = 0): Promise<void> {
    const header: Header = {
      interface: code,
      index,
      kind: message.kind,
      subtype: message.subtype,
      timestamp: Date.now() / 1000,
      sequence,
      size: body.length,
      host: 0,
      // As in libplayerc: the port in messages to a device, 0 in messages to the server.
      robot: code === player.CODE ? 0 : this.connection.port,
    };
    return this.connection.send(header, body);
  }

  /** Sends and waits for the ACK. Throws RequestRefused on NACK, RequestTimeout on silence. */
  async request<T>(
    code: number, index: number, message: AnyMessage, payload?: Partial<T>, options: RequestOptions = {},
  ): Promise<Message> {
    const seconds = this.timeoutOrOwn(options.timeout);
    const body = encoded(message, payload);
    const pending: Pending = {
      code,
      index,
      subtype: message.subtype,
      sequence: this.sequence,
      abandoned: false,
      settled: false,
      answered: options.answered ?? (() => {}),
    };
    const whose = `${message.name} of ${deviceName(code, index)}`;
    this.pending.push(pending);
    try {
      await this.send(code, index, message, body, pending.sequence);
      const answer = await this.answerTo(pending, now() + seconds);
      if (answer.header.kind === Kind.NACK) throw new RequestRefused(`${this.peer}: ${whose} was refused`, answer.body);
      return answer;
    } catch (error) {
      if (!pending.answer) this.abandon(pending);
      if (!(error instanceof RequestTimeout)) throw error;
      throw new RequestTimeout(`${this.peer}: no answer to ${whose} in ${Number(seconds.toPrecision(6))} s`);
    }
  }

  /**
   * Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH that clears
   * `roundOpen`, or is refused.
   */
  async beginRound(): Promise<void> {
    const here = this.roundWaits && this.waiting.length > 0;
    this.roundWaits = false;
    if (this.roundOpen || here) return;
    this.roundOpen = true;
    this.roundRefused = false;
    try {
      await this.send(player.CODE, 0, player.REQ_DATA, new Uint8Array(), this.sequence);
    } catch (error) {
      if (!(error instanceof ConnectionLost)) throw error; // data before the disconnection are still to be received
    }
  }

  /** Dispatches the next message, or waits for something new. Throws RequestTimeout and ConnectionLost. */
  async sortNext(deadline: number): Promise<void> {
    if (!this.sortOne() && !(await this.connection.news.wait(deadline))) {
      throw new RequestTimeout(`${this.peer}: no message in time`);
    }
  }

  /** Drops queued data of a retired device, so that they are not delivered to a new device at its address. */
  dropWaiting(code: number, index: number): void {
    const kept = this.waiting.filter(({ header }) => header.interface !== code || header.index !== index);
    this.skippedCount += this.waiting.length - kept.length;
    this.waiting = kept;
  }

  private async answerTo(pending: Pending, deadline: number): Promise<Message> {
    while (!pending.answer) await this.sortNext(deadline);
    return pending.answer;
  }

  /** Dispatches a message, if one has arrived. */
  private sortOne(): boolean {
    const message = this.connection.take();
    if (!message) return false;
    if (!this.takeNotice(message)) this.sort(message);
    return true;
  }

  /** Requests are numbered from now on, so that a late answer to this one is not taken for that to another. */
  private abandon(pending: Pending): void {
    this.sequence += 1;
    pending.abandoned = true;
    if (pending.settled) this.remove(pending); // the number of missing answers is unchanged
  }

  private remove(pending: Pending): void {
    this.pending = this.pending.filter((each) => each !== pending);
  }

  /** Processes the notice that a device was retired; false for any other message. */
  private takeNotice(message: Message): boolean {
    const { header } = message;
    if (header.kind !== Kind.ACK || header.interface !== player.CODE || header.index !== 0) return false;
    if (header.subtype !== player.REQ_DEV.subtype) return false;
    const notice = decodedOrNothing(() => player.DeviceReq.decode(message.body));
    if (notice?.access !== kErrorLetter) return false;
    this.told = true;
    this.retire(notice.addr);
    return true;
  }

  private sort(message: Message): void {
    const { kind } = message.header;
    if (kind === Kind.DATA) this.keep(message);
    else if (kind === Kind.SYNCH) this.endRound(message);
    else if (kind === Kind.ACK || kind === Kind.NACK) this.sortAnswer(message);
    else this.skippedCount += 1;
  }

  private keep(message: Message): void {
    if (this.waiting.length >= WAITING_LIMIT) {
      this.waiting.shift();
      this.overflowCount += 1;
      this.unreadCount += 1;
    }
    this.waiting.push(message);
  }

  private sortAnswer(message: Message): void {
    const { header } = message;
    if (header.interface === player.CODE && header.index === 0 && header.subtype === player.REQ_DATA.subtype) {
      if (header.kind === Kind.NACK) {
        this.roundOpen = false;
        this.roundRefused = true;
      }
      return;
    }
    const pending = this.requestOf(header);
    if (!pending || pending.abandoned) {
      this.skippedCount += 1;
      if (pending) this.settle(pending);
      return;
    }
    this.ownPort = header.robot;
    this.remove(pending);
    if (header.kind === Kind.ACK) pending.answered(message);
    pending.answer = message;
  }

  /** The request of an answer. Number 0 is that of requests before the first time-out, and of servers that give none. */
  private requestOf(header: Header): Pending | undefined {
    const { interface: code, index, subtype, sequence } = header;
    const same = this.pending.filter((each) => isSame(each, { code, index, subtype }));
    if (sequence === 0) return same[0];
    return same.find((each) => each.sequence === sequence);
  }

  /** The answer to an abandoned request has arrived. */
  private settle(pending: Pending): void {
    this.remove(pending);
    for (const each of this.pending) {
      each.settled ||= isSame(each, pending);
    }
  }

  private endRound(message: Message): void {
    this.roundOpen = false;
    this.roundWaits = this.waiting.length > 0;
    if (message.header.subtype !== player.SYNCH_OVERFLOW.subtype) return;
    const lost = decodedOrNothing(() => player.SYNCH_OVERFLOW.payload!.decode(message.body).value) ?? 0;
    this.overflowCount += Math.max(lost, 1);
  }
}

type RequestKind = Pick<Pending, 'code' | 'index' | 'subtype'>;

function isSame(a: RequestKind, b: RequestKind): boolean {
  return a.code === b.code && a.index === b.index && a.subtype === b.subtype;
}

/** The body of a message with this payload; of one without payload it is empty. */
export function encoded<T>(message: AnyMessage, payload: Partial<T> | undefined): Uint8Array {
  return payload !== undefined && message.payload ? message.payload.encode(payload) : new Uint8Array();
}

/** A message of data with its value, undefined if it has no known payload or does not decode. */
export function decodedData(message: Message): { row: AnyMessage; value: unknown } | undefined {
  const row = findMessage(message.header.interface, Kind.DATA, message.header.subtype);
  const payload = row?.payload;
  if (!row || !payload) return undefined;
  return decodedOrNothing(() => ({ row, value: payload.decode(message.body) }));
}

/** What `decode` returns, undefined if the bytes do not decode. */
export function decodedOrNothing<T>(decode: () => T): T | undefined {
  try {
    return decode();
  } catch (error) {
    if (error instanceof WireError) return undefined;
    throw error;
  }
}
