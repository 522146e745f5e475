/**
 * Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm.
 *
 * Generated from interfaces/053_actarray.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 53;

// Values of Actuator.state.
export const ACTSTATE_IDLE = 1;
export const ACTSTATE_MOVING = 2;
export const ACTSTATE_BRAKED = 4;
export const ACTSTATE_STALLED = 8;

// Values of Actuatorgeom.type.
export const TYPE_LINEAR = 1;
export const TYPE_ROTARY = 2;

/** State of one joint. (player_actarray_actuator_t) */
export interface Actuator {
  /** In m or rad. */
  position: number;
  /** In m/s or rad/s. */
  speed: number;
  /** In m/s^2 or rad/s^2. */
  acceleration: number;
  /** Of its motor; -1 if unknown (in A). */
  current: number;
  /** Idle, moving, braked or stalled. */
  state: number;
}

export const Actuator: Codec<Actuator> = new Codec<Actuator>('actarray.Actuator', {
  zero: () => ({ position: 0, speed: 0, acceleration: 0, current: 0, state: 0 }),
  write(to, value) {
    to.float32(value.position);
    to.float32(value.speed);
    to.float32(value.acceleration);
    to.float32(value.current);
    to.uint8(value.state);
  },
  read(from) {
    const position = from.float32();
    const speed = from.float32();
    const acceleration = from.float32();
    const current = from.float32();
    const state = from.uint8();
    return { position, speed, acceleration, current, state };
  },
});

/** State of each joint. (player_actarray_data_t) */
export interface Data {
  actuators: Actuator[];
  /** 1: motors on, 0: off. */
  motorState: number;
}

export const Data: Codec<Data> = new Codec<Data>('actarray.Data', {
  zero: () => ({ actuators: [], motorState: 0 }),
  write(to, value) {
    to.length('actuators', value.actuators.length, 1677719);
    to.length('actuators', value.actuators.length, 1677719);
    for (const each of value.actuators) Actuator.write(to, each);
    to.uint8(value.motorState);
  },
  read(from) {
    const actuatorsCount = from.uint32();
    const actuators = from.many(from.length('actuators', actuatorsCount, 20), () => Actuator.read(from));
    const motorState = from.uint8();
    return { actuators, motorState };
  },
});

/** Description of a joint. (player_actarray_actuatorgeom_t) */
export interface Actuatorgeom {
  /** Prismatic or revolute. */
  type: number;
  /** To the next joint (in m). */
  length: number;
  /** Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad, frame R_BJ). */
  orientation: common.Orientation3d;
  /** Unit vector of the axis of translation or rotation (frame n_J). */
  axis: common.Point3d;
  /** Lowest position (in m or rad). */
  min: number;
  /** Centre position (in m or rad). */
  centre: number;
  /** Highest position (in m or rad). */
  max: number;
  /** Position after CMD HOME (in m or rad). */
  home: number;
  /** Speed in position control (in m/s or rad/s). */
  configSpeed: number;
  /** 1 if it has brakes. */
  hasbrakes: number;
}

export const Actuatorgeom: Codec<Actuatorgeom> = new Codec<Actuatorgeom>('actarray.Actuatorgeom', {
  zero: () => ({
    type: 0,
    length: 0,
    orientation: common.Orientation3d.make(),
    axis: common.Point3d.make(),
    min: 0,
    centre: 0,
    max: 0,
    home: 0,
    configSpeed: 0,
    hasbrakes: 0,
  }),
  write(to, value) {
    to.uint8(value.type);
    to.float32(value.length);
    common.Orientation3d.write(to, value.orientation);
    common.Point3d.write(to, value.axis);
    to.float32(value.min);
    to.float32(value.centre);
    to.float32(value.max);
    to.float32(value.home);
    to.float32(value.configSpeed);
    to.uint8(value.hasbrakes);
  },
  read(from) {
    const type = from.uint8();
    const length = from.float32();
    const orientation = common.Orientation3d.read(from);
    const axis = common.Point3d.read(from);
    const min = from.float32();
    const centre = from.float32();
    const max = from.float32();
    const home = from.float32();
    const configSpeed = from.float32();
    const hasbrakes = from.uint8();
    return { type, length, orientation, axis, min, centre, max, home, configSpeed, hasbrakes };
  },
});

/** Joints and base pose of the chain. (player_actarray_geom_t) */
export interface Geom {
  actuators: Actuatorgeom[];
  /** Position of the base of the chain on the robot (in m, frame p_RB). */
  basePos: common.Point3d;
  /** Orientation of the base of the chain on the robot (in rad, frame R_RB). */
  baseOrientation: common.Orientation3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('actarray.Geom', {
  zero: () => ({ actuators: [], basePos: common.Point3d.make(), baseOrientation: common.Orientation3d.make() }),
  write(to, value) {
    to.length('actuators', value.actuators.length, 419429);
    to.length('actuators', value.actuators.length, 419429);
    for (const each of value.actuators) Actuatorgeom.write(to, each);
    common.Point3d.write(to, value.basePos);
    common.Orientation3d.write(to, value.baseOrientation);
  },
  read(from) {
    const actuatorsCount = from.uint32();
    const actuators = from.many(from.length('actuators', actuatorsCount, 80), () => Actuatorgeom.read(from));
    const basePos = common.Point3d.read(from);
    const baseOrientation = common.Orientation3d.read(from);
    return { actuators, basePos, baseOrientation };
  },
});

/** Commanded position of one joint. (player_actarray_position_cmd_t) */
export interface PositionCmd {
  /** Index of the joint, from 0. */
  joint: number;
  /** In m or rad. */
  position: number;
}

export const PositionCmd: Codec<PositionCmd> = new Codec<PositionCmd>('actarray.PositionCmd', {
  zero: () => ({ joint: 0, position: 0 }),
  write(to, value) {
    to.int32(value.joint);
    to.float32(value.position);
  },
  read(from) {
    const joint = from.int32();
    const position = from.float32();
    return { joint, position };
  },
});

/** Commanded positions of all joints. (player_actarray_multi_position_cmd_t) */
export interface MultiPositionCmd {
  /** In m or rad. */
  positions: Float32Array;
}

export const MultiPositionCmd: Codec<MultiPositionCmd> = new Codec<MultiPositionCmd>('actarray.MultiPositionCmd', {
  zero: () => ({ positions: new Float32Array() }),
  write(to, value) {
    to.length('positions', value.positions.length, 8388598);
    to.length('positions', value.positions.length, 8388598);
    to.float32s(value.positions);
  },
  read(from) {
    const positionsCount = from.uint32();
    const positions = from.float32s(from.length('positions', positionsCount, 4));
    return { positions };
  },
});

/** Commanded speed of one joint. (player_actarray_speed_cmd_t) */
export interface SpeedCmd {
  /** Index of the joint, from 0. */
  joint: number;
  /** In m/s or rad/s. */
  speed: number;
}

export const SpeedCmd: Codec<SpeedCmd> = new Codec<SpeedCmd>('actarray.SpeedCmd', {
  zero: () => ({ joint: 0, speed: 0 }),
  write(to, value) {
    to.int32(value.joint);
    to.float32(value.speed);
  },
  read(from) {
    const joint = from.int32();
    const speed = from.float32();
    return { joint, speed };
  },
});

/** Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t) */
export interface MultiSpeedCmd {
  /** In m/s or rad/s. */
  speeds: Float32Array;
}

export const MultiSpeedCmd: Codec<MultiSpeedCmd> = new Codec<MultiSpeedCmd>('actarray.MultiSpeedCmd', {
  zero: () => ({ speeds: new Float32Array() }),
  write(to, value) {
    to.length('speeds', value.speeds.length, 8388598);
    to.length('speeds', value.speeds.length, 8388598);
    to.float32s(value.speeds);
  },
  read(from) {
    const speedsCount = from.uint32();
    const speeds = from.float32s(from.length('speeds', speedsCount, 4));
    return { speeds };
  },
});

/** A joint to move to its home position. (player_actarray_home_cmd_t) */
export interface HomeCmd {
  /** Index of the joint; -1: all. */
  joint: number;
}

export const HomeCmd: Codec<HomeCmd> = new Codec<HomeCmd>('actarray.HomeCmd', {
  zero: () => ({ joint: 0 }),
  write(to, value) {
    to.int32(value.joint);
  },
  read(from) {
    const joint = from.int32();
    return { joint };
  },
});

/** Commanded current of one joint. (player_actarray_current_cmd_t) */
export interface CurrentCmd {
  /** Index of the joint, from 0. */
  joint: number;
  /** In A. */
  current: number;
}

export const CurrentCmd: Codec<CurrentCmd> = new Codec<CurrentCmd>('actarray.CurrentCmd', {
  zero: () => ({ joint: 0, current: 0 }),
  write(to, value) {
    to.int32(value.joint);
    to.float32(value.current);
  },
  read(from) {
    const joint = from.int32();
    const current = from.float32();
    return { joint, current };
  },
});

/** Commanded currents of all joints. (player_actarray_multi_current_cmd_t) */
export interface MultiCurrentCmd {
  /** In A. */
  currents: Float32Array;
}

export const MultiCurrentCmd: Codec<MultiCurrentCmd> = new Codec<MultiCurrentCmd>('actarray.MultiCurrentCmd', {
  zero: () => ({ currents: new Float32Array() }),
  write(to, value) {
    to.length('currents', value.currents.length, 8388598);
    to.length('currents', value.currents.length, 8388598);
    to.float32s(value.currents);
  },
  read(from) {
    const currentsCount = from.uint32();
    const currents = from.float32s(from.length('currents', currentsCount, 4));
    return { currents };
  },
});

/** The motors' switch. (player_actarray_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  value: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('actarray.PowerConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** The brakes' switch. (player_actarray_brakes_config_t) */
export interface BrakesConfig {
  /** 1: braked, 0: released. */
  value: number;
}

export const BrakesConfig: Codec<BrakesConfig> = new Codec<BrakesConfig>('actarray.BrakesConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** Speed of one joint. (player_actarray_speed_config_t) */
export interface SpeedConfig {
  /** Index of the joint; -1: all. */
  joint: number;
  /** In m/s or rad/s. */
  speed: number;
}

export const SpeedConfig: Codec<SpeedConfig> = new Codec<SpeedConfig>('actarray.SpeedConfig', {
  zero: () => ({ joint: 0, speed: 0 }),
  write(to, value) {
    to.int32(value.joint);
    to.float32(value.speed);
  },
  read(from) {
    const joint = from.int32();
    const speed = from.float32();
    return { joint, speed };
  },
});

/** Acceleration of one joint. (player_actarray_accel_config_t) */
export interface AccelConfig {
  /** Index of the joint; -1: all. */
  joint: number;
  /** In m/s^2 or rad/s^2. */
  accel: number;
}

export const AccelConfig: Codec<AccelConfig> = new Codec<AccelConfig>('actarray.AccelConfig', {
  zero: () => ({ joint: 0, accel: 0 }),
  write(to, value) {
    to.int32(value.joint);
    to.float32(value.accel);
  },
  read(from) {
    const joint = from.int32();
    const accel = from.float32();
    return { joint, accel };
  },
});

/** Switches the motors on or off. */
export const REQ_POWER: MessageType<PowerConfig> = new MessageType(53, Kind.REQ, 1, 'actarray.req.power', PowerConfig);

/** Sets or releases the brakes. */
export const REQ_BRAKES: MessageType<BrakesConfig> = new MessageType(
  53,
  Kind.REQ,
  2,
  'actarray.req.brakes',
  BrakesConfig,
);

/** Requests the joints and the base pose of the chain. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(53, Kind.REQ, 3, 'actarray.req.get_geom', Geom);

/** Sets a joint's speed in position control. */
export const REQ_SPEED: MessageType<SpeedConfig> = new MessageType(53, Kind.REQ, 4, 'actarray.req.speed', SpeedConfig);

/** Sets a joint's acceleration in position control. */
export const REQ_ACCEL: MessageType<AccelConfig> = new MessageType(53, Kind.REQ, 5, 'actarray.req.accel', AccelConfig);

/** Commanded position of one joint. */
export const CMD_POS: MessageType<PositionCmd> = new MessageType(53, Kind.CMD, 1, 'actarray.cmd.pos', PositionCmd);

/** Commanded positions of all joints. */
export const CMD_MULTI_POS: MessageType<MultiPositionCmd> = new MessageType(
  53,
  Kind.CMD,
  2,
  'actarray.cmd.multi_pos',
  MultiPositionCmd,
);

/** Commanded speed of one joint. */
export const CMD_SPEED: MessageType<SpeedCmd> = new MessageType(53, Kind.CMD, 3, 'actarray.cmd.speed', SpeedCmd);

/** Commanded speeds of all joints. */
export const CMD_MULTI_SPEED: MessageType<MultiSpeedCmd> = new MessageType(
  53,
  Kind.CMD,
  4,
  'actarray.cmd.multi_speed',
  MultiSpeedCmd,
);

/** Moves one joint, or all, to the home position. */
export const CMD_HOME: MessageType<HomeCmd> = new MessageType(53, Kind.CMD, 5, 'actarray.cmd.home', HomeCmd);

/** Commanded current of one joint. */
export const CMD_CURRENT: MessageType<CurrentCmd> = new MessageType(
  53,
  Kind.CMD,
  6,
  'actarray.cmd.current',
  CurrentCmd,
);

/** Commanded currents of all joints. */
export const CMD_MULTI_CURRENT: MessageType<MultiCurrentCmd> = new MessageType(
  53,
  Kind.CMD,
  7,
  'actarray.cmd.multi_current',
  MultiCurrentCmd,
);

/** State of each joint. */
export const DATA_STATE: MessageType<Data> = new MessageType(53, Kind.DATA, 1, 'actarray.data.state', Data);
