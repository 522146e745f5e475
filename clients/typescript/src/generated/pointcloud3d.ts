/**
 * Interface pointcloud3d, code 61. Points in space with colors.
 *
 * Generated from interfaces/061_pointcloud3d.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 61;

/** One point. (player_pointcloud3d_element_t) */
export interface Element {
  /** In m, frame p_SP. */
  point: common.Point3d;
  color: common.Color;
}

export const Element: Codec<Element> = new Codec<Element>('pointcloud3d.Element', {
  zero: () => ({ point: common.Point3d.make(), color: common.Color.make() }),
  write(to, value) {
    common.Point3d.write(to, value.point);
    common.Color.write(to, value.color);
  },
  read(from) {
    const point = common.Point3d.read(from);
    const color = common.Color.read(from);
    return { point, color };
  },
});

/** One cloud. (player_pointcloud3d_data_t) */
export interface Data {
  points: Element[];
}

export const Data: Codec<Data> = new Codec<Data>('pointcloud3d.Data', {
  zero: () => ({ points: [] }),
  write(to, value) {
    to.length('points', value.points.length, 838859);
    to.length('points', value.points.length, 838859);
    for (const each of value.points) Element.write(to, each);
  },
  read(from) {
    const pointsCount = from.uint32();
    const points = from.many(from.length('points', pointsCount, 40), () => Element.read(from));
    return { points };
  },
});

/** One cloud. */
export const DATA_STATE: MessageType<Data> = new MessageType(61, Kind.DATA, 1, 'pointcloud3d.data.state', Data);
