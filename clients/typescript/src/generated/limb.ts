/**
 * Interface limb, code 54. An arm controlled by the pose of its end effector.
 *
 * Generated from interfaces/054_limb.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 54;

// Values of Data.state.
export const STATE_IDLE = 1;
export const STATE_BRAKED = 2;
export const STATE_MOVING = 3;
export const STATE_OOR = 4;
export const STATE_COLL = 5;

/** Pose of the end effector. (player_limb_data_t) */
export interface Data {
  /** In m, frame p_BE. */
  position: common.Point3d;
  /** Approach direction, a unit vector (frame n_B). */
  approach: common.Point3d;
  /** Unit vector across the end effector (frame n_B). */
  orientation: common.Point3d;
  /** Idle, braked, moving, out of reach or in contact. */
  state: number;
}

export const Data: Codec<Data> = new Codec<Data>('limb.Data', {
  zero: () => ({
    position: common.Point3d.make(),
    approach: common.Point3d.make(),
    orientation: common.Point3d.make(),
    state: 0,
  }),
  write(to, value) {
    common.Point3d.write(to, value.position);
    common.Point3d.write(to, value.approach);
    common.Point3d.write(to, value.orientation);
    to.uint8(value.state);
  },
  read(from) {
    const position = common.Point3d.read(from);
    const approach = common.Point3d.read(from);
    const orientation = common.Point3d.read(from);
    const state = from.uint8();
    return { position, approach, orientation, state };
  },
});

/** Commanded pose of the end effector. (player_limb_setpose_cmd_t) */
export interface SetposeCmd {
  /** In m, frame p_BE. */
  position: common.Point3d;
  /** Commanded approach direction, a unit vector (frame n_B). */
  approach: common.Point3d;
  /** Unit vector across the end effector (frame n_B). */
  orientation: common.Point3d;
}

export const SetposeCmd: Codec<SetposeCmd> = new Codec<SetposeCmd>('limb.SetposeCmd', {
  zero: () => ({
    position: common.Point3d.make(),
    approach: common.Point3d.make(),
    orientation: common.Point3d.make(),
  }),
  write(to, value) {
    common.Point3d.write(to, value.position);
    common.Point3d.write(to, value.approach);
    common.Point3d.write(to, value.orientation);
  },
  read(from) {
    const position = common.Point3d.read(from);
    const approach = common.Point3d.read(from);
    const orientation = common.Point3d.read(from);
    return { position, approach, orientation };
  },
});

/** Commanded position of the end effector. (player_limb_setposition_cmd_t) */
export interface SetpositionCmd {
  /** In m, frame p_BE. */
  position: common.Point3d;
}

export const SetpositionCmd: Codec<SetpositionCmd> = new Codec<SetpositionCmd>('limb.SetpositionCmd', {
  zero: () => ({ position: common.Point3d.make() }),
  write(to, value) {
    common.Point3d.write(to, value.position);
  },
  read(from) {
    const position = common.Point3d.read(from);
    return { position };
  },
});

/** A straight motion of the end effector. (player_limb_vecmove_cmd_t) */
export interface VecmoveCmd {
  /** Unit vector of the motion (frame n_B). */
  direction: common.Point3d;
  /** Distance (in m). */
  length: number;
}

export const VecmoveCmd: Codec<VecmoveCmd> = new Codec<VecmoveCmd>('limb.VecmoveCmd', {
  zero: () => ({ direction: common.Point3d.make(), length: 0 }),
  write(to, value) {
    common.Point3d.write(to, value.direction);
    to.float32(value.length);
  },
  read(from) {
    const direction = common.Point3d.read(from);
    const length = from.float32();
    return { direction, length };
  },
});

/** The motors' switch. (player_limb_power_req_t) */
export interface PowerReq {
  /** 1: on, 0: off. */
  value: number;
}

export const PowerReq: Codec<PowerReq> = new Codec<PowerReq>('limb.PowerReq', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** The brakes' switch. (player_limb_brakes_req_t) */
export interface BrakesReq {
  /** 1: braked, 0: released. */
  value: number;
}

export const BrakesReq: Codec<BrakesReq> = new Codec<BrakesReq>('limb.BrakesReq', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** Pose of the arm's base. (player_limb_geom_req_t) */
export interface GeomReq {
  /** Of the arm's base on the robot (in m, frame p_RB). */
  basePos: common.Point3d;
}

export const GeomReq: Codec<GeomReq> = new Codec<GeomReq>('limb.GeomReq', {
  zero: () => ({ basePos: common.Point3d.make() }),
  write(to, value) {
    common.Point3d.write(to, value.basePos);
  },
  read(from) {
    const basePos = common.Point3d.read(from);
    return { basePos };
  },
});

/** Speed of the end effector. (player_limb_speed_req_t) */
export interface SpeedReq {
  /** Maximum speed of the end effector (in m/s). */
  speed: number;
}

export const SpeedReq: Codec<SpeedReq> = new Codec<SpeedReq>('limb.SpeedReq', {
  zero: () => ({ speed: 0 }),
  write(to, value) {
    to.float32(value.speed);
  },
  read(from) {
    const speed = from.float32();
    return { speed };
  },
});

/** Pose of the end effector. */
export const DATA_STATE: MessageType<Data> = new MessageType(54, Kind.DATA, 1, 'limb.data.state', Data);

/** Moves the arm to its home position. */
export const CMD_HOME: MessageType<undefined> = new MessageType(54, Kind.CMD, 1, 'limb.cmd.home');

/** Stops the arm at its current position. */
export const CMD_STOP: MessageType<undefined> = new MessageType(54, Kind.CMD, 2, 'limb.cmd.stop');

/** Moves the end effector to a pose. */
export const CMD_SETPOSE: MessageType<SetposeCmd> = new MessageType(54, Kind.CMD, 3, 'limb.cmd.setpose', SetposeCmd);

/** Moves the end effector to a position, in any orientation. */
export const CMD_SETPOSITION: MessageType<SetpositionCmd> = new MessageType(
  54,
  Kind.CMD,
  4,
  'limb.cmd.setposition',
  SetpositionCmd,
);

/** Moves the end effector along a line from its current position. */
export const CMD_VECMOVE: MessageType<VecmoveCmd> = new MessageType(54, Kind.CMD, 5, 'limb.cmd.vecmove', VecmoveCmd);

/** Switches the motors on or off. */
export const REQ_POWER: MessageType<PowerReq> = new MessageType(54, Kind.REQ, 1, 'limb.req.power', PowerReq);

/** Sets or releases the brakes. */
export const REQ_BRAKES: MessageType<BrakesReq> = new MessageType(54, Kind.REQ, 2, 'limb.req.brakes', BrakesReq);

/** Requests the pose of the arm's base on the robot. */
export const REQ_GEOM: MessageType<GeomReq> = new MessageType(54, Kind.REQ, 3, 'limb.req.geom', GeomReq);

/** Sets the speed of the end effector. */
export const REQ_SPEED: MessageType<SpeedReq> = new MessageType(54, Kind.REQ, 4, 'limb.req.speed', SpeedReq);
