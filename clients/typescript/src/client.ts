/** A connection to a Player server, and requests to the server itself. */

import { asyncDispose } from './async_dispose.js';
import { Bell, now } from './bell.js';
import { checkedSeconds, Connection } from './connection.js';
import { Access, Device } from './device.js';
import { ConnectionLost, InvalidValue, PlayerError, RequestRefused, RequestTimeout, WireError } from './errors.js';
import { common, INTERFACES, player, simulation } from './generated/index.js';
import { askModels, families, type Model } from './models.js';
import { Openers, PROXIES, type ProxyOf } from './generated/proxies/index.js';
import { Robot } from './robot.js';
import { decodedData, Session } from './session.js';
import type { Route } from './stream.js';
import { cString, didYouMean, text, utf8 } from './text.js';
import { overWebSocket } from './websocket.js';
import type { AnyMessage } from './wire.js';

const kDefaultHost = '127.0.0.1'; // not localhost: a machine without /etc/hosts cannot resolve it
const kDefaultPort = 6665;
const kClosingSeconds = 1;
const kTokenBytes = 32;

/** Delivery of data: immediately (push), or in rounds requested by the client (pull). */
export const Mode = { PUSH: player.DATAMODE_PUSH, PULL: player.DATAMODE_PULL } as const;
export type Mode = (typeof Mode)[keyof typeof Mode];

/** Handling of a message for this client while an older one of the same type is queued. */
export const Rule = {
  ACCEPT: player.MSG_REPLACE_RULE_ACCEPT,
  REPLACE: player.MSG_REPLACE_RULE_REPLACE,
  IGNORE: player.MSG_REPLACE_RULE_IGNORE,
} as const;
export type Rule = (typeof Rule)[keyof typeof Rule];

export interface ClientOptions {
  /** Mode.PULL unless given. */
  mode?: Mode;
  /** In s, 5 unless given: of connecting, of every request, and of every read() without a time-out of its own. */
  timeout?: number;
  /** A guest's, for a run with --guests; none unless given. */
  token?: string;
}

/** One entry of the server's device list. */
export interface DeviceEntry {
  /** INTERFACE:INDEX, for instance "position2d:12". */
  name: string;
  /** A name, or a number if it has no known name. */
  interface: string;
  index: number;
  driver: string;
  /** Full name of the model behind the device, empty if the server does not report it. */
  model: string;
  /** That of its top-level model. */
  robot: string;
}

/** Messages that a replace rule is for; without a number: any. */
export interface RuleScope {
  /** Code. */
  interface?: number;
  index?: number;
  kind?: number;
  subtype?: number;
}

type DeviceClass<T extends Device> = new (
  client: Client, session: Session, name: string, index: number, access: Access,
) => T;

/**
 * Connects to "host", "host:port", ":port" or "[::1]:port"; the defaults are 127.0.0.1 and 6665. Or to a server's page,
 * "ws://host:8080/player", also in a browser. Throws ConnectionLost, and RequestRefused for a wrong token.
 */
export async function connect(address = kDefaultHost, options: ClientOptions = {}): Promise<Client> {
  if (/^wss?:/.test(address)) return Client.over(overWebSocket(address), options);
  const [host, port] = split(address);
  if (!/^\d+$/.test(port) || Number(port) < 1 || Number(port) > 65535) {
    throw new ConnectionLost(`"${address}" is not HOST or HOST:PORT`);
  }
  return Client.open(host || kDefaultHost, Number(port), options);
}

/** Host and port of an address; an IPv6 host is in brackets. */
function split(address: string): [host: string, port: string] {
  const [, bracketed, rest] = /^\[([^\]]*)\]?(.*)$/s.exec(address) ?? [];
  if (bracketed !== undefined) return [bracketed, rest ? rest.slice(1) : String(kDefaultPort)];
  const colon = address.lastIndexOf(':');
  return colon < 0 ? [address, String(kDefaultPort)] : [address.slice(0, colon), address.slice(colon + 1)];
}

/**
 * One connection. Devices and connection are closed by close(), or by the end of a block with `await using`.
 *
 * Any number of tasks may use it and its devices at the same time: requests wait for their own answers, and of several
 * tasks that wait for data one reads for all.
 */
export class Client extends Openers {
  /** How the server delivers data; PUSH is the initial mode of a server. */
  mode: Mode = Mode.PUSH;
  private readonly session: Session;
  private readonly devicesByPlace = new Map<number, Device[]>();
  private readonly robotsByKey = new Map<string, Robot>();
  private known: Model[][] = []; // families, as of the last query
  private readonly readEnds = new Bell();
  private reading = false;
  private calling = false; // a callback is running
  private closing: Promise<void> | undefined;

  private constructor(connection: Connection, timeout: number) {
    super();
    this.session = new Session(connection, timeout, (at) => this.retire(at));
  }

  /** Connects to a host by name or address. Throws ConnectionLost, and RequestRefused for a wrong token. */
  static async open(host: string, port: number, options: ClientOptions = {}): Promise<Client> {
    const { overTcp } = await import('./tcp.js'); // not in browsers
    return Client.over(overTcp(host, port), options);
  }

  /** The same by any route. */
  static async over(route: Route, options: ClientOptions = {}): Promise<Client> {
    const { mode = Mode.PULL, timeout = 5, token = '' } = options;
    const client = new Client(await Connection.open(route, checkedSeconds(timeout)), timeout);
    try {
      if (token !== '') await client.authenticate(token);
      if (mode !== Mode.PUSH) await client.setMode(mode);
    } catch (error) {
      await client.close();
      throw error;
    }
    return client;
  }

  /** The server's greeting, for instance "Player v.3.1". */
  get banner(): string {
    return this.session.connection.banner;
  }

  get connected(): boolean {
    return this.session.connection.alive;
  }

  /** Data messages dropped because they were not read in time, here or in the server. */
  get overflowCount(): number {
    return this.session.overflowCount;
  }

  /** Messages without a recipient, and invalid messages. */
  get skippedCount(): number {
    return this.session.skippedCount;
  }

  /**
   * Queries the number of data messages lost on the way to this client, in any mode: the server's count plus those not
   * read here in time. Throws RequestRefused if the server does not report it.
   */
  async lostCount(): Promise<number> {
    const answer = await this.ask(common.REQ_GET_INTPROP, { key: cString('lost') });
    return common.IntpropReq.decode(answer).value + this.session.unreadCount;
  }

  /** The devices of the server, in its own order, with the driver and the model behind each. */
  async devices(): Promise<DeviceEntry[]> {
    const listed = player.DeviceDevlist.decode(await this.ask(player.REQ_DEVLIST)).devices;
    const simulated = listed.some(({ interf }) => interf === simulation.CODE);
    const owners = simulated ? await this.findOwners() : new Map<string, [string, string]>();
    const found: DeviceEntry[] = [];
    for (const { robot: port, interf, index } of listed) {
      const name = INTERFACES.get(interf) ?? String(interf);
      const [model, robot] = owners.get(`${port}:${name}:${index}`) ?? ['', ''];
      const driver = await this.driverOf(interf, index);
      found.push({ name: `${name}:${index}`, interface: name, index, driver, model, robot });
    }
    return found;
  }

  async setMode(mode: Mode): Promise<void> {
    if (!Object.values(Mode).includes(mode)) throw new InvalidValue(`a mode is Mode.PUSH or Mode.PULL, not ${mode}`);
    await this.ask(player.REQ_DATAMODE, { mode });
    this.mode = mode;
  }

  private async authenticate(token: string): Promise<void> {
    const authKey = utf8(token);
    if (authKey.length > kTokenBytes) throw new InvalidValue(`a token has ${kTokenBytes} letters at most, not ${authKey.length}`);
    try {
      await this.ask(player.REQ_AUTH, { authKey });
    } catch (error) {
      if (!(error instanceof RequestRefused)) throw error;
      throw new RequestRefused(`${this.session.peer}: the token is refused; a run without --guests needs none`);
    }
  }

  /** Sets the server's rule for messages queued for this client. */
  async setReplaceRule(rule: Rule, scope: RuleScope = {}): Promise<void> {
    const { interface: code = -1, index = -1, kind = -1, subtype = -1 } = scope;
    await this.ask(player.REQ_ADD_REPLACE_RULE, { interf: code, index, type: kind, subtype, replace: rule });
  }

  /**
   * Waits for data and delivers them to the devices; returns the number of messages.
   *
   * In pull mode this is one round: everything the server has queued for this client. In push mode it is what has
   * arrived, at least one message, or none if a device was retired before (Device.gone). Throws RequestTimeout without
   * data in `timeout` s; the next read() continues to wait. If the server disconnects, data it had sent are delivered
   * first; the next read() throws ConnectionLost. While another task reads, this waits for the end of that.
   */
  async read(timeout?: number): Promise<number> {
    const deadline = now() + this.session.timeoutOrOwn(timeout);
    this.insistOutsideCallback();
    while (this.reading) await this.otherRead(deadline);
    this.reading = true;
    this.session.told = false;
    try {
      return await (this.mode === Mode.PULL ? this.readRound(deadline) : this.readPushed(deadline));
    } finally {
      this.endReading();
    }
  }

  /** Reads, or if another task is reading, waits for the end of that. Called by Device.nextData(). */
  async readOrWait(deadline: number): Promise<void> {
    this.insistOutsideCallback();
    if (this.reading) await this.otherRead(deadline);
    else await this.read(Math.max(0, deadline - now()));
  }

  /** In push mode, delivers data that have arrived to the devices, without waiting for more. */
  async deliverPushed(): Promise<void> {
    if (this.mode !== Mode.PUSH || this.reading) return;
    this.reading = true;
    try {
      await this.deliver();
    } finally {
      this.endReading();
    }
  }

  /** Opens a device of any interface, as the proxy of that interface if there is one. */
  override device<Name extends string>(name: Name, index = 0, access: Access = Access.ALL): Promise<ProxyOf<Name>> {
    const known: Record<string, DeviceClass<Device>> = PROXIES;
    const kind = Object.hasOwn(known, name) ? known[name]! : Device;
    return this.openAs(kind, name, index, access) as Promise<ProxyOf<Name>>;
  }

  /**
   * All models in the simulated world now, with their devices, parents before children. Throws RequestRefused if the
   * server does not report models (not every simulator does, and no real robot).
   */
  async models(): Promise<Model[]> {
    return (await this.listFamilies()).map(([model]) => model!);
  }

  /**
   * The robot, or any other model, of this name, with the devices of all its descendants. It is looked up in the last
   * list of models() or robots(), and if it is not there, in a new list. The same name gives the same Robot object while
   * its devices are the same; of several models with one name it is the last. Throws RequestRefused if there is none,
   * and as models().
   */
  async robot(name: string): Promise<Robot> {
    const isNamed = ([model]: Model[]): boolean => model?.name === name;
    const named = this.known.filter(isNamed).at(-1) ?? (await this.listFamilies()).filter(isNamed).at(-1);
    if (named) return this.robotOf(named);
    const near = didYouMean(name, this.known.map(([model]) => model!.name));
    throw new RequestRefused(`there is no robot "${name}" at ${this.session.peer}${near}`);
  }

  /**
   * The top-level models with devices on this connection, of their own or of descendants, in the order of the world
   * file. Throws RequestRefused as models().
   */
  async robots(): Promise<Robot[]> {
    const tops = (await this.listFamilies()).filter(([model]) => !model!.parent).map((family) => this.robotOf(family));
    return tops.filter(({ devices }) => devices.some(({ port }) => port === this.session.serverPort));
  }

  /** Closes all devices in reverse order of opening, and waits until the server has read everything. */
  close(): Promise<void> {
    this.closing ??= this.closeAll();
    return this.closing;
  }

  [asyncDispose](): Promise<void> {
    return this.close();
  }

  /** Adds an open device to the list. Called by Device. */
  register(device: Device): void {
    const same = this.devicesByPlace.get(placeOf(device.code, device.index)) ?? [];
    if (same.some(({ gone }) => gone)) this.session.dropWaiting(device.code, device.index);
    this.devicesByPlace.set(placeOf(device.code, device.index), [...same, device]);
  }

  /** Drops all data received so far: the run that they are of is over. Called by Simulation at the answer to a reset. */
  forgetRun(): void {
    this.session.waiting = [];
    this.forgetLater(-Infinity);
  }

  /** Removes a closed device from the list. Called by Device. */
  forget(device: Device): void {
    const place = placeOf(device.code, device.index);
    const same = (this.devicesByPlace.get(place) ?? []).filter((each) => each !== device);
    if (same.length > 0) {
      this.devicesByPlace.set(place, same);
      return;
    }
    this.devicesByPlace.delete(place);
    if (device.gone) this.session.dropWaiting(device.code, device.index);
  }

  private async closeAll(): Promise<void> {
    // One at a time: another task may be opening a device meanwhile.
    for (let last = this.lastOpened(); last; last = this.lastOpened()) {
      try {
        await last.close();
      } catch (error) {
        if (!(error instanceof PlayerError)) throw error; // closing the connection closes it as well
      }
    }
    await this.session.connection.close(kClosingSeconds);
  }

  private lastOpened(): Device | undefined {
    return [...this.devicesByPlace.values()].flat().at(-1);
  }

  /** The undecoded answer of the server itself to a request. */
  private async ask<T>(message: AnyMessage, payload?: Partial<T>): Promise<Uint8Array> {
    return (await this.session.request(player.CODE, 0, message, payload)).body;
  }

  /** Name of the driver behind a device, empty if the server does not report it. */
  private async driverOf(code: number, index: number): Promise<string> {
    try {
      const answer = await this.ask(player.REQ_DRIVERINFO, { addr: common.Devaddr.make({ interf: code, index }) });
      return text(player.DeviceDriverinfo.decode(answer).driverName);
    } catch (error) {
      if (error instanceof RequestRefused || error instanceof WireError) return '';
      throw error;
    }
  }

  /** PORT:INTERFACE:INDEX -> the model behind the device and its top-level model; empty if the server reports none. */
  private async findOwners(): Promise<Map<string, [string, string]>> {
    const owners = new Map<string, [string, string]>();
    try {
      await this.listFamilies();
    } catch (error) {
      if (error instanceof RequestRefused) return owners;
      throw error;
    }
    for (const family of this.known.filter(([model]) => !model!.parent)) {
      for (const { port, interface: name, index, model } of family.flatMap(({ devices }) => devices)) {
        owners.set(`${port}:${name}:${index}`, [model, family[0]!.name]);
      }
    }
    return owners;
  }

  /** All current models, each with its descendants. */
  private async listFamilies(): Promise<Model[][]> {
    try {
      const simulator = await this.simulation(0);
      try {
        this.known = families(await askModels(simulator));
      } finally {
        await simulator.close();
      }
    } catch (error) {
      if (!(error instanceof RequestRefused)) throw error;
      const why = 'this server does not tell the names of models; open devices by number';
      throw new RequestRefused(`${this.session.peer}: ${why}`);
    }
    return this.known;
  }

  private robotOf(family: Model[]): Robot {
    const key = JSON.stringify([family[0]!.name, family.flatMap(({ devices }) => devices)]);
    const found = this.robotsByKey.get(key) ?? new Robot(this, family, this.session.serverPort);
    this.robotsByKey.set(key, found);
    return found;
  }

  /** Drops the data of devices whose last are later than this time: of a run that is over when time goes back. */
  private forgetLater(timestamp: number): void {
    for (const device of [...this.devicesByPlace.values()].flat()) {
      if (device.timestamp > timestamp) device.forgetData();
    }
  }

  private retire(at: common.Devaddr): void {
    for (const device of this.devicesByPlace.get(placeOf(at.interf, at.index)) ?? []) device.retire(at.robot);
  }

  private async openAs<T extends Device>(
    kind: DeviceClass<T>, name: string, index: number, access: Access,
  ): Promise<T> {
    const device = new kind(this, this.session, name, index, access);
    await device.open();
    try {
      await device.prepare();
    } catch (error) {
      if (error instanceof RequestRefused) return device; // works without the results of prepare()
      await device.close();
      throw error;
    }
    return device;
  }

  private insistOutsideCallback(): void {
    if (this.calling) throw new PlayerError('read() was called from a callback that read() itself is running');
  }

  /** Waits until the read() of another task ends. */
  private async otherRead(deadline: number): Promise<void> {
    if (!(await this.readEnds.wait(deadline))) throw new RequestTimeout(`${this.session.peer}: no data in time`);
  }

  private endReading(): void {
    this.reading = false;
    this.readEnds.ring();
  }

  private async readRound(deadline: number): Promise<number> {
    await this.session.beginRound();
    const delivered = await this.receive(deadline, () => this.session.roundOpen);
    if (this.session.roundRefused && delivered === 0) {
      throw new RequestRefused(`${this.session.peer}: the server refuses to send data`);
    }
    return delivered;
  }

  private readPushed(deadline: number): Promise<number> {
    return this.receive(deadline, (delivered) => delivered === 0 || this.session.connection.buffered());
  }

  /**
   * Delivers queued messages, and new ones while `more` holds for the count so far; returns the number of messages. A
   * disconnection after data is left to the next call, so that the data are delivered first.
   */
  private async receive(deadline: number, more: (delivered: number) => boolean): Promise<number> {
    const { session } = this;
    let delivered = 0;
    for (;;) {
      while (session.waiting.length > 0) delivered += await this.deliver();
      // No other task can queue data between this point and the next wait.
      if (!more(delivered) || (session.told && delivered === 0)) return delivered;
      const fault = await session.sortNext(deadline).catch((error: unknown) => error);
      const late = fault instanceof RequestTimeout;
      if (delivered > 0 && (late || fault instanceof ConnectionLost)) return delivered;
      if (fault !== undefined) throw late ? new RequestTimeout(`${session.peer}: no data in time`) : fault;
    }
  }

  /** Gives queued data to their devices; returns the number of messages. */
  private async deliver(): Promise<number> {
    let count = 0;
    for (let message = this.session.waiting.shift(); message; message = this.session.waiting.shift()) {
      const takers = this.devicesByPlace.get(placeOf(message.header.interface, message.header.index)) ?? [];
      const data = takers.length > 0 ? decodedData(message) : undefined;
      if (!data) {
        this.session.skippedCount += 1;
        continue;
      }
      const { timestamp } = message.header;
      // Another client restarted or rewound the run.
      if (takers.some((device) => device.goesBack(data.row, timestamp))) this.forgetLater(timestamp);
      // The last data of a retired device belong to it, unless a new device has its address.
      const there = takers.filter(({ gone }) => !gone);
      for (const device of there.length > 0 ? there : takers) {
        await this.callBack(() => device.take(data.row, data.value, timestamp));
      }
      count += 1;
    }
    return count;
  }

  /** Runs what may run a callback, and waits for its promise. */
  private async callBack(act: () => void | Promise<void>): Promise<void> {
    this.calling = true;
    try {
      const ended = act();
      if (ended) await ended; // otherwise without a pause in which another task could run
    } finally {
      this.calling = false;
    }
  }
}

function placeOf(code: number, index: number): number {
  return code * 65536 + index;
}
