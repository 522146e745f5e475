/**
 * Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control.
 *
 * Generated from interfaces/004_position2d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 4;

/** Odometry. (player_position2d_data_t) */
export interface Data {
  /** Pose from odometry (in m, m, rad, frame X_OR). */
  pos: common.Pose2d;
  /** Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R). */
  vel: common.Pose2d;
  /** 1 if the robot is blocked by an obstacle. */
  stall: number;
}

export const Data: Codec<Data> = new Codec<Data>('position2d.Data', {
  zero: () => ({ pos: common.Pose2d.make(), vel: common.Pose2d.make(), stall: 0 }),
  write(to, value) {
    common.Pose2d.write(to, value.pos);
    common.Pose2d.write(to, value.vel);
    to.uint8(value.stall);
  },
  read(from) {
    const pos = common.Pose2d.read(from);
    const vel = common.Pose2d.read(from);
    const stall = from.uint8();
    return { pos, vel, stall };
  },
});

/** Commanded velocity. (player_position2d_cmd_vel_t) */
export interface CmdVel {
  /**
   * Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad (in m/s, m/s,
   * rad/s, frame v_OR_R).
   */
  vel: common.Pose2d;
  /** 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER. */
  state: number;
}

export const CmdVel: Codec<CmdVel> = new Codec<CmdVel>('position2d.CmdVel', {
  zero: () => ({ vel: common.Pose2d.make(), state: 0 }),
  write(to, value) {
    common.Pose2d.write(to, value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const vel = common.Pose2d.read(from);
    const state = from.uint8();
    return { vel, state };
  },
});

/** Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t) */
export interface CmdPos {
  /** Goal (in m, m, rad, frame X_OG). */
  pos: common.Pose2d;
  /** Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s, rad/s, frame v_OR_R). */
  vel: common.Pose2d;
  /** 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER. */
  state: number;
}

export const CmdPos: Codec<CmdPos> = new Codec<CmdPos>('position2d.CmdPos', {
  zero: () => ({ pos: common.Pose2d.make(), vel: common.Pose2d.make(), state: 0 }),
  write(to, value) {
    common.Pose2d.write(to, value.pos);
    common.Pose2d.write(to, value.vel);
    to.uint8(value.state);
  },
  read(from) {
    const pos = common.Pose2d.read(from);
    const vel = common.Pose2d.read(from);
    const state = from.uint8();
    return { pos, vel, state };
  },
});

/** Commanded motion of a car. (player_position2d_cmd_car_t) */
export interface CmdCar {
  /** Forward (in m/s). */
  velocity: number;
  /**
   * Steering angle of the front wheels, positive to the left; a simulated robot without them uses it as turn rate in
   * rad/s (in rad).
   */
  angle: number;
}

export const CmdCar: Codec<CmdCar> = new Codec<CmdCar>('position2d.CmdCar', {
  zero: () => ({ velocity: 0, angle: 0 }),
  write(to, value) {
    to.float64(value.velocity);
    to.float64(value.angle);
  },
  read(from) {
    const velocity = from.float64();
    const angle = from.float64();
    return { velocity, angle };
  },
});

/** Commanded speed and heading. (player_position2d_cmd_vel_head_t) */
export interface CmdVelHead {
  /** Forward (in m/s). */
  velocity: number;
  /** Heading in the odometry frame (in rad). */
  angle: number;
}

export const CmdVelHead: Codec<CmdVelHead> = new Codec<CmdVelHead>('position2d.CmdVelHead', {
  zero: () => ({ velocity: 0, angle: 0 }),
  write(to, value) {
    to.float64(value.velocity);
    to.float64(value.angle);
  },
  read(from) {
    const velocity = from.float64();
    const angle = from.float64();
    return { velocity, angle };
  },
});

/** The robot's size and centre of rotation. (player_position2d_geom_t) */
export interface Geom {
  /** Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the robot (in m, m, m). */
  size: common.Bbox3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('position2d.Geom', {
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

/** The motors' switch. (player_position2d_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('position2d.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** A velocity controller. (player_position2d_velocity_mode_config_t) */
export interface VelocityModeConfig {
  /** Driver-specific. */
  value: number;
}

export const VelocityModeConfig: Codec<VelocityModeConfig> = new Codec<VelocityModeConfig>('position2d.VelocityModeConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** A control mode. (player_position2d_position_mode_req_t) */
export interface PositionModeReq {
  /** 0: velocity, 1: position. */
  state: number;
}

export const PositionModeReq: Codec<PositionModeReq> = new Codec<PositionModeReq>('position2d.PositionModeReq', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint32(value.state);
  },
  read(from) {
    const state = from.uint32();
    return { state };
  },
});

/** A new odometric pose. (player_position2d_set_odom_req_t) */
export interface SetOdomReq {
  /** New odometric pose (in m, m, rad, frame X_OR). */
  pose: common.Pose2d;
}

export const SetOdomReq: Codec<SetOdomReq> = new Codec<SetOdomReq>('position2d.SetOdomReq', {
  zero: () => ({ pose: common.Pose2d.make() }),
  write(to, value) {
    common.Pose2d.write(to, value.pose);
  },
  read(from) {
    const pose = common.Pose2d.read(from);
    return { pose };
  },
});

/** Gains of velocity control. (player_position2d_speed_pid_req_t) */
export interface SpeedPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const SpeedPidReq: Codec<SpeedPidReq> = new Codec<SpeedPidReq>('position2d.SpeedPidReq', {
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

/** Gains of position control. (player_position2d_position_pid_req_t) */
export interface PositionPidReq {
  /** Proportional. */
  kp: number;
  /** Integral. */
  ki: number;
  /** Derivative. */
  kd: number;
}

export const PositionPidReq: Codec<PositionPidReq> = new Codec<PositionPidReq>('position2d.PositionPidReq', {
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

/** Limits of position control. (player_position2d_speed_prof_req_t) */
export interface SpeedProfReq {
  /** Maximum speed (in m/s). */
  speed: number;
  /** Maximum acceleration (in m/s^2). */
  acc: number;
}

export const SpeedProfReq: Codec<SpeedProfReq> = new Codec<SpeedProfReq>('position2d.SpeedProfReq', {
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

/** Requests the robot's size and centre of rotation. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(4, Kind.REQ, 1, 'position2d.req.get_geom', Geom);

/** Switches the motors on or off. */
export const REQ_MOTOR_POWER: MessageType<PowerConfig> = new MessageType(
  4,
  Kind.REQ,
  2,
  'position2d.req.motor_power',
  PowerConfig,
);

/** Selects the driver's velocity controller. */
export const REQ_VELOCITY_MODE: MessageType<VelocityModeConfig> = new MessageType(
  4,
  Kind.REQ,
  3,
  'position2d.req.velocity_mode',
  VelocityModeConfig,
);

/** Selects between velocity and position control. */
export const REQ_POSITION_MODE: MessageType<PositionModeReq> = new MessageType(
  4,
  Kind.REQ,
  4,
  'position2d.req.position_mode',
  PositionModeReq,
);

/** Sets the odometric pose. */
export const REQ_SET_ODOM: MessageType<SetOdomReq> = new MessageType(
  4,
  Kind.REQ,
  5,
  'position2d.req.set_odom',
  SetOdomReq,
);

/** Sets the odometric pose to zero. */
export const REQ_RESET_ODOM: MessageType<undefined> = new MessageType(4, Kind.REQ, 6, 'position2d.req.reset_odom');

/** Sets the gains of velocity control. */
export const REQ_SPEED_PID: MessageType<SpeedPidReq> = new MessageType(
  4,
  Kind.REQ,
  7,
  'position2d.req.speed_pid',
  SpeedPidReq,
);

/** Sets the gains of position control. */
export const REQ_POSITION_PID: MessageType<PositionPidReq> = new MessageType(
  4,
  Kind.REQ,
  8,
  'position2d.req.position_pid',
  PositionPidReq,
);

/** Sets the speed and acceleration limits of position control. */
export const REQ_SPEED_PROF: MessageType<SpeedProfReq> = new MessageType(
  4,
  Kind.REQ,
  9,
  'position2d.req.speed_prof',
  SpeedProfReq,
);

/** Odometry. */
export const DATA_STATE: MessageType<Data> = new MessageType(4, Kind.DATA, 1, 'position2d.data.state', Data);

/** The robot's size, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(4, Kind.DATA, 2, 'position2d.data.geom', Geom);

/** Commanded velocity. */
export const CMD_VEL: MessageType<CmdVel> = new MessageType(4, Kind.CMD, 1, 'position2d.cmd.vel', CmdVel);

/** Commanded pose in the odometry frame. */
export const CMD_POS: MessageType<CmdPos> = new MessageType(4, Kind.CMD, 2, 'position2d.cmd.pos', CmdPos);

/** Commanded speed and steering angle of a car. */
export const CMD_CAR: MessageType<CmdCar> = new MessageType(4, Kind.CMD, 3, 'position2d.cmd.car', CmdCar);

/** Commanded speed and heading. */
export const CMD_VEL_HEAD: MessageType<CmdVelHead> = new MessageType(
  4,
  Kind.CMD,
  4,
  'position2d.cmd.vel_head',
  CmdVelHead,
);
