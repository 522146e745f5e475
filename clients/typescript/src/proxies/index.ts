/**
 * Proxies of the common interfaces. Reading a device's data never waits: it returns the data of the last Client.read(),
 * and throws NoData before the first data of the device. nextData() and updates() wait.
 */

import type { Device } from '../device.js';
import { Aio } from './aio.js';
import { Bumper } from './bumper.js';
import { Camera } from './camera.js';
import { Fiducial } from './fiducial.js';
import { Gps } from './gps.js';
import { Imu } from './imu.js';
import { Laser } from './laser.js';
import { Localize } from './localize.js';
import { Map } from './map.js';
import { Opaque } from './opaque.js';
import { Planner } from './planner.js';
import { PointCloud3d } from './pointcloud3d.js';
import { Position2d } from './position2d.js';
import { Position3d } from './position3d.js';
import { Ptz } from './ptz.js';
import { Ranger } from './ranger.js';
import { Simulation } from './simulation.js';
import { Sonar } from './sonar.js';
import { Speech } from './speech.js';
import { SpeechRecognition } from './speech_recognition.js';

export {
  Aio,
  Bumper,
  Camera,
  Fiducial,
  Gps,
  Imu,
  Laser,
  Localize,
  Map,
  Opaque,
  Planner,
  PointCloud3d,
  Position2d,
  Position3d,
  Ptz,
  Ranger,
  Simulation,
  Sonar,
  Speech,
  SpeechRecognition,
};

/** Interface -> its proxy. */
export const PROXIES = {
  aio: Aio,
  bumper: Bumper,
  camera: Camera,
  fiducial: Fiducial,
  gps: Gps,
  imu: Imu,
  laser: Laser,
  localize: Localize,
  map: Map,
  opaque: Opaque,
  planner: Planner,
  pointcloud3d: PointCloud3d,
  position2d: Position2d,
  position3d: Position3d,
  ptz: Ptz,
  ranger: Ranger,
  simulation: Simulation,
  sonar: Sonar,
  speech: Speech,
  speech_recognition: SpeechRecognition,
} as const;

/** The class of a device of this interface. */
export type ProxyOf<Name extends string> =
  Name extends keyof typeof PROXIES ? InstanceType<(typeof PROXIES)[Name]> : Device;
