/**
 * Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a store for
 * objects.
 *
 * Generated from interfaces/003_gripper.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 3;

// Values of Data.state.
export const STATE_OPEN = 1;
export const STATE_CLOSED = 2;
export const STATE_MOVING = 3;
export const STATE_ERROR = 4;

/** State of the fingers and of the break beams. (player_gripper_data_t) */
export interface Data {
  /** Open, closed, moving or faulty. */
  state: number;
  /** One bit per break beam, set if it is interrupted. */
  beams: number;
  /** Number of stored objects. */
  stored: number;
}

export const Data: Codec<Data> = new Codec<Data>('gripper.Data', {
  zero: () => ({ state: 0, beams: 0, stored: 0 }),
  write(to, value) {
    to.uint8(value.state);
    to.uint32(value.beams);
    to.uint8(value.stored);
  },
  read(from) {
    const state = from.uint8();
    const beams = from.uint32();
    const stored = from.uint8();
    return { state, beams, stored };
  },
});

/** The gripper's size and pose. (player_gripper_geom_t) */
export interface Geom {
  /** Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Around the fingers (in m, m, m). */
  outerSize: common.Bbox3d;
  /** Of the gap between the open fingers (in m, m, m). */
  innerSize: common.Bbox3d;
  /** Number of break beams. */
  numBeams: number;
  /** Capacity of the store, in objects. */
  capacity: number;
}

export const Geom: Codec<Geom> = new Codec<Geom>('gripper.Geom', {
  zero: () => ({
    pose: common.Pose3d.make(),
    outerSize: common.Bbox3d.make(),
    innerSize: common.Bbox3d.make(),
    numBeams: 0,
    capacity: 0,
  }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    common.Bbox3d.write(to, value.outerSize);
    common.Bbox3d.write(to, value.innerSize);
    to.uint8(value.numBeams);
    to.uint8(value.capacity);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const outerSize = common.Bbox3d.read(from);
    const innerSize = common.Bbox3d.read(from);
    const numBeams = from.uint8();
    const capacity = from.uint8();
    return { pose, outerSize, innerSize, numBeams, capacity };
  },
});

/** State of the fingers and of the break beams. */
export const DATA_STATE: MessageType<Data> = new MessageType(3, Kind.DATA, 1, 'gripper.data.state', Data);

/** Requests the gripper's size and pose. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(3, Kind.REQ, 1, 'gripper.req.get_geom', Geom);

/** Opens the fingers. */
export const CMD_OPEN: MessageType<undefined> = new MessageType(3, Kind.CMD, 1, 'gripper.cmd.open');

/** Closes the fingers. */
export const CMD_CLOSE: MessageType<undefined> = new MessageType(3, Kind.CMD, 2, 'gripper.cmd.close');

/** Stops the fingers at their current position. */
export const CMD_STOP: MessageType<undefined> = new MessageType(3, Kind.CMD, 3, 'gripper.cmd.stop');

/** Moves the held object into the store. */
export const CMD_STORE: MessageType<undefined> = new MessageType(3, Kind.CMD, 4, 'gripper.cmd.store');

/** Moves the object stored last between the fingers. */
export const CMD_RETRIEVE: MessageType<undefined> = new MessageType(3, Kind.CMD, 5, 'gripper.cmd.retrieve');
