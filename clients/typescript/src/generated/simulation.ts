/**
 * Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it.
 *
 * Generated from interfaces/031_simulation.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 31;

/** Not sent by any message. (player_simulation_data_t) */
export interface Data {
  /** Without meaning. */
  data: number;
}

export const Data: Codec<Data> = new Codec<Data>('simulation.Data', {
  zero: () => ({ data: 0 }),
  write(to, value) {
    to.uint8(value.data);
  },
  read(from) {
    const data = from.uint8();
    return { data };
  },
});

/** Not sent by any message. (player_simulation_cmd_t) */
export interface Cmd {
  /** Without meaning. */
  cmd: number;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('simulation.Cmd', {
  zero: () => ({ cmd: 0 }),
  write(to, value) {
    to.uint8(value.cmd);
  },
  read(from) {
    const cmd = from.uint8();
    return { cmd };
  },
});

/** A model and its pose. (player_simulation_pose2d_req_t) */
export interface Pose2dReq {
  /** Of the model, NUL-terminated. */
  name: Uint8Array;
  /**
   * Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, rad, frame
   * X_PT).
   */
  pose: common.Pose2d;
}

export const Pose2dReq: Codec<Pose2dReq> = new Codec<Pose2dReq>('simulation.Pose2dReq', {
  zero: () => ({ name: new Uint8Array(), pose: common.Pose2d.make() }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    common.Pose2d.write(to, value.pose);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const pose = common.Pose2d.read(from);
    return { name, pose };
  },
});

/** A model, its pose and the time. (player_simulation_pose3d_req_t) */
export interface Pose3dReq {
  /** Of the model, NUL-terminated. */
  name: Uint8Array;
  /**
   * Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, m, rad, rad,
   * rad, frame X_PT).
   */
  pose: common.Pose3d;
  /** Simulated time of the pose, as counted by Stage; set in answers only (in us). */
  simtime: number;
}

export const Pose3dReq: Codec<Pose3dReq> = new Codec<Pose3dReq>('simulation.Pose3dReq', {
  zero: () => ({ name: new Uint8Array(), pose: common.Pose3d.make(), simtime: 0 }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    common.Pose3d.write(to, value.pose);
    to.float64(value.simtime);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const pose = common.Pose3d.read(from);
    const simtime = from.float64();
    return { name, pose, simtime };
  },
});

/** A property of a model. (player_simulation_property_req_t) */
export interface PropertyReq {
  /** Name of the model, NUL-terminated; empty for a property of the world. */
  name: Uint8Array;
  /** Name of the property, NUL-terminated. */
  prop: Uint8Array;
  /**
   * Element of a list property: in a request the first one requested, in an answer the first of the next request, 0 at
   * the end of the list.
   */
  index: number;
  /** Bytes of the property, in a simulator-specific format; empty in a request. */
  value: Uint8Array;
}

export const PropertyReq: Codec<PropertyReq> = new Codec<PropertyReq>('simulation.PropertyReq', {
  zero: () => ({ name: new Uint8Array(), prop: new Uint8Array(), index: 0, value: new Uint8Array() }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    to.length('prop', value.prop.length, 33554392);
    to.length('prop', value.prop.length, 33554392);
    to.opaque(value.prop);
    to.uint32(value.index);
    to.length('value', value.value.length, 33554392);
    to.length('value', value.value.length, 33554392);
    to.opaque(value.value);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const propCount = from.uint32();
    const prop = from.opaque(from.length('prop', propCount, 1));
    const index = from.uint32();
    const valueCount = from.uint32();
    const value = from.opaque(from.length('value', valueCount, 1));
    return { name, prop, index, value };
  },
});

/** Requests the pose of a model by name. */
export const REQ_GET_POSE2D: MessageType<Pose2dReq> = new MessageType(
  31,
  Kind.REQ,
  1,
  'simulation.req.get_pose2d',
  Pose2dReq,
);

/** Moves a model by name. */
export const REQ_SET_POSE2D: MessageType<Pose2dReq> = new MessageType(
  31,
  Kind.REQ,
  2,
  'simulation.req.set_pose2d',
  Pose2dReq,
);

/** Requests the pose of a model by name, and the time. */
export const REQ_GET_POSE3D: MessageType<Pose3dReq> = new MessageType(
  31,
  Kind.REQ,
  3,
  'simulation.req.get_pose3d',
  Pose3dReq,
);

/** Moves a model by name. */
export const REQ_SET_POSE3D: MessageType<Pose3dReq> = new MessageType(
  31,
  Kind.REQ,
  4,
  'simulation.req.set_pose3d',
  Pose3dReq,
);

/**
 * Requests a property of a model by name; without a name, for "models", the list of all with their devices
 * (docs/drivers.md).
 */
export const REQ_GET_PROPERTY: MessageType<PropertyReq> = new MessageType(
  31,
  Kind.REQ,
  5,
  'simulation.req.get_property',
  PropertyReq,
);

/** Sets a property of a model by name. */
export const REQ_SET_PROPERTY: MessageType<PropertyReq> = new MessageType(
  31,
  Kind.REQ,
  6,
  'simulation.req.set_property',
  PropertyReq,
);

/** Pauses or resumes the simulated clock. */
export const CMD_PAUSE: MessageType<undefined> = new MessageType(31, Kind.CMD, 1, 'simulation.cmd.pause');

/** Resets the world to its start. */
export const CMD_RESET: MessageType<undefined> = new MessageType(31, Kind.CMD, 2, 'simulation.cmd.reset');

/** Saves the current world. */
export const CMD_SAVE: MessageType<undefined> = new MessageType(31, Kind.CMD, 3, 'simulation.cmd.save');
