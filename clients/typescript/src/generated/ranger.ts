/**
 * Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays.
 *
 * Generated from interfaces/062_ranger.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 62;

/** Angles, ranges and rate. (player_ranger_config_t) */
export interface Config {
  /** Of the first beam, counter-clockwise from x (in rad). */
  minAngle: number;
  /** Of the last beam (in rad). */
  maxAngle: number;
  /** Angle between neighbouring beams (in rad). */
  angularRes: number;
  /** Minimum range (in m). */
  minRange: number;
  /** Maximum range, and reported range of a beam without a hit (in m). */
  maxRange: number;
  /** Range resolution (in m). */
  rangeRes: number;
  /** Scans per second (in Hz). */
  frequency: number;
}

export const Config: Codec<Config> = new Codec<Config>('ranger.Config', {
  zero: () => ({ minAngle: 0, maxAngle: 0, angularRes: 0, minRange: 0, maxRange: 0, rangeRes: 0, frequency: 0 }),
  write(to, value) {
    to.float64(value.minAngle);
    to.float64(value.maxAngle);
    to.float64(value.angularRes);
    to.float64(value.minRange);
    to.float64(value.maxRange);
    to.float64(value.rangeRes);
    to.float64(value.frequency);
  },
  read(from) {
    const minAngle = from.float64();
    const maxAngle = from.float64();
    const angularRes = from.float64();
    const minRange = from.float64();
    const maxRange = from.float64();
    const rangeRes = from.float64();
    const frequency = from.float64();
    return { minAngle, maxAngle, angularRes, minRange, maxRange, rangeRes, frequency };
  },
});

/** Size and pose of the device and its elements. (player_ranger_geom_t) */
export interface Geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the device (in m, m, m). */
  size: common.Bbox3d;
  /** One per element; x points along its beam, or along the middle of its scan (in m, m, m, rad, rad, rad, frame X_SE). */
  elementPoses: common.Pose3d[];
  /** One per element (in m, m, m). */
  elementSizes: common.Bbox3d[];
}

export const Geom: Codec<Geom> = new Codec<Geom>('ranger.Geom', {
  zero: () => ({ pose: common.Pose3d.make(), size: common.Bbox3d.make(), elementPoses: [], elementSizes: [] }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    common.Bbox3d.write(to, value.size);
    to.length('element_poses', value.elementPoses.length, 699049);
    to.length('element_poses', value.elementPoses.length, 699049);
    for (const each of value.elementPoses) common.Pose3d.write(to, each);
    to.length('element_sizes', value.elementSizes.length, 1398099);
    to.length('element_sizes', value.elementSizes.length, 1398099);
    for (const each of value.elementSizes) common.Bbox3d.write(to, each);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const size = common.Bbox3d.read(from);
    const elementPosesCount = from.uint32();
    const elementPoses = from.many(from.length('element_poses', elementPosesCount, 48), () => common.Pose3d.read(from));
    const elementSizesCount = from.uint32();
    const elementSizes = from.many(from.length('element_sizes', elementSizesCount, 24), () => common.Bbox3d.read(from));
    return { pose, size, elementPoses, elementSizes };
  },
});

/** Ranges. (player_ranger_data_range_t) */
export interface DataRange {
  /** Beam by beam from right to left, element by element (in m). */
  ranges: Float64Array;
}

export const DataRange: Codec<DataRange> = new Codec<DataRange>('ranger.DataRange', {
  zero: () => ({ ranges: new Float64Array() }),
  write(to, value) {
    to.length('ranges', value.ranges.length, 4194299);
    to.length('ranges', value.ranges.length, 4194299);
    to.float64s(value.ranges);
  },
  read(from) {
    const rangesCount = from.uint32();
    const ranges = from.float64s(from.length('ranges', rangesCount, 8));
    return { ranges };
  },
});

/** Ranges with geometry and configuration. (player_ranger_data_rangestamped_t) */
export interface DataRangestamped {
  data: DataRange;
  /** 1 if `geom` is valid. */
  haveGeom: number;
  geom: Geom;
  /** 1 if `config` is valid. */
  haveConfig: number;
  config: Config;
}

export const DataRangestamped: Codec<DataRangestamped> = new Codec<DataRangestamped>('ranger.DataRangestamped', {
  zero: () => ({ data: DataRange.make(), haveGeom: 0, geom: Geom.make(), haveConfig: 0, config: Config.make() }),
  write(to, value) {
    DataRange.write(to, value.data);
    to.uint8(value.haveGeom);
    Geom.write(to, value.geom);
    to.uint8(value.haveConfig);
    Config.write(to, value.config);
  },
  read(from) {
    const data = DataRange.read(from);
    const haveGeom = from.uint8();
    const geom = Geom.read(from);
    const haveConfig = from.uint8();
    const config = Config.read(from);
    return { data, haveGeom, geom, haveConfig, config };
  },
});

/** Intensities. (player_ranger_data_intns_t) */
export interface DataIntns {
  /** In the order of the ranges; driver-specific scale. */
  intensities: Float64Array;
}

export const DataIntns: Codec<DataIntns> = new Codec<DataIntns>('ranger.DataIntns', {
  zero: () => ({ intensities: new Float64Array() }),
  write(to, value) {
    to.length('intensities', value.intensities.length, 4194299);
    to.length('intensities', value.intensities.length, 4194299);
    to.float64s(value.intensities);
  },
  read(from) {
    const intensitiesCount = from.uint32();
    const intensities = from.float64s(from.length('intensities', intensitiesCount, 8));
    return { intensities };
  },
});

/** Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t) */
export interface DataIntnsstamped {
  data: DataIntns;
  /** 1 if `geom` is valid. */
  haveGeom: number;
  geom: Geom;
  /** 1 if `config` is valid. */
  haveConfig: number;
  config: Config;
}

export const DataIntnsstamped: Codec<DataIntnsstamped> = new Codec<DataIntnsstamped>('ranger.DataIntnsstamped', {
  zero: () => ({ data: DataIntns.make(), haveGeom: 0, geom: Geom.make(), haveConfig: 0, config: Config.make() }),
  write(to, value) {
    DataIntns.write(to, value.data);
    to.uint8(value.haveGeom);
    Geom.write(to, value.geom);
    to.uint8(value.haveConfig);
    Config.write(to, value.config);
  },
  read(from) {
    const data = DataIntns.read(from);
    const haveGeom = from.uint8();
    const geom = Geom.read(from);
    const haveConfig = from.uint8();
    const config = Config.read(from);
    return { data, haveGeom, geom, haveConfig, config };
  },
});

/** The device's switch. (player_ranger_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('ranger.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** The switch of intensities. (player_ranger_intns_config_t) */
export interface IntnsConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const IntnsConfig: Codec<IntnsConfig> = new Codec<IntnsConfig>('ranger.IntnsConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Ranges. */
export const DATA_RANGE: MessageType<DataRange> = new MessageType(62, Kind.DATA, 1, 'ranger.data.range', DataRange);

/** Ranges with the geometry and configuration of the measurement. */
export const DATA_RANGESTAMPED: MessageType<DataRangestamped> = new MessageType(
  62,
  Kind.DATA,
  2,
  'ranger.data.rangestamped',
  DataRangestamped,
);

/** Intensities. */
export const DATA_INTNS: MessageType<DataIntns> = new MessageType(62, Kind.DATA, 3, 'ranger.data.intns', DataIntns);

/** Intensities with the geometry and configuration of the measurement. */
export const DATA_INTNSSTAMPED: MessageType<DataIntnsstamped> = new MessageType(
  62,
  Kind.DATA,
  4,
  'ranger.data.intnsstamped',
  DataIntnsstamped,
);

/** Size and pose, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(62, Kind.DATA, 5, 'ranger.data.geom', Geom);

/** Requests size and pose. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(62, Kind.REQ, 1, 'ranger.req.get_geom', Geom);

/** Switches the device on or off. */
export const REQ_POWER: MessageType<PowerConfig> = new MessageType(62, Kind.REQ, 2, 'ranger.req.power', PowerConfig);

/** Switches intensities on or off. */
export const REQ_INTNS: MessageType<IntnsConfig> = new MessageType(62, Kind.REQ, 3, 'ranger.req.intns', IntnsConfig);

/** Sets angles, ranges and rate; the answer has the values in effect. */
export const REQ_SET_CONFIG: MessageType<Config> = new MessageType(62, Kind.REQ, 4, 'ranger.req.set_config', Config);

/** Requests angles, ranges and rate. */
export const REQ_GET_CONFIG: MessageType<Config> = new MessageType(62, Kind.REQ, 5, 'ranger.req.get_config', Config);
