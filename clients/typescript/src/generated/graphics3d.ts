/**
 * Interface graphics3d, code 58. Draws 3D shapes for display.
 *
 * Generated from interfaces/058_graphics3d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 58;

// Values of CmdDraw.draw_mode: primitives made from the points.
export const DRAW_POINTS = 0;
export const DRAW_LINES = 1;
export const DRAW_LINE_STRIP = 2;
export const DRAW_LINE_LOOP = 3;
export const DRAW_TRIANGLES = 4;
export const DRAW_TRIANGLE_STRIP = 5;
export const DRAW_TRIANGLE_FAN = 6;
export const DRAW_QUADS = 7;
export const DRAW_QUAD_STRIP = 8;
export const DRAW_POLYGON = 9;

/** Points, lines or faces. (player_graphics3d_cmd_draw_t) */
export interface CmdDraw {
  drawMode: number;
  /** In m, frame p_SP. */
  points: common.Point3d[];
  color: common.Color;
}

export const CmdDraw: Codec<CmdDraw> = new Codec<CmdDraw>('graphics3d.CmdDraw', {
  zero: () => ({ drawMode: 0, points: [], color: common.Color.make() }),
  write(to, value) {
    to.uint32(value.drawMode);
    to.length('points', value.points.length, 1398099);
    to.length('points', value.points.length, 1398099);
    for (const each of value.points) common.Point3d.write(to, each);
    common.Color.write(to, value.color);
  },
  read(from) {
    const drawMode = from.uint32();
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 24), () => common.Point3d.read(from));
    const color = common.Color.read(from);
    return { drawMode, points, color };
  },
});

/** A translation of the coordinate frame. (player_graphics3d_cmd_translate_t) */
export interface CmdTranslate {
  /** In m. */
  x: number;
  /** In m. */
  y: number;
  /** In m. */
  z: number;
}

export const CmdTranslate: Codec<CmdTranslate> = new Codec<CmdTranslate>('graphics3d.CmdTranslate', {
  zero: () => ({ x: 0, y: 0, z: 0 }),
  write(to, value) {
    to.float64(value.x);
    to.float64(value.y);
    to.float64(value.z);
  },
  read(from) {
    const x = from.float64();
    const y = from.float64();
    const z = from.float64();
    return { x, y, z };
  },
});

/** A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t) */
export interface CmdRotate {
  /** Angle about the vector (x, y, z) (in rad). */
  a: number;
  x: number;
  y: number;
  z: number;
}

export const CmdRotate: Codec<CmdRotate> = new Codec<CmdRotate>('graphics3d.CmdRotate', {
  zero: () => ({ a: 0, x: 0, y: 0, z: 0 }),
  write(to, value) {
    to.float64(value.a);
    to.float64(value.x);
    to.float64(value.y);
    to.float64(value.z);
  },
  read(from) {
    const a = from.float64();
    const x = from.float64();
    const y = from.float64();
    const z = from.float64();
    return { a, x, y, z };
  },
});

/** Removes all drawn shapes. */
export const CMD_CLEAR: MessageType<undefined> = new MessageType(58, Kind.CMD, 1, 'graphics3d.cmd.clear');

/** Draws points, lines or faces. */
export const CMD_DRAW: MessageType<CmdDraw> = new MessageType(58, Kind.CMD, 2, 'graphics3d.cmd.draw', CmdDraw);

/** Translates the coordinate frame of subsequent drawing. */
export const CMD_TRANSLATE: MessageType<CmdTranslate> = new MessageType(
  58,
  Kind.CMD,
  3,
  'graphics3d.cmd.translate',
  CmdTranslate,
);

/** Rotates the coordinate frame of subsequent drawing. */
export const CMD_ROTATE: MessageType<CmdRotate> = new MessageType(58, Kind.CMD, 4, 'graphics3d.cmd.rotate', CmdRotate);

/** Pushes the current coordinate frame. */
export const CMD_PUSH: MessageType<undefined> = new MessageType(58, Kind.CMD, 5, 'graphics3d.cmd.push');

/** Pops the pushed coordinate frame. */
export const CMD_POP: MessageType<undefined> = new MessageType(58, Kind.CMD, 6, 'graphics3d.cmd.pop');
