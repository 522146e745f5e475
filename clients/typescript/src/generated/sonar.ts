/**
 * Interface sonar, code 5. An array of sonars. New drivers use the ranger interface.
 *
 * Generated from interfaces/005_sonar.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 5;

/** One range per sonar. (player_sonar_data_t) */
export interface Data {
  /** Range of the nearest echo, in the order of the geometry (in m). */
  ranges: Float32Array;
}

export const Data: Codec<Data> = new Codec<Data>('sonar.Data', {
  zero: () => ({ ranges: new Float32Array() }),
  write(to, value) {
    to.length('ranges', value.ranges.length, 8388598);
    to.length('ranges', value.ranges.length, 8388598);
    to.float32s(value.ranges);
  },
  read(from) {
    const rangesCount = from.uint32();
    const ranges = from.float32s(from.length('ranges', rangesCount, 4));
    return { ranges };
  },
});

/** Poses of the sonars. (player_sonar_geom_t) */
export interface Geom {
  /** One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS). */
  poses: common.Pose3d[];
}

export const Geom: Codec<Geom> = new Codec<Geom>('sonar.Geom', {
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

/** The sonars' switch. (player_sonar_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('sonar.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Requests the poses of the sonars. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(5, Kind.REQ, 1, 'sonar.req.get_geom', Geom);

/** Switches the sonars on or off. */
export const REQ_POWER: MessageType<PowerConfig> = new MessageType(5, Kind.REQ, 2, 'sonar.req.power', PowerConfig);

/** One range per sonar. */
export const DATA_RANGES: MessageType<Data> = new MessageType(5, Kind.DATA, 1, 'sonar.data.ranges', Data);

/** Poses of the sonars, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(5, Kind.DATA, 2, 'sonar.data.geom', Geom);
