/**
 * Interface graphics2d, code 55. Draws 2D shapes for display.
 *
 * Generated from interfaces/055_graphics2d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 55;

/** Points. (player_graphics2d_cmd_points_t) */
export interface CmdPoints {
  /** In m, frame p_SP. */
  points: common.Point2d[];
  color: common.Color;
}

export const CmdPoints: Codec<CmdPoints> = new Codec<CmdPoints>('graphics2d.CmdPoints', {
  zero: () => ({ points: [], color: common.Color.make() }),
  write(to, value) {
    to.length('points', value.points.length, 2097149);
    to.length('points', value.points.length, 2097149);
    for (const each of value.points) common.Point2d.write(to, each);
    common.Color.write(to, value.color);
  },
  read(from) {
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 16), () => common.Point2d.read(from));
    const color = common.Color.read(from);
    return { points, color };
  },
});

/** A line through points. (player_graphics2d_cmd_polyline_t) */
export interface CmdPolyline {
  /** In m, frame p_SP. */
  points: common.Point2d[];
  color: common.Color;
}

export const CmdPolyline: Codec<CmdPolyline> = new Codec<CmdPolyline>('graphics2d.CmdPolyline', {
  zero: () => ({ points: [], color: common.Color.make() }),
  write(to, value) {
    to.length('points', value.points.length, 2097149);
    to.length('points', value.points.length, 2097149);
    for (const each of value.points) common.Point2d.write(to, each);
    common.Color.write(to, value.color);
  },
  read(from) {
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 16), () => common.Point2d.read(from));
    const color = common.Color.read(from);
    return { points, color };
  },
});

/** A polygon. (player_graphics2d_cmd_polygon_t) */
export interface CmdPolygon {
  /** Vertices (in m, frame p_SP). */
  points: common.Point2d[];
  /** Outline color. */
  color: common.Color;
  /** Fill color. */
  fillColor: common.Color;
  /** 1: filled. */
  filled: number;
}

export const CmdPolygon: Codec<CmdPolygon> = new Codec<CmdPolygon>('graphics2d.CmdPolygon', {
  zero: () => ({ points: [], color: common.Color.make(), fillColor: common.Color.make(), filled: 0 }),
  write(to, value) {
    to.length('points', value.points.length, 2097149);
    to.length('points', value.points.length, 2097149);
    for (const each of value.points) common.Point2d.write(to, each);
    common.Color.write(to, value.color);
    common.Color.write(to, value.fillColor);
    to.uint8(value.filled);
  },
  read(from) {
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 16), () => common.Point2d.read(from));
    const color = common.Color.read(from);
    const fillColor = common.Color.read(from);
    const filled = from.uint8();
    return { points, color, fillColor, filled };
  },
});

/** Lines, each between two points. (player_graphics2d_cmd_multiline_t) */
export interface CmdMultiline {
  /** Start and end of each line, alternating (in m, frame p_SP). */
  points: common.Point2d[];
  color: common.Color;
}

export const CmdMultiline: Codec<CmdMultiline> = new Codec<CmdMultiline>('graphics2d.CmdMultiline', {
  zero: () => ({ points: [], color: common.Color.make() }),
  write(to, value) {
    to.length('points', value.points.length, 2097149);
    to.length('points', value.points.length, 2097149);
    for (const each of value.points) common.Point2d.write(to, each);
    common.Color.write(to, value.color);
  },
  read(from) {
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 16), () => common.Point2d.read(from));
    const color = common.Color.read(from);
    return { points, color };
  },
});

/** Removes all drawn shapes. */
export const CMD_CLEAR: MessageType<undefined> = new MessageType(55, Kind.CMD, 1, 'graphics2d.cmd.clear');

/** Draws points. */
export const CMD_POINTS: MessageType<CmdPoints> = new MessageType(55, Kind.CMD, 2, 'graphics2d.cmd.points', CmdPoints);

/** Draws a line through points. */
export const CMD_POLYLINE: MessageType<CmdPolyline> = new MessageType(
  55,
  Kind.CMD,
  3,
  'graphics2d.cmd.polyline',
  CmdPolyline,
);

/** Draws a polygon. */
export const CMD_POLYGON: MessageType<CmdPolygon> = new MessageType(
  55,
  Kind.CMD,
  4,
  'graphics2d.cmd.polygon',
  CmdPolygon,
);

/** Draws a line for each pair of points. */
export const CMD_MULTILINE: MessageType<CmdMultiline> = new MessageType(
  55,
  Kind.CMD,
  5,
  'graphics2d.cmd.multiline',
  CmdMultiline,
);
