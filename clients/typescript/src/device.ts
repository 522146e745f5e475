/** An open device of any interface, base of the proxies for specific interfaces. */

import { asyncDispose } from './async_dispose.js';
import { now } from './bell.js';
import type { Client } from './client.js';
import type { Message } from './connection.js';
import { DeviceClosed, DeviceGone, InvalidValue, NoData, RequestRefused, RequestTimeout } from './errors.js';
import { common, findMessage, INTERFACES, player } from './generated/index.js';
import { decodedOrNothing, deviceName, encoded, type Session } from './session.js';
import { cString, didYouMean, shown, text } from './text.js';
import { Kind, type AnyMessage, type MessageType } from './wire.js';

/** Access to a device. The character codes are those of Player's first servers. */
export const Access = { ALL: player.OPEN_MODE, READ: 'r'.charCodeAt(0), WRITE: 'w'.charCodeAt(0) } as const;
export type Access = (typeof Access)[keyof typeof Access];

/** Called with a data message, its value and the server's time in s. read() waits for the promise it may return. */
export type DataCallback = (message: AnyMessage, value: unknown, timestamp: number) => void | Promise<void>;

interface Stamped<T> {
  value: T;
  /** The server's, in s. */
  time: number;
}

/** A request for a property: its key and, if it sets it, its value. */
interface Property<T> {
  key: Uint8Array;
  value: T;
}

const kCodes = new Map([...INTERFACES].map(([code, name]) => [name, code]));

/** Code of an interface by its name. Throws InvalidValue. */
export function codeOf(name: string): number {
  const code = kCodes.get(name);
  if (code === undefined) throw new InvalidValue(`there is no interface "${name}"${didYouMean(name, kCodes.keys())}`);
  return code;
}

/** Opened by a function of Client or Robot; closed by close(), or by the end of a block with `await using`. */
export class Device {
  /** Name of the interface. */
  readonly interface: string;
  readonly code: number;
  /** Name of the driver behind the device. */
  driver = '';
  /** The server's time at the last data, in s; 0 before the first. */
  timestamp = 0;
  /** Whether data have arrived since the last nextData(). */
  fresh = false;
  private readonly newest = new Map<number, Stamped<unknown>>(); // by subtype
  private callback: DataCallback | undefined;
  private opened = false;
  private goneBecause = ''; // why requests are refused

  constructor(
    protected readonly client: Client, protected readonly session: Session, name: string, readonly index: number,
    readonly access: Access,
  ) {
    this.interface = name;
    this.code = codeOf(name);
    if (!Number.isInteger(index) || index < 0 || index > 65535) {
      throw new InvalidValue(`there is no ${name}:${shown(index)}: indices are 0 to 65535`);
    }
  }

  /** For instance "position2d:0". */
  get name(): string {
    return deviceName(this.code, this.index);
  }

  /** False after close(), of the device or of its client. */
  get isOpen(): boolean {
    return this.opened;
  }

  /**
   * Whether read() has received the notice that the server retired the device. From then on its use throws DeviceGone,
   * its last data remain, and close() has no effect. Before, the server refuses requests and drops commands.
   */
  get gone(): boolean {
    return this.goneBecause !== '';
  }

  /** Whether any data have arrived since this device was opened, and since the run was restarted. */
  get hasData(): boolean {
    return this.newest.size > 0;
  }

  /**
   * Sends a request and waits for the answer, undefined if it has no body; fields that the payload lacks are zero or
   * empty. Throws RequestRefused, and RequestTimeout after `timeout` s. `answered` is called with an ACK before any later
   * message is looked at.
   */
  async request<T>(
    message: MessageType<T>, payload?: Partial<T>, timeout?: number, answered: (answer: Message) => void = () => {},
  ): Promise<T | undefined> {
    this.insistOnOpen();
    const answer = await this.session.request<T>(this.code, this.index, message, payload, { timeout, answered });
    return message.payload && answer.body.length > 0 ? message.payload.decode(answer.body) : undefined;
  }

  /** Sends a command; commands have no answer. Fields that the payload lacks are zero or empty. */
  async command<T>(message: MessageType<T>, payload?: Partial<T>): Promise<void> {
    this.insistOnOpen();
    await this.session.send(this.code, this.index, message, encoded(message, payload));
  }

  /** The newest value of a data message, undefined before the first. */
  latest<T>(message: MessageType<T>): T | undefined {
    return (this.newest.get(message.subtype) as Stamped<T> | undefined)?.value;
  }

  /**
   * Sets a callback, called within Client.read() with all data of this device; undefined: none. It may send requests and
   * commands and close devices. Until it, or the promise that it returns, has ended, read() is an error, for all tasks.
   */
  onData(callback: DataCallback | undefined): void {
    this.callback = callback;
  }

  /** Waits for data newer than those of the last call. Throws RequestTimeout after `timeout` s. */
  async nextData(timeout?: number): Promise<void> {
    const seconds = this.session.timeoutOrOwn(timeout);
    const deadline = now() + seconds;
    const late = `${this.session.peer}: no data of ${this.name} in ${Number(seconds.toPrecision(6))} s`;
    while (!this.fresh) {
      this.insistOnOpen();
      try {
        await this.client.readOrWait(deadline);
      } catch (error) {
        throw error instanceof RequestTimeout ? new RequestTimeout(late) : error;
      }
      if (!this.fresh && now() >= deadline) throw new RequestTimeout(late); // read() is busy with other devices
    }
    this.fresh = false;
  }

  /** A property by its key. Throws RequestRefused if there is none of this type; so do the next three. */
  async getBool(key: string): Promise<boolean> {
    return (await this.getProperty('bool', common.REQ_GET_BOOLPROP, key)) !== 0;
  }

  getInt(key: string): Promise<number> {
    return this.getProperty('int', common.REQ_GET_INTPROP, key);
  }

  getDouble(key: string): Promise<number> {
    return this.getProperty('float', common.REQ_GET_DBLPROP, key);
  }

  async getString(key: string): Promise<string> {
    return text(await this.getProperty('str', common.REQ_GET_STRPROP, key));
  }

  /**
   * Why the driver of a position2d or planner does not drive to the goal that it was given last, as its log says; empty if
   * it does, has arrived, has not planned yet, or gives no reasons.
   */
  async whyRefused(): Promise<string> {
    try {
      return await this.getString('refusal');
    } catch (error) {
      if (error instanceof RequestRefused) return '';
      throw error;
    }
  }

  /** Sets a property. Throws RequestRefused if the driver does not take the value; so do the next three. */
  setBool(key: string, value: boolean): Promise<void> {
    return this.setProperty(common.REQ_SET_BOOLPROP, key, Number(value), shown(value));
  }

  async setInt(key: string, value: number): Promise<void> {
    this.insistOnWhole('value', value, -(2 ** 31), 2 ** 31 - 1);
    await this.setProperty(common.REQ_SET_INTPROP, key, value, shown(value));
  }

  setDouble(key: string, value: number): Promise<void> {
    return this.setProperty(common.REQ_SET_DBLPROP, key, value, shown(value));
  }

  async setString(key: string, value: string): Promise<void> {
    await this.setProperty(common.REQ_SET_STRPROP, key, cString(value), shown(value));
  }

  /** Whether the driver reports that it supports a message. Many drivers never do. */
  async hasCapability(message: AnyMessage): Promise<boolean> {
    try {
      await this.request(common.REQ_CAPABILITIES, { type: message.kind, subtype: message.subtype });
    } catch (error) {
      if (error instanceof RequestRefused) return false;
      throw error;
    }
    return true;
  }

  /** Closes the device; a second call has no effect. */
  async close(): Promise<void> {
    if (!this.opened) return;
    this.opened = false;
    this.client.forget(this);
    if (this.session.connection.alive && !this.gone) await this.setAccess(player.CLOSE_MODE, 'close', () => {});
  }

  [asyncDispose](): Promise<void> {
    return this.close();
  }

  /** Requests the device from the server. Called by Client. */
  async open(): Promise<void> {
    this.driver = await this.setAccess(this.access, 'open', () => {
      this.opened = true;
      this.client.register(this);
    });
  }

  /** Requests constant data for a proxy. Called by Client after opening. */
  async prepare(): Promise<void> {}

  /** Receives data. Called by Client.read(). */
  take(message: AnyMessage, value: unknown, timestamp: number): void | Promise<void> {
    this.newest.set(message.subtype, { value, time: timestamp });
    this.timestamp = timestamp;
    this.fresh = true;
    return this.callback?.(message, value, timestamp);
  }

  /** Whether data of this time are earlier than the last of their kind: the simulated time went back. */
  goesBack(message: AnyMessage, timestamp: number): boolean {
    const last = this.newest.get(message.subtype);
    return last !== undefined && timestamp < last.time;
  }

  /** Drops all data, as before the first: the run that they are of is over. Called by Client. */
  forgetData(): void {
    this.newest.clear();
    this.timestamp = 0;
    this.fresh = false;
  }

  /** Marks the device as retired by the server, whose own port number is `port`. Called by Client. */
  retire(port: number): void {
    this.goneBecause ||= `${port}:${this.name} is gone: the server retired it`;
  }

  /** Reads for ever: what `look` sees after each new data message. */
  protected async *follow<T>(look: () => T, timeout?: number): AsyncGenerator<T, never, void> {
    for (;;) {
      await this.nextData(timeout);
      yield look();
    }
  }

  /** Whether a command sent now would reach the server. */
  protected get reachable(): boolean {
    return this.opened && !this.gone && this.session.connection.alive;
  }

  /** Throws InvalidValue, with the name of the first number that is not finite. */
  protected insistOnFinite(numbers: object): void {
    for (const [name, value] of Object.entries(numbers)) {
      if (Number.isFinite(value)) continue;
      throw new InvalidValue(`${this.name}: ${name} is ${shown(value)}, not a finite number`);
    }
  }

  protected insistOnWhole(name: string, value: number | bigint, least: number | bigint, most: number | bigint): void {
    const whole = typeof value === 'bigint' || Number.isInteger(value);
    if (!whole || value < least || value > most) {
      const wanted = `a whole number from ${least} to ${most}`;
      throw new InvalidValue(`${this.name}: ${name} is ${shown(value)}, not ${wanted}`);
    }
  }

  /** The newest value of a data message and its time. Throws NoData before the first. */
  protected stamped<T>(message: MessageType<T>): Stamped<T> {
    const found = this.newest.get(message.subtype) as Stamped<T> | undefined;
    if (!found) throw new NoData(`${this.session.peer}: ${this.name} ${this.lackOf(message)}`);
    return found;
  }

  /** The newest value of several kinds of data. Throws NoData if there is none. */
  protected newestOf<T>(...kinds: AnyMessage[]): T {
    const known = kinds.filter((kind) => this.latest(kind) !== undefined);
    const values = (known.length > 0 ? known : kinds.slice(0, 1)).map((kind) => this.stamped<T>(kind));
    return values.reduce((a, b) => (b.time > a.time ? b : a)).value;
  }

  /** The first value of a list. Throws NoData without one. */
  protected firstOf<T>(values: T[], what: string): T {
    const [first] = values;
    if (first === undefined) throw new NoData(`${this.session.peer}: ${this.name} has no ${what}`);
    return first;
  }

  /** Why there is no value of a data message. */
  protected lackOf(message: AnyMessage): string {
    if (!this.hasData) return 'has sent no data yet; nextData() waits for them';
    const sent = [...this.newest.keys()].map((subtype) => findMessage(this.code, Kind.DATA, subtype)?.name);
    return `sends ${sent.join(', ')}, not ${message.name}`;
  }

  private insistOnOpen(): void {
    if (!this.opened) throw new DeviceClosed(`${this.session.peer}: ${this.name} is closed`);
    if (this.gone) throw new DeviceGone(this.goneBecause);
  }

  private async getProperty<T>(kind: string, message: MessageType<Property<T>>, key: string): Promise<T> {
    const none = `${this.session.peer}: ${this.name} has no ${kind} property "${key}"`;
    const asked = { key: cString(key) } as Partial<Property<T>>;
    const answer = await this.orRefused(none, this.request(message, asked));
    if (!answer) throw new RequestRefused(none);
    return answer.value;
  }

  private async setProperty<T>(message: MessageType<Property<T>>, key: string, value: T, said: string): Promise<void> {
    const sent: Partial<Property<T>> = { key: cString(key), value };
    await this.orRefused(`${this.session.peer}: ${this.name} refuses ${said} as "${key}"`, this.request(message, sent));
  }

  /** The result of `asked`; if it is refused, this is the error's line. */
  protected async orRefused<T>(line: string, asked: Promise<T>): Promise<T> {
    try {
      return await asked;
    } catch (error) {
      throw error instanceof RequestRefused ? new RequestRefused(line) : error;
    }
  }

  /** Opens or closes; `granted` is called before any later message is looked at. Returns the driver's name. */
  private async setAccess(access: number, verb: 'open' | 'close', granted: () => void): Promise<string> {
    const { peer } = this.session;
    const asked = { addr: common.Devaddr.make({ interf: this.code, index: this.index }), access };
    const answered = ({ body }: Message): void => {
      const told = decodedOrNothing(() => player.DeviceReq.decode(body));
      if (told && told.access !== player.ERROR_MODE) granted();
    };
    let answer: Message;
    try {
      answer = await this.session.request(player.CODE, 0, player.REQ_DEV, asked, { answered });
    } catch (error) {
      if (error instanceof RequestRefused) throw new RequestRefused(`${peer}: there is no ${this.name} to ${verb}`);
      if (error instanceof RequestTimeout) throw new RequestTimeout(`${peer}: no answer in time: ${verb} ${this.name}`);
      throw error;
    }
    const told = player.DeviceReq.decode(answer.body);
    if (told.access === player.ERROR_MODE) throw new RequestRefused(`${peer}: cannot ${verb} ${this.name}`);
    return text(told.driverName);
  }
}
