/**
 * Interface stereo, code 65. A pair of cameras, their disparity and the points in space.
 *
 * Generated from interfaces/065_stereo.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as camera from './camera.js';

export const CODE = 65;

/** One point. (player_pointcloud3d_stereo_element_t) */
export interface Pointcloud3dStereoElement {
  /** In m, frame p_SP. */
  px: number;
  /** In m, frame p_SP. */
  py: number;
  /** In m, frame p_SP. */
  pz: number;
  red: number;
  green: number;
  blue: number;
}

export const Pointcloud3dStereoElement: Codec<Pointcloud3dStereoElement> = new Codec<Pointcloud3dStereoElement>('stereo.Pointcloud3dStereoElement', {
  zero: () => ({ px: 0, py: 0, pz: 0, red: 0, green: 0, blue: 0 }),
  write(to, value) {
    to.float32(value.px);
    to.float32(value.py);
    to.float32(value.pz);
    to.uint8(value.red);
    to.uint8(value.green);
    to.uint8(value.blue);
  },
  read(from) {
    const px = from.float32();
    const py = from.float32();
    const pz = from.float32();
    const red = from.uint8();
    const green = from.uint8();
    const blue = from.uint8();
    return { px, py, pz, red, green, blue };
  },
});

/** A pair of images, and the results computed from it. (player_stereo_data_t) */
export interface Data {
  /** Image of the left camera. */
  leftChannel: camera.Data;
  /** Image of the right camera. */
  rightChannel: camera.Data;
  /** Disparity, as an image. */
  disparity: camera.Data;
  /** Points in space. */
  points: Pointcloud3dStereoElement[];
  /** Driver-specific. */
  mode: number;
}

export const Data: Codec<Data> = new Codec<Data>('stereo.Data', {
  zero: () => ({
    leftChannel: camera.Data.make(),
    rightChannel: camera.Data.make(),
    disparity: camera.Data.make(),
    points: [],
    mode: 0,
  }),
  write(to, value) {
    camera.Data.write(to, value.leftChannel);
    camera.Data.write(to, value.rightChannel);
    camera.Data.write(to, value.disparity);
    to.length('points', value.points.length, 1398099);
    to.length('points', value.points.length, 1398099);
    for (const each of value.points) Pointcloud3dStereoElement.write(to, each);
    to.uint32(value.mode);
  },
  read(from) {
    const leftChannel = camera.Data.read(from);
    const rightChannel = camera.Data.read(from);
    const disparity = camera.Data.read(from);
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 24), () => Pointcloud3dStereoElement.read(from));
    const mode = from.uint32();
    return { leftChannel, rightChannel, disparity, points, mode };
  },
});

/** A pair of images, and the results computed from it. */
export const DATA_STATE: MessageType<Data> = new MessageType(65, Kind.DATA, 1, 'stereo.data.state', Data);
