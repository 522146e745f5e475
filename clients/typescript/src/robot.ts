/** A robot by its name in the world file, with its devices and those of its descendants. */

import { asyncDispose } from './async_dispose.js';
import type { Client } from './client.js';
import type { Device } from './device.js';
import { RequestRefused } from './errors.js';
import type { DeviceAddress, Model } from './models.js';
import type * as proxies from './proxies/index.js';

/**
 * A model and its descendants, returned by Client.robot() and Client.robots().
 *
 * position2d(), laser() and so on are the first device of their interface, or the one at an index from 0; position2ds(),
 * lasers() and so on are all of them. They are opened on first use. close(), or the end of a block with `await using`,
 * closes devices opened here; a moving robot is stopped first.
 */
export class Robot {
  /** As in the world file. */
  readonly name: string;
  readonly type: string;
  /** Addresses of the devices of all `models`. */
  readonly devices: readonly DeviceAddress[];
  private readonly opened = new Map<DeviceAddress, Promise<Device>>(); // in the order of opening

  /** `models` are the model itself and its descendants, `port` is that of the connected server, as it reports it. */
  constructor(private readonly client: Client, readonly models: readonly Model[], private readonly port: number) {
    this.name = models[0]!.name;
    this.type = models[0]!.type;
    this.devices = models.flatMap(({ devices }) => devices);
  }

  /** The robot's device of an interface at index `nth`, from 0. Throws RequestRefused if it has none. */
  async device<Name extends string>(name: Name, nth = 0): Promise<proxies.ProxyOf<Name>> {
    const address = this.reachable(name)[nth];
    if (address) return this.open<Name>(address);
    const number = nth ? ` number ${nth}` : '';
    throw new RequestRefused(`robot "${this.name}" has no ${name}${number} ${this.elsewhere(name)}`);
  }

  position2d(nth = 0): Promise<proxies.Position2d> {
    return this.device('position2d', nth);
  }

  ranger(nth = 0): Promise<proxies.Ranger> {
    return this.device('ranger', nth);
  }

  laser(nth = 0): Promise<proxies.Laser> {
    return this.device('laser', nth);
  }

  sonar(nth = 0): Promise<proxies.Sonar> {
    return this.device('sonar', nth);
  }

  fiducial(nth = 0): Promise<proxies.Fiducial> {
    return this.device('fiducial', nth);
  }

  bumper(nth = 0): Promise<proxies.Bumper> {
    return this.device('bumper', nth);
  }

  aio(nth = 0): Promise<proxies.Aio> {
    return this.device('aio', nth);
  }

  camera(nth = 0): Promise<proxies.Camera> {
    return this.device('camera', nth);
  }

  ptz(nth = 0): Promise<proxies.Ptz> {
    return this.device('ptz', nth);
  }

  opaque(nth = 0): Promise<proxies.Opaque> {
    return this.device('opaque', nth);
  }

  position3d(nth = 0): Promise<proxies.Position3d> {
    return this.device('position3d', nth);
  }

  imu(nth = 0): Promise<proxies.Imu> {
    return this.device('imu', nth);
  }

  gps(nth = 0): Promise<proxies.Gps> {
    return this.device('gps', nth);
  }

  pointcloud3d(nth = 0): Promise<proxies.PointCloud3d> {
    return this.device('pointcloud3d', nth);
  }

  speech(nth = 0): Promise<proxies.Speech> {
    return this.device('speech', nth);
  }

  speechRecognition(nth = 0): Promise<proxies.SpeechRecognition> {
    return this.device('speech_recognition', nth);
  }

  localize(nth = 0): Promise<proxies.Localize> {
    return this.device('localize', nth);
  }

  planner(nth = 0): Promise<proxies.Planner> {
    return this.device('planner', nth);
  }

  map(nth = 0): Promise<proxies.Map> {
    return this.device('map', nth);
  }

  position2ds(): Promise<proxies.Position2d[]> {
    return this.all('position2d');
  }

  rangers(): Promise<proxies.Ranger[]> {
    return this.all('ranger');
  }

  lasers(): Promise<proxies.Laser[]> {
    return this.all('laser');
  }

  sonars(): Promise<proxies.Sonar[]> {
    return this.all('sonar');
  }

  fiducials(): Promise<proxies.Fiducial[]> {
    return this.all('fiducial');
  }

  bumpers(): Promise<proxies.Bumper[]> {
    return this.all('bumper');
  }

  aios(): Promise<proxies.Aio[]> {
    return this.all('aio');
  }

  cameras(): Promise<proxies.Camera[]> {
    return this.all('camera');
  }

  ptzs(): Promise<proxies.Ptz[]> {
    return this.all('ptz');
  }

  opaques(): Promise<proxies.Opaque[]> {
    return this.all('opaque');
  }

  position3ds(): Promise<proxies.Position3d[]> {
    return this.all('position3d');
  }

  imus(): Promise<proxies.Imu[]> {
    return this.all('imu');
  }

  gpses(): Promise<proxies.Gps[]> {
    return this.all('gps');
  }

  pointcloud3ds(): Promise<proxies.PointCloud3d[]> {
    return this.all('pointcloud3d');
  }

  speeches(): Promise<proxies.Speech[]> {
    return this.all('speech');
  }

  speechRecognitions(): Promise<proxies.SpeechRecognition[]> {
    return this.all('speech_recognition');
  }

  localizes(): Promise<proxies.Localize[]> {
    return this.all('localize');
  }

  planners(): Promise<proxies.Planner[]> {
    return this.all('planner');
  }

  maps(): Promise<proxies.Map[]> {
    return this.all('map');
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

  private async all<Name extends string>(name: Name): Promise<proxies.ProxyOf<Name>[]> {
    const found: proxies.ProxyOf<Name>[] = [];
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
  private async open<Name extends string>(address: DeviceAddress): Promise<proxies.ProxyOf<Name>> {
    const found = this.opened.get(address);
    const there = found && (await found.catch(() => undefined));
    if (there?.isOpen) return there as proxies.ProxyOf<Name>;
    if (this.opened.get(address) !== found) return this.open(address);
    const opening = this.client.device(address.interface, address.index);
    this.opened.delete(address);
    this.opened.set(address, opening);
    return (await opening) as proxies.ProxyOf<Name>;
  }
}

function nameOf(address: DeviceAddress): string {
  return `${address.interface}:${address.index}`;
}
