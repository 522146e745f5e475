/**
 * Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface.
 *
 * Generated from interfaces/022_ir.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 22;

/** Measurements of the sensors. (player_ir_data_t) */
export interface Data {
  /** One per sensor, as measured (in V). */
  voltages: Float32Array;
  /** One per sensor, computed from the voltage (in m). */
  ranges: Float32Array;
}

export const Data: Codec<Data> = new Codec<Data>('ir.Data', {
  zero: () => ({ voltages: new Float32Array(), ranges: new Float32Array() }),
  write(to, value) {
    to.length('voltages', value.voltages.length, 8388598);
    to.length('voltages', value.voltages.length, 8388598);
    to.float32s(value.voltages);
    to.length('ranges', value.ranges.length, 8388598);
    to.length('ranges', value.ranges.length, 8388598);
    to.float32s(value.ranges);
  },
  read(from) {
    const voltagesCount = from.uint32();
    const voltages = from.float32s(from.length('voltages', voltagesCount, 4));
    const rangesCount = from.uint32();
    const ranges = from.float32s(from.length('ranges', rangesCount, 4));
    return { voltages, ranges };
  },
});

/** Poses of the sensors. (player_ir_pose_t) */
export interface Pose {
  /** One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS). */
  poses: common.Pose3d[];
}

export const Pose: Codec<Pose> = new Codec<Pose>('ir.Pose', {
  zero: () => ({ poses: [] }),
  write(to, value) {
    to.length('poses', value.poses.length, 699049);
    to.length('poses', value.poses.length, 699049);
    for (const each of value.poses) common.Pose3d.write(to, each);
  },
  read(from) {
    const posesCount = from.uint32();
    const poses = from.many(from.length('poses', posesCount, 48), () => common.Pose3d.read(from));
    return { poses };
  },
});

/** The sensors' switch. (player_ir_power_req_t) */
export interface PowerReq {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerReq: Codec<PowerReq> = new Codec<PowerReq>('ir.PowerReq', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Requests the poses of the sensors. */
export const REQ_POSE: MessageType<Pose> = new MessageType(22, Kind.REQ, 1, 'ir.req.pose', Pose);

/** Switches the sensors on or off. */
export const REQ_POWER: MessageType<PowerReq> = new MessageType(22, Kind.REQ, 2, 'ir.req.power', PowerReq);

/** Voltages and ranges. */
export const DATA_RANGES: MessageType<Data> = new MessageType(22, Kind.DATA, 1, 'ir.data.ranges', Data);
