/**
 * Interface position1d, code 52. A single prismatic or revolute actuator.
 *
 * Generated from interfaces/052_position1d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 52;

// Bits of Data.status, by number.
export const STATUS_LIMIT_MIN = 0;
export const STATUS_LIMIT_CEN = 1;
export const STATUS_LIMIT_MAX = 2;
export const STATUS_OC = 3;
export const STATUS_TRAJ_COMPLETE = 4;
export const STATUS_ENABLED = 5;

/** Position of the actuator. (player_position1d_data_t) */
export interface Data {
  /** From its zero (in m or rad). */
  pos: number;
  /** In m/s or rad/s. */
  vel: number;
  /** 1 if it is blocked by an obstacle. */
  stall: number;
  /** Limits, current, motion and power, one bit each. */
  status: number;
}

export const Data: Codec<Data> = new Codec<Data>('position1d.Data', {
  zero: () => ({ pos: 0, vel: 0, stall: 0, status: 0 }),
  write(to, value) {
    to.float32(value.pos);
    to.float32(value.vel);
    to.uint8(value.stall);
    to.uint8(value.status);
  },
  read(from) {
    const pos = from.float32();
    const vel = from.float32();
    const stall = from.uint8();
    const status = from.uint8();
    return { pos, vel, stall, status };
  },
});

/** Commanded velocity. (player_position1d_cmd_vel_t) */
export interface CmdVel {
  /** In m/s or rad/s. */
  vel: number;
  /** 1: motor on, 0: off. */
  state: number;
}

export const CmdVel: Codec<CmdVel> = new Codec<CmdVel>('position1d.CmdVel', {
  zero: () => ({ vel: 0, state: 0 }),
  write(to, value) {
    to.float32(value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const vel = from.float32();
    const state = from.uint8();
    return { vel, state };
  },
});

/** Commanded position. (player_position1d_cmd_pos_t) */
export interface CmdPos {
  /** From its zero (in m or rad). */
  pos: number;
  /** Velocity on the way; zero: chosen by the driver (in m/s or rad/s). */
  vel: number;
  /** 1: motor on, 0: off. */
  state: number;
}

export const CmdPos: Codec<CmdPos> = new Codec<CmdPos>('position1d.CmdPos', {
  zero: () => ({ pos: 0, vel: 0, state: 0 }),
  write(to, value) {
    to.float32(value.pos);
    to.float32(value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const pos = from.float32();
    const vel = from.float32();
    const state = from.uint8();
    return { pos, vel, state };
  },
});

/** Size and pose. (player_position1d_geom_t) */
export interface Geom {
  /** Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the actuator (in m, m, m). */
  size: common.Bbox3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('position1d.Geom', {
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

/** The motor's switch. (player_position1d_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('position1d.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** A velocity controller. (player_position1d_velocity_mode_config_t) */
export interface VelocityModeConfig {
  /** Driver-specific. */
  value: number;
}

export const VelocityModeConfig: Codec<VelocityModeConfig> = new Codec<VelocityModeConfig>('position1d.VelocityModeConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** Request to set the current position to zero. (player_position1d_reset_odom_config_t) */
export interface ResetOdomConfig {
  /** Without meaning. */
  value: number;
}

export const ResetOdomConfig: Codec<ResetOdomConfig> = new Codec<ResetOdomConfig>('position1d.ResetOdomConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** A control mode. (player_position1d_position_mode_req_t) */
export interface PositionModeReq {
  /** 0: velocity, 1: position. */
  state: number;
}

export const PositionModeReq: Codec<PositionModeReq> = new Codec<PositionModeReq>('position1d.PositionModeReq', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint32(value.state);
  },
  read(from) {
    const state = from.uint32();
    return { state };
  },
});

/** New value of the current position. (player_position1d_set_odom_req_t) */
export interface SetOdomReq {
  /** New value of the current position (in m or rad). */
  pos: number;
}

export const SetOdomReq: Codec<SetOdomReq> = new Codec<SetOdomReq>('position1d.SetOdomReq', {
  zero: () => ({ pos: 0 }),
  write(to, value) {
    to.float32(value.pos);
  },
  read(from) {
    const pos = from.float32();
    return { pos };
  },
});

/** Gains of velocity control. (player_position1d_speed_pid_req_t) */
export interface SpeedPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const SpeedPidReq: Codec<SpeedPidReq> = new Codec<SpeedPidReq>('position1d.SpeedPidReq', {
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

/** Gains of position control. (player_position1d_position_pid_req_t) */
export interface PositionPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const PositionPidReq: Codec<PositionPidReq> = new Codec<PositionPidReq>('position1d.PositionPidReq', {
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

/** Limits of position control. (player_position1d_speed_prof_req_t) */
export interface SpeedProfReq {
  /** Maximum speed (in m/s or rad/s). */
  speed: number;
  /** Maximum acceleration (in m/s^2 or rad/s^2). */
  acc: number;
}

export const SpeedProfReq: Codec<SpeedProfReq> = new Codec<SpeedProfReq>('position1d.SpeedProfReq', {
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

/** Requests size and pose. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(52, Kind.REQ, 1, 'position1d.req.get_geom', Geom);

/** Switches the motor on or off. */
export const REQ_MOTOR_POWER: MessageType<PowerConfig> = new MessageType(
  52,
  Kind.REQ,
  2,
  'position1d.req.motor_power',
  PowerConfig,
);

/** Selects the driver's velocity controller. */
export const REQ_VELOCITY_MODE: MessageType<VelocityModeConfig> = new MessageType(
  52,
  Kind.REQ,
  3,
  'position1d.req.velocity_mode',
  VelocityModeConfig,
);

/** Selects between velocity and position control. */
export const REQ_POSITION_MODE: MessageType<PositionModeReq> = new MessageType(
  52,
  Kind.REQ,
  4,
  'position1d.req.position_mode',
  PositionModeReq,
);

/** Sets the reference of the position. */
export const REQ_SET_ODOM: MessageType<SetOdomReq> = new MessageType(
  52,
  Kind.REQ,
  5,
  'position1d.req.set_odom',
  SetOdomReq,
);

/** Sets the current position to zero. */
export const REQ_RESET_ODOM: MessageType<ResetOdomConfig> = new MessageType(
  52,
  Kind.REQ,
  6,
  'position1d.req.reset_odom',
  ResetOdomConfig,
);

/** Sets the gains of velocity control. */
export const REQ_SPEED_PID: MessageType<SpeedPidReq> = new MessageType(
  52,
  Kind.REQ,
  7,
  'position1d.req.speed_pid',
  SpeedPidReq,
);

/** Sets the gains of position control. */
export const REQ_POSITION_PID: MessageType<PositionPidReq> = new MessageType(
  52,
  Kind.REQ,
  8,
  'position1d.req.position_pid',
  PositionPidReq,
);

/** Sets the speed and acceleration limits of position control. */
export const REQ_SPEED_PROF: MessageType<SpeedProfReq> = new MessageType(
  52,
  Kind.REQ,
  9,
  'position1d.req.speed_prof',
  SpeedProfReq,
);

/** Position of the actuator. */
export const DATA_STATE: MessageType<Data> = new MessageType(52, Kind.DATA, 1, 'position1d.data.state', Data);

/** Size and pose, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(52, Kind.DATA, 2, 'position1d.data.geom', Geom);

/** Commanded velocity. */
export const CMD_VEL: MessageType<CmdVel> = new MessageType(52, Kind.CMD, 1, 'position1d.cmd.vel', CmdVel);

/** Commanded position. */
export const CMD_POS: MessageType<CmdPos> = new MessageType(52, Kind.CMD, 2, 'position1d.cmd.pos', CmdPos);
