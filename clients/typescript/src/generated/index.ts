/**
 * Every interface of the Player protocol: values, and their encoding and decoding.
 *
 * Generated from interfaces/ by codegen; do not edit.
 */

import { Kind, MessageType, type AnyMessage } from '../wire.js';
import * as common from './common.js';
import * as player from './player.js';
import * as power from './power.js';
import * as gripper from './gripper.js';
import * as position2d from './position2d.js';
import * as sonar from './sonar.js';
import * as laser from './laser.js';
import * as blobfinder from './blobfinder.js';
import * as ptz from './ptz.js';
import * as audio from './audio.js';
import * as fiducial from './fiducial.js';
import * as speech from './speech.js';
import * as gps from './gps.js';
import * as bumper from './bumper.js';
import * as dio from './dio.js';
import * as aio from './aio.js';
import * as ir from './ir.js';
import * as wifi from './wifi.js';
import * as localize from './localize.js';
import * as position3d from './position3d.js';
import * as simulation from './simulation.js';
import * as blinkenlight from './blinkenlight.js';
import * as camera from './camera.js';
import * as map from './map.js';
import * as planner from './planner.js';
import * as log from './log.js';
import * as joystick from './joystick.js';
import * as speech_recognition from './speech_recognition.js';
import * as opaque from './opaque.js';
import * as position1d from './position1d.js';
import * as actarray from './actarray.js';
import * as limb from './limb.js';
import * as graphics2d from './graphics2d.js';
import * as rfid from './rfid.js';
import * as wsn from './wsn.js';
import * as graphics3d from './graphics3d.js';
import * as health from './health.js';
import * as imu from './imu.js';
import * as pointcloud3d from './pointcloud3d.js';
import * as ranger from './ranger.js';
import * as vectormap from './vectormap.js';
import * as blackboard from './blackboard.js';
import * as stereo from './stereo.js';
import * as coopobject from './coopobject.js';

export {
  common,
  player,
  power,
  gripper,
  position2d,
  sonar,
  laser,
  blobfinder,
  ptz,
  audio,
  fiducial,
  speech,
  gps,
  bumper,
  dio,
  aio,
  ir,
  wifi,
  localize,
  position3d,
  simulation,
  blinkenlight,
  camera,
  map,
  planner,
  log,
  joystick,
  speech_recognition,
  opaque,
  position1d,
  actarray,
  limb,
  graphics2d,
  rfid,
  wsn,
  graphics3d,
  health,
  imu,
  pointcloud3d,
  ranger,
  vectormap,
  blackboard,
  stereo,
  coopobject,
};

/** Code of an interface -> its name. */
export const INTERFACES: ReadonlyMap<number, string> = new Map([
  [1, 'player'],
  [2, 'power'],
  [3, 'gripper'],
  [4, 'position2d'],
  [5, 'sonar'],
  [6, 'laser'],
  [7, 'blobfinder'],
  [8, 'ptz'],
  [9, 'audio'],
  [10, 'fiducial'],
  [12, 'speech'],
  [13, 'gps'],
  [14, 'bumper'],
  [20, 'dio'],
  [21, 'aio'],
  [22, 'ir'],
  [23, 'wifi'],
  [25, 'localize'],
  [30, 'position3d'],
  [31, 'simulation'],
  [33, 'blinkenlight'],
  [40, 'camera'],
  [42, 'map'],
  [44, 'planner'],
  [45, 'log'],
  [49, 'joystick'],
  [50, 'speech_recognition'],
  [51, 'opaque'],
  [52, 'position1d'],
  [53, 'actarray'],
  [54, 'limb'],
  [55, 'graphics2d'],
  [56, 'rfid'],
  [57, 'wsn'],
  [58, 'graphics3d'],
  [59, 'health'],
  [60, 'imu'],
  [61, 'pointcloud3d'],
  [62, 'ranger'],
  [63, 'vectormap'],
  [64, 'blackboard'],
  [65, 'stereo'],
  [66, 'coopobject'],
]);

const kCatalogue = new Map<number, AnyMessage>();

for (const module of [
  common,
  player,
  power,
  gripper,
  position2d,
  sonar,
  laser,
  blobfinder,
  ptz,
  audio,
  fiducial,
  speech,
  gps,
  bumper,
  dio,
  aio,
  ir,
  wifi,
  localize,
  position3d,
  simulation,
  blinkenlight,
  camera,
  map,
  planner,
  log,
  joystick,
  speech_recognition,
  opaque,
  position1d,
  actarray,
  limb,
  graphics2d,
  rfid,
  wsn,
  graphics3d,
  health,
  imu,
  pointcloud3d,
  ranger,
  vectormap,
  blackboard,
  stereo,
  coopobject,
]) {
  for (const row of Object.values(module)) {
    if (row instanceof MessageType) kCatalogue.set(keyOf(row.interface, row.kind, row.subtype), row);
  }
}

function keyOf(code: number, kind: number, subtype: number): number {
  return (code * 256 + kind) * 256 + subtype;
}

/**
 * The row of a message, or undefined. Answers have the row of their request; shared messages apply to every
 * interface.
 */
export function findMessage(code: number, kind: number, subtype: number): AnyMessage | undefined {
  const row = kind === Kind.ACK || kind === Kind.NACK ? Kind.REQ : kind;
  return kCatalogue.get(keyOf(0, row, subtype)) ?? kCatalogue.get(keyOf(code, row, subtype));
}
