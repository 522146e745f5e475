/**
 * Interface gps, code 13. A satellite receiver.
 *
 * Generated from interfaces/013_gps.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 13;

/** A fix. (player_gps_data_t) */
export interface Data {
  /** Time of the fix since 1970: whole seconds (in s). */
  timeSec: number;
  /** Time of the fix: microseconds of the second (in us). */
  timeUsec: number;
  /** Positive north, WGS84 (in 1e-7 deg). */
  latitude: number;
  /** Positive east, WGS84 (in 1e-7 deg). */
  longitude: number;
  /** Above the ellipsoid (in mm). */
  altitude: number;
  /** Over ground (in m/s). */
  speed: number;
  /** Direction of travel, clockwise from north (in rad). */
  course: number;
  /** UTM easting (in m). */
  utmE: number;
  /** UTM northing (in m). */
  utmN: number;
  /** 0: no fix, 1: plain, 2: differential. */
  quality: number;
  /** Satellites used. */
  numSats: number;
  /** Horizontal dilution of precision (in 0.1). */
  hdop: number;
  /** Vertical dilution of precision (in 0.1). */
  vdop: number;
  /** Expected horizontal error (in m). */
  errHorz: number;
  /** Expected vertical error (in m). */
  errVert: number;
}

export const Data: Codec<Data> = new Codec<Data>('gps.Data', {
  zero: () => ({
    timeSec: 0,
    timeUsec: 0,
    latitude: 0,
    longitude: 0,
    altitude: 0,
    speed: 0,
    course: 0,
    utmE: 0,
    utmN: 0,
    quality: 0,
    numSats: 0,
    hdop: 0,
    vdop: 0,
    errHorz: 0,
    errVert: 0,
  }),
  write(to, value) {
    to.uint32(value.timeSec);
    to.uint32(value.timeUsec);
    to.int32(value.latitude);
    to.int32(value.longitude);
    to.int32(value.altitude);
    to.float64(value.speed);
    to.float64(value.course);
    to.float64(value.utmE);
    to.float64(value.utmN);
    to.uint32(value.quality);
    to.uint32(value.numSats);
    to.uint32(value.hdop);
    to.uint32(value.vdop);
    to.float64(value.errHorz);
    to.float64(value.errVert);
  },
  read(from) {
    const timeSec = from.uint32();
    const timeUsec = from.uint32();
    const latitude = from.int32();
    const longitude = from.int32();
    const altitude = from.int32();
    const speed = from.float64();
    const course = from.float64();
    const utmE = from.float64();
    const utmN = from.float64();
    const quality = from.uint32();
    const numSats = from.uint32();
    const hdop = from.uint32();
    const vdop = from.uint32();
    const errHorz = from.float64();
    const errVert = from.float64();
    return {
      timeSec,
      timeUsec,
      latitude,
      longitude,
      altitude,
      speed,
      course,
      utmE,
      utmN,
      quality,
      numSats,
      hdop,
      vdop,
      errHorz,
      errVert,
    };
  },
});

/** The newest fix. */
export const DATA_STATE: MessageType<Data> = new MessageType(13, Kind.DATA, 1, 'gps.data.state', Data);
