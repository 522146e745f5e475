/**
 * Interface laser, code 6. A scanning range finder. New drivers use the ranger interface.
 *
 * Generated from interfaces/006_laser.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 6;

// Largest number of filter parameters.
export const MAX_FILTER_PARAMS = 8;

// Values of SetFilterConfig.filter_type.
export const FILTER_MEDIAN = 1;
export const FILTER_EDGE = 2;
export const FILTER_RANGE = 3;
export const FILTER_MEAN = 4;

/** One scan at equal angles. (player_laser_data_t) */
export interface Data {
  /** Of the first beam, counter-clockwise from x (in rad). */
  minAngle: number;
  /** Of the last beam (in rad). */
  maxAngle: number;
  /** Angle between neighbouring beams (in rad). */
  resolution: number;
  /** Reported range of a beam without a hit (in m). */
  maxRange: number;
  /** From right to left (in m). */
  ranges: Float32Array;
  /** Intensity of the echo per beam; empty if the device has none. */
  intensity: Uint8Array;
  /** Increases from scan to scan, by one or more. */
  id: number;
}

export const Data: Codec<Data> = new Codec<Data>('laser.Data', {
  zero: () => ({
    minAngle: 0,
    maxAngle: 0,
    resolution: 0,
    maxRange: 0,
    ranges: new Float32Array(),
    intensity: new Uint8Array(),
    id: 0,
  }),
  write(to, value) {
    to.float32(value.minAngle);
    to.float32(value.maxAngle);
    to.float32(value.resolution);
    to.float32(value.maxRange);
    to.length('ranges', value.ranges.length, 8388598);
    to.length('ranges', value.ranges.length, 8388598);
    to.float32s(value.ranges);
    to.length('intensity', value.intensity.length, 33554392);
    to.length('intensity', value.intensity.length, 33554392);
    to.opaque(value.intensity);
    to.uint32(value.id);
  },
  read(from) {
    const minAngle = from.float32();
    const maxAngle = from.float32();
    const resolution = from.float32();
    const maxRange = from.float32();
    const rangesCount = from.uint32();
    const ranges = from.float32s(from.length('ranges', rangesCount, 4));
    const intensityCount = from.uint32();
    const intensity = from.opaque(from.length('intensity', intensityCount, 1));
    const id = from.uint32();
    return { minAngle, maxAngle, resolution, maxRange, ranges, intensity, id };
  },
});

/** One scan and the pose at which it was measured. (player_laser_data_scanpose_t) */
export interface DataScanpose {
  scan: Data;
  /** Of the robot at the time of the scan (in m, m, rad, frame X_OR). */
  pose: common.Pose2d;
}

export const DataScanpose: Codec<DataScanpose> = new Codec<DataScanpose>('laser.DataScanpose', {
  zero: () => ({ scan: Data.make(), pose: common.Pose2d.make() }),
  write(to, value) {
    Data.write(to, value.scan);
    common.Pose2d.write(to, value.pose);
  },
  read(from) {
    const scan = Data.read(from);
    const pose = common.Pose2d.read(from);
    return { scan, pose };
  },
});

/** One scan with an angle per beam. (player_laser_data_scanangle_t) */
export interface DataScanangle {
  /** Reported range of a beam without a hit (in m). */
  maxRange: number;
  /** One per beam (in m). */
  ranges: Float32Array;
  /** One per beam, counter-clockwise from x (in rad). */
  angles: Float32Array;
  /** Intensity of the echo per beam; empty if the device has none. */
  intensity: Uint8Array;
  /** Increases from scan to scan, by one or more. */
  id: number;
}

export const DataScanangle: Codec<DataScanangle> = new Codec<DataScanangle>('laser.DataScanangle', {
  zero: () => ({
    maxRange: 0,
    ranges: new Float32Array(),
    angles: new Float32Array(),
    intensity: new Uint8Array(),
    id: 0,
  }),
  write(to, value) {
    to.float32(value.maxRange);
    to.length('ranges', value.ranges.length, 8388598);
    to.length('ranges', value.ranges.length, 8388598);
    to.float32s(value.ranges);
    to.length('angles', value.angles.length, 8388598);
    to.length('angles', value.angles.length, 8388598);
    to.float32s(value.angles);
    to.length('intensity', value.intensity.length, 33554392);
    to.length('intensity', value.intensity.length, 33554392);
    to.opaque(value.intensity);
    to.uint32(value.id);
  },
  read(from) {
    const maxRange = from.float32();
    const rangesCount = from.uint32();
    const ranges = from.float32s(from.length('ranges', rangesCount, 4));
    const anglesCount = from.uint32();
    const angles = from.float32s(from.length('angles', anglesCount, 4));
    const intensityCount = from.uint32();
    const intensity = from.opaque(from.length('intensity', intensityCount, 1));
    const id = from.uint32();
    return { maxRange, ranges, angles, intensity, id };
  },
});

/** The device's size and pose. (player_laser_geom_t) */
export interface Geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the device (in m, m, m). */
  size: common.Bbox3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('laser.Geom', {
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

/** Angles, resolution and rate. (player_laser_config_t) */
export interface Config {
  /** Of the first beam (in rad). */
  minAngle: number;
  /** Of the last beam (in rad). */
  maxAngle: number;
  /** Angle between neighbouring beams (in rad). */
  resolution: number;
  /** Maximum range (in m). */
  maxRange: number;
  /** Range resolution (in m). */
  rangeRes: number;
  /** 1: send intensities, too. */
  intensity: number;
  /** Scans per second (in Hz). */
  scanningFrequency: number;
}

export const Config: Codec<Config> = new Codec<Config>('laser.Config', {
  zero: () => ({
    minAngle: 0,
    maxAngle: 0,
    resolution: 0,
    maxRange: 0,
    rangeRes: 0,
    intensity: 0,
    scanningFrequency: 0,
  }),
  write(to, value) {
    to.float32(value.minAngle);
    to.float32(value.maxAngle);
    to.float32(value.resolution);
    to.float32(value.maxRange);
    to.float32(value.rangeRes);
    to.uint8(value.intensity);
    to.float32(value.scanningFrequency);
  },
  read(from) {
    const minAngle = from.float32();
    const maxAngle = from.float32();
    const resolution = from.float32();
    const maxRange = from.float32();
    const rangeRes = from.float32();
    const intensity = from.uint8();
    const scanningFrequency = from.float32();
    return { minAngle, maxAngle, resolution, maxRange, rangeRes, intensity, scanningFrequency };
  },
});

/** The device's switch. (player_laser_power_config_t) */
export interface PowerConfig {
  /** 1: on, 0: off. */
  state: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('laser.PowerConfig', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** A serial number. (player_laser_get_id_config_t) */
export interface GetIdConfig {
  /** 0 in the request. */
  serialNumber: number;
}

export const GetIdConfig: Codec<GetIdConfig> = new Codec<GetIdConfig>('laser.GetIdConfig', {
  zero: () => ({ serialNumber: 0 }),
  write(to, value) {
    to.uint32(value.serialNumber);
  },
  read(from) {
    const serialNumber = from.uint32();
    return { serialNumber };
  },
});

/** A filter. (player_laser_set_filter_config_t) */
export interface SetFilterConfig {
  /** Type of filter. */
  filterType: number;
  /** Filter-specific. */
  parameters: Float32Array;
}

export const SetFilterConfig: Codec<SetFilterConfig> = new Codec<SetFilterConfig>('laser.SetFilterConfig', {
  zero: () => ({ filterType: 0, parameters: new Float32Array() }),
  write(to, value) {
    to.uint8(value.filterType);
    to.length('parameters', value.parameters.length, 8);
    to.length('parameters', value.parameters.length, 8);
    to.float32s(value.parameters);
  },
  read(from) {
    const filterType = from.uint8();
    from.uint32();
    const parameters = from.float32s(from.length('parameters', 8, 4));
    return { filterType, parameters };
  },
});

/** One scan at equal angles. */
export const DATA_SCAN: MessageType<Data> = new MessageType(6, Kind.DATA, 1, 'laser.data.scan', Data);

/** One scan and the pose at which it was measured. */
export const DATA_SCANPOSE: MessageType<DataScanpose> = new MessageType(
  6,
  Kind.DATA,
  2,
  'laser.data.scanpose',
  DataScanpose,
);

/** One scan with an angle per beam. */
export const DATA_SCANANGLE: MessageType<DataScanangle> = new MessageType(
  6,
  Kind.DATA,
  3,
  'laser.data.scanangle',
  DataScanangle,
);

/** Requests the device's size and pose. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(6, Kind.REQ, 1, 'laser.req.get_geom', Geom);

/** Sets angles, resolution and rate; the answer has the values in effect. */
export const REQ_SET_CONFIG: MessageType<Config> = new MessageType(6, Kind.REQ, 2, 'laser.req.set_config', Config);

/** Requests angles, resolution and rate. */
export const REQ_GET_CONFIG: MessageType<Config> = new MessageType(6, Kind.REQ, 3, 'laser.req.get_config', Config);

/** Switches the device on or off. */
export const REQ_POWER: MessageType<PowerConfig> = new MessageType(6, Kind.REQ, 4, 'laser.req.power', PowerConfig);

/** Requests the serial number. */
export const REQ_GET_ID: MessageType<GetIdConfig> = new MessageType(6, Kind.REQ, 5, 'laser.req.get_id', GetIdConfig);

/** Selects a filter for the ranges. */
export const REQ_SET_FILTER: MessageType<SetFilterConfig> = new MessageType(
  6,
  Kind.REQ,
  6,
  'laser.req.set_filter',
  SetFilterConfig,
);
