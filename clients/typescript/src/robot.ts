/** A robot by its name in the world file, with its devices and those of its descendants. */

import { asyncDispose } from './async_dispose.js';
import type { Client } from './client.js';
import type { Device } from './device.js';
import { RequestRefused } from './errors.js';
import { Devices, type ProxyOf } from './generated/proxies/index.js';
import type { DeviceAddress, Model } from './models.js';

/**
 * A model and its descendants, returned by Client.robot() and Client.robots().
 *
 * position2d(), laser() and so on are the first device of their interface, or the one at an index from 0; position2ds(),
 * lasers() and so on are all of them. They are opened on first use. close(), or the end of a block with `await using`,
 * closes devices opened here; a moving robot is stopped first.
 */
export class Robot extends Devices {
  /** As in the world file. */
  readonly name: string;
  readonly type: string;
  /** Addresses of the devices of all `models`. */
  readonly devices: readonly DeviceAddress[];
  private readonly opened = new Map<DeviceAddress, Promise<Device>>(); // in the order of opening

  /** `models` are the model itself and its descendants, `port` is that of the connected server, as it reports it. */
  constructor(private readonly client: Client, readonly models: readonly Model[], private readonly port: number) {
    super();
    this.name = models[0]!.name;
    this.type = models[0]!.type;
    this.devices = models.flatMap(({ devices }) => devices);
  }

  /** The robot's device of an interface at index `nth`, from 0. Throws RequestRefused if it has none. */
  override async device<Name extends string>(name: Name, nth = 0): Promise<ProxyOf<Name>> {
    const address = this.reachable(name)[nth];
    if (address) return this.open<Name>(address);
    const number = nth ? ` number ${nth}` : '';
    throw new RequestRefused(`robot "${this.name}" has no ${name}${number} ${this.elsewhere(name)}`);
  }

  /** Closes devices opened here, in reverse order of opening. They reopen on use. */
  async close(): Promise<void> {
    const opened = [...this.opened.values()].reverse();
    this.opened.clear();
    for (const device of await Promise.allSettled(opened)) {
      if (device.status === 'fulfilled') await device.value.close();
    }
  }

  [asyncDispose](): Promise<void> {
    return this.close();
  }

  protected override async all<Name extends string>(name: Name): Promise<ProxyOf<Name>[]> {
    const found: ProxyOf<Name>[] = [];
    for (const address of this.reachable(name)) found.push(await this.open<Name>(address));
    return found;
  }

  /** A connection reaches the devices of its own port only. */
  private reachable(name: string): DeviceAddress[] {
    return this.devices.filter((at) => at.interface === name && at.port === this.port);
  }

  /** Text: other ports with devices of this interface, or else the existing devices. */
  private elsewhere(name: string): string {
    const others = this.devices.filter((at) => at.interface === name && at.port !== this.port);
    const places = others.map((at) => `${nameOf(at)} at port ${at.port}`).join(', ');
    if (places) return `at port ${this.port}, but ${places}: connect there`;
    return `(it has ${this.devices.map(nameOf).join(', ') || 'no devices'})`;
  }

  /** Tasks that ask for the same device at the same time get the same. */
  private async open<Name extends string>(address: DeviceAddress): Promise<ProxyOf<Name>> {
    const found = this.opened.get(address);
    const there = found && (await found.catch(() => undefined));
    if (there?.isOpen) return there as ProxyOf<Name>;
    if (this.opened.get(address) !== found) return this.open(address);
    const opening = this.client.device(address.interface, address.index);
    this.opened.delete(address);
    this.opened.set(address, opening);
    return (await opening) as ProxyOf<Name>;
  }
}

function nameOf(address: DeviceAddress): string {
  return `${address.interface}:${address.index}`;
}
