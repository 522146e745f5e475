/**
 * Interface position3d, code 30. A robot that moves in 3D.
 *
 * Generated from interfaces/030_position3d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 30;

/** Odometry. (player_position3d_data_t) */
export interface Data {
  /** Pose from odometry (in m, m, m, rad, rad, rad, frame X_OR). */
  pos: common.Pose3d;
  /** Velocity along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R). */
  vel: common.Pose3d;
  /** 1 if the robot is blocked by an obstacle. */
  stall: number;
}

export const Data: Codec<Data> = new Codec<Data>('position3d.Data', {
  zero: () => ({ pos: common.Pose3d.make(), vel: common.Pose3d.make(), stall: 0 }),
  write(to, value) {
    common.Pose3d.write(to, value.pos);
    common.Pose3d.write(to, value.vel);
    to.uint8(value.stall);
  },
  read(from) {
    const pos = common.Pose3d.read(from);
    const vel = common.Pose3d.read(from);
    const stall = from.uint8();
    return { pos, vel, stall };
  },
});

/** Commanded pose, and the velocity on the way. (player_position3d_cmd_pos_t) */
export interface CmdPos {
  /** Goal (in m, m, m, rad, rad, rad, frame X_OG). */
  pos: common.Pose3d;
  /** Velocity on the way; zero: chosen by the driver (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R). */
  vel: common.Pose3d;
  /** 1: motors on, 0: off. */
  state: number;
}

export const CmdPos: Codec<CmdPos> = new Codec<CmdPos>('position3d.CmdPos', {
  zero: () => ({ pos: common.Pose3d.make(), vel: common.Pose3d.make(), state: 0 }),
  write(to, value) {
    common.Pose3d.write(to, value.pos);
    common.Pose3d.write(to, value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const pos = common.Pose3d.read(from);
    const vel = common.Pose3d.read(from);
    const state = from.uint8();
    return { pos, vel, state };
  },
});

/** Commanded velocity. (player_position3d_cmd_vel_t) */
export interface CmdVel {
  /** Along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R). */
  vel: common.Pose3d;
  /** 1: motors on, 0: off. */
  state: number;
}

export const CmdVel: Codec<CmdVel> = new Codec<CmdVel>('position3d.CmdVel', {
  zero: () => ({ vel: common.Pose3d.make(), state: 0 }),
  write(to, value) {
    common.Pose3d.write(to, value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const vel = common.Pose3d.read(from);
    const state = from.uint8();
    return { vel, state };
  },
});

/** The robot's size and centre of rotation. (player_position3d_geom_t) */
export interface Geom {
  /** Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the robot (in m, m, m). */
  size: common.Bbox3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('position3d.Geom', {
  zero: () => ({ pose: common.Pose3d.make(), size: common.Bbox3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    common.Bbox3d.write(to, value.size);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const size = common.Bbox3d.read(from);
    return { pose, size };
  },
});

/** The motors' switch. (player_position3d_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('position3d.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** A control mode. (player_position3d_position_mode_req_t) */
export interface PositionModeReq {
  /** 0: velocity, 1: position. */
  value: number;
}

export const PositionModeReq: Codec<PositionModeReq> = new Codec<PositionModeReq>('position3d.PositionModeReq', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** A velocity controller. (player_position3d_velocity_mode_config_t) */
export interface VelocityModeConfig {
  /** Driver-specific. */
  value: number;
}

export const VelocityModeConfig: Codec<VelocityModeConfig> = new Codec<VelocityModeConfig>('position3d.VelocityModeConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** A new odometric pose. (player_position3d_set_odom_req_t) */
export interface SetOdomReq {
  /** New odometric pose (in m, m, m, rad, rad, rad, frame X_OR). */
  pos: common.Pose3d;
}

export const SetOdomReq: Codec<SetOdomReq> = new Codec<SetOdomReq>('position3d.SetOdomReq', {
  zero: () => ({ pos: common.Pose3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pos);
  },
  read(from) {
    const pos = common.Pose3d.read(from);
    return { pos };
  },
});

/** Gains of velocity control. (player_position3d_speed_pid_req_t) */
export interface SpeedPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const SpeedPidReq: Codec<SpeedPidReq> = new Codec<SpeedPidReq>('position3d.SpeedPidReq', {
  zero: () => ({ kp: 0, ki: 0, kd: 0 }),
  write(to, value) {
    to.float32(value.kp);
    to.float32(value.ki);
    to.float32(value.kd);
  },
  read(from) {
    const kp = from.float32();
    const ki = from.float32();
    const kd = from.float32();
    return { kp, ki, kd };
  },
});

/** Gains of position control. (player_position3d_position_pid_req_t) */
export interface PositionPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const PositionPidReq: Codec<PositionPidReq> = new Codec<PositionPidReq>('position3d.PositionPidReq', {
  zero: () => ({ kp: 0, ki: 0, kd: 0 }),
  write(to, value) {
    to.float32(value.kp);
    to.float32(value.ki);
    to.float32(value.kd);
  },
  read(from) {
    const kp = from.float32();
    const ki = from.float32();
    const kd = from.float32();
    return { kp, ki, kd };
  },
});

/** Limits of position control. (player_position3d_speed_prof_req_t) */
export interface SpeedProfReq {
  /** Maximum turn rate (in rad/s). */
  speed: number;
  /** Maximum angular acceleration (in rad/s^2). */
  acc: number;
}

export const SpeedProfReq: Codec<SpeedProfReq> = new Codec<SpeedProfReq>('position3d.SpeedProfReq', {
  zero: () => ({ speed: 0, acc: 0 }),
  write(to, value) {
    to.float32(value.speed);
    to.float32(value.acc);
  },
  read(from) {
    const speed = from.float32();
    const acc = from.float32();
    return { speed, acc };
  },
});

/** Odometry. */
export const DATA_STATE: MessageType<Data> = new MessageType(30, Kind.DATA, 1, 'position3d.data.state', Data);

/** The robot's size, sent on change. */
export const DATA_GEOMETRY: MessageType<Geom> = new MessageType(30, Kind.DATA, 2, 'position3d.data.geometry', Geom);

/** Commanded velocity. */
export const CMD_SET_VEL: MessageType<CmdVel> = new MessageType(30, Kind.CMD, 1, 'position3d.cmd.set_vel', CmdVel);

/** Commanded pose in the odometry frame. */
export const CMD_SET_POS: MessageType<CmdPos> = new MessageType(30, Kind.CMD, 2, 'position3d.cmd.set_pos', CmdPos);

/** Requests the robot's size and centre of rotation. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(30, Kind.REQ, 1, 'position3d.req.get_geom', Geom);

/** Switches the motors on or off. */
export const REQ_MOTOR_POWER: MessageType<PowerConfig> = new MessageType(
  30,
  Kind.REQ,
  2,
  'position3d.req.motor_power',
  PowerConfig,
);

/** Selects the driver's velocity controller. */
export const REQ_VELOCITY_MODE: MessageType<VelocityModeConfig> = new MessageType(
  30,
  Kind.REQ,
  3,
  'position3d.req.velocity_mode',
  VelocityModeConfig,
);

/** Selects between velocity and position control. */
export const REQ_POSITION_MODE: MessageType<PositionModeReq> = new MessageType(
  30,
  Kind.REQ,
  4,
  'position3d.req.position_mode',
  PositionModeReq,
);

/** Sets the odometric pose to zero. */
export const REQ_RESET_ODOM: MessageType<undefined> = new MessageType(30, Kind.REQ, 5, 'position3d.req.reset_odom');

/** Sets the odometric pose. */
export const REQ_SET_ODOM: MessageType<SetOdomReq> = new MessageType(
  30,
  Kind.REQ,
  6,
  'position3d.req.set_odom',
  SetOdomReq,
);

/** Sets the gains of velocity control. */
export const REQ_SPEED_PID: MessageType<SpeedPidReq> = new MessageType(
  30,
  Kind.REQ,
  7,
  'position3d.req.speed_pid',
  SpeedPidReq,
);

/** Sets the gains of position control. */
export const REQ_POSITION_PID: MessageType<PositionPidReq> = new MessageType(
  30,
  Kind.REQ,
  8,
  'position3d.req.position_pid',
  PositionPidReq,
);

/** Sets the turn rate and angular acceleration limits of position control. */
export const REQ_SPEED_PROF: MessageType<SpeedProfReq> = new MessageType(
  30,
  Kind.REQ,
  9,
  'position3d.req.speed_prof',
  SpeedProfReq,
);
