/**
 * Interface map, code 42. Grid and vector maps.
 *
 * Generated from interfaces/042_map.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 42;

/** Size, scale and origin of the map. (player_map_info_t) */
export interface Info {
  /** Cell size (in m/pixel). */
  scale: number;
  /** In px. */
  width: number;
  /** In px. */
  height: number;
  /** Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM). */
  origin: common.Pose2d;
}

export const Info: Codec<Info> = new Codec<Info>('map.Info', {
  zero: () => ({ scale: 0, width: 0, height: 0, origin: common.Pose2d.make() }),
  write(to, value) {
    to.float32(value.scale);
    to.uint32(value.width);
    to.uint32(value.height);
    common.Pose2d.write(to, value.origin);
  },
  read(from) {
    const scale = from.float32();
    const width = from.uint32();
    const height = from.uint32();
    const origin = common.Pose2d.read(from);
    return { scale, width, height, origin };
  },
});

/** A rectangle of cells. (player_map_data_t) */
export interface Data {
  /** First column, from the left (in px). */
  col: number;
  /** First row, from the bottom (in px). */
  row: number;
  /** In px. */
  width: number;
  /** In px. */
  height: number;
  /** Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown. */
  dataRange: number;
  /** Rows, concatenated; compressed with zlib in an answer, empty in a request. */
  data: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('map.Data', {
  zero: () => ({ col: 0, row: 0, width: 0, height: 0, dataRange: 0, data: new Uint8Array() }),
  write(to, value) {
    to.uint32(value.col);
    to.uint32(value.row);
    to.uint32(value.width);
    to.uint32(value.height);
    to.length('data', value.data.length, 33554392);
    to.int8(value.dataRange);
    to.length('data', value.data.length, 33554392);
    to.opaque(value.data);
  },
  read(from) {
    const col = from.uint32();
    const row = from.uint32();
    const width = from.uint32();
    const height = from.uint32();
    const dataCount = from.uint32();
    const dataRange = from.int8();
    const data = from.opaque(from.length('data', dataCount, 1));
    return { col, row, width, height, dataRange, data };
  },
});

/** The map as line segments, and its extent. (player_map_data_vector_t) */
export interface DataVector {
  /** In m. */
  minx: number;
  /** In m. */
  maxx: number;
  /** In m. */
  miny: number;
  /** In m. */
  maxy: number;
  /** One per line (in m, frame p_MP). */
  segments: common.Segment[];
}

export const DataVector: Codec<DataVector> = new Codec<DataVector>('map.DataVector', {
  zero: () => ({ minx: 0, maxx: 0, miny: 0, maxy: 0, segments: [] }),
  write(to, value) {
    to.float32(value.minx);
    to.float32(value.maxx);
    to.float32(value.miny);
    to.float32(value.maxy);
    to.length('segments', value.segments.length, 1048574);
    to.length('segments', value.segments.length, 1048574);
    for (const each of value.segments) common.Segment.write(to, each);
  },
  read(from) {
    const minx = from.float32();
    const maxx = from.float32();
    const miny = from.float32();
    const maxy = from.float32();
    const segmentsCount = from.uint32();
    const segments = from.many(from.length('segments', segmentsCount, 32), () => common.Segment.read(from));
    return { minx, maxx, miny, maxy, segments };
  },
});

/** Size and scale of the map, sent on change. */
export const DATA_INFO: MessageType<Info> = new MessageType(42, Kind.DATA, 1, 'map.data.info', Info);

/** Requests the size and scale of the map. */
export const REQ_GET_INFO: MessageType<Info> = new MessageType(42, Kind.REQ, 1, 'map.req.get_info', Info);

/** Requests a rectangle of cells; the answer's cells are compressed with zlib. */
export const REQ_GET_DATA: MessageType<Data> = new MessageType(42, Kind.REQ, 2, 'map.req.get_data', Data);

/** Requests the map as lines. */
export const REQ_GET_VECTOR: MessageType<DataVector> = new MessageType(
  42,
  Kind.REQ,
  3,
  'map.req.get_vector',
  DataVector,
);
