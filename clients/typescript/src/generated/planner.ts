/**
 * Interface planner, code 44. Plans and follows a path to a goal.
 *
 * Generated from interfaces/044_planner.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 44;

/** Progress of the robot along its path. (player_planner_data_t) */
export interface Data {
  /** 1 if there is a path to the goal. */
  valid: number;
  /** 1 if the goal is reached. */
  done: number;
  /** The robot (in m, m, rad, frame X_MR). */
  pos: common.Pose2d;
  /** The goal (in m, m, rad, frame X_MG). */
  goal: common.Pose2d;
  /** Current waypoint of the robot (in m, m, rad, frame X_MP). */
  waypoint: common.Pose2d;
  /** Index of that waypoint in the path; -1 if there is none. */
  waypointIdx: number;
  /** Number of waypoints of the path. */
  waypointsCount: number;
}

export const Data: Codec<Data> = new Codec<Data>('planner.Data', {
  zero: () => ({
    valid: 0,
    done: 0,
    pos: common.Pose2d.make(),
    goal: common.Pose2d.make(),
    waypoint: common.Pose2d.make(),
    waypointIdx: 0,
    waypointsCount: 0,
  }),
  write(to, value) {
    to.uint8(value.valid);
    to.uint8(value.done);
    common.Pose2d.write(to, value.pos);
    common.Pose2d.write(to, value.goal);
    common.Pose2d.write(to, value.waypoint);
    to.int32(value.waypointIdx);
    to.uint32(value.waypointsCount);
  },
  read(from) {
    const valid = from.uint8();
    const done = from.uint8();
    const pos = common.Pose2d.read(from);
    const goal = common.Pose2d.read(from);
    const waypoint = common.Pose2d.read(from);
    const waypointIdx = from.int32();
    const waypointsCount = from.uint32();
    return { valid, done, pos, goal, waypoint, waypointIdx, waypointsCount };
  },
});

/** A goal. (player_planner_cmd_t) */
export interface Cmd {
  /** Goal pose (in m, m, rad, frame X_MG). */
  goal: common.Pose2d;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('planner.Cmd', {
  zero: () => ({ goal: common.Pose2d.make() }),
  write(to, value) {
    common.Pose2d.write(to, value.goal);
  },
  read(from) {
    const goal = common.Pose2d.read(from);
    return { goal };
  },
});

/** The planned path. (player_planner_waypoints_req_t) */
export interface WaypointsReq {
  /** Length of the path (in m). */
  waypointsDistance: number;
  /** From the robot to the goal (in m, m, rad, frame X_MP). */
  waypoints: common.Pose2d[];
}

export const WaypointsReq: Codec<WaypointsReq> = new Codec<WaypointsReq>('planner.WaypointsReq', {
  zero: () => ({ waypointsDistance: 0, waypoints: [] }),
  write(to, value) {
    to.float64(value.waypointsDistance);
    to.length('waypoints', value.waypoints.length, 1398099);
    to.length('waypoints', value.waypoints.length, 1398099);
    for (const each of value.waypoints) common.Pose2d.write(to, each);
  },
  read(from) {
    const waypointsDistance = from.float64();
    const waypointsCount = from.uint32();
    const waypoints = from.many(from.length('waypoints', waypointsCount, 24), () => common.Pose2d.read(from));
    return { waypointsDistance, waypoints };
  },
});

/** The planner's switch. (player_planner_enable_req_t) */
export interface EnableReq {
  /** 1: may move, 0: stop. */
  state: number;
}

export const EnableReq: Codec<EnableReq> = new Codec<EnableReq>('planner.EnableReq', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Progress of the robot along its path. */
export const DATA_STATE: MessageType<Data> = new MessageType(44, Kind.DATA, 1, 'planner.data.state', Data);

/** Sets the goal. */
export const CMD_GOAL: MessageType<Cmd> = new MessageType(44, Kind.CMD, 1, 'planner.cmd.goal', Cmd);

/** Sets the goal and starts to move. */
export const CMD_START: MessageType<Cmd> = new MessageType(44, Kind.CMD, 2, 'planner.cmd.start', Cmd);

/** Requests the planned path. */
export const REQ_GET_WAYPOINTS: MessageType<WaypointsReq> = new MessageType(
  44,
  Kind.REQ,
  1,
  'planner.req.get_waypoints',
  WaypointsReq,
);

/** Enables or stops the robot. */
export const REQ_ENABLE: MessageType<EnableReq> = new MessageType(44, Kind.REQ, 2, 'planner.req.enable', EnableReq);
