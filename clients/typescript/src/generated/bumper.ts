/**
 * Interface bumper, code 14. Contact switches.
 *
 * Generated from interfaces/014_bumper.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 14;

/** Which bumpers are pressed. (player_bumper_data_t) */
export interface Data {
  /** One per bumper: 0 free, else pressed. */
  bumpers: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('bumper.Data', {
  zero: () => ({ bumpers: new Uint8Array() }),
  write(to, value) {
    to.length('bumpers', value.bumpers.length, 33554392);
    to.length('bumpers', value.bumpers.length, 33554392);
    to.opaque(value.bumpers);
  },
  read(from) {
    const bumpersCount = from.uint32();
    const bumpers = from.opaque(from.length('bumpers', bumpersCount, 1));
    return { bumpers };
  },
});

/** One bumper. (player_bumper_define_t) */
export interface Define {
  /** Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** In m. */
  length: number;
  /** Radius of curvature; 0 if it is straight (in m). */
  radius: number;
}

export const Define: Codec<Define> = new Codec<Define>('bumper.Define', {
  zero: () => ({ pose: common.Pose3d.make(), length: 0, radius: 0 }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    to.float32(value.length);
    to.float32(value.radius);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const length = from.float32();
    const radius = from.float32();
    return { pose, length, radius };
  },
});

/** Poses of the bumpers. (player_bumper_geom_t) */
export interface Geom {
  bumperDef: Define[];
}

export const Geom: Codec<Geom> = new Codec<Geom>('bumper.Geom', {
  zero: () => ({ bumperDef: [] }),
  write(to, value) {
    to.length('bumper_def', value.bumperDef.length, 599185);
    to.length('bumper_def', value.bumperDef.length, 599185);
    for (const each of value.bumperDef) Define.write(to, each);
  },
  read(from) {
    const bumperDefCount = from.uint32();
    const bumperDef = from.many(from.length('bumper_def', bumperDefCount, 56), () => Define.read(from));
    return { bumperDef };
  },
});

/** Which bumpers are pressed. */
export const DATA_STATE: MessageType<Data> = new MessageType(14, Kind.DATA, 1, 'bumper.data.state', Data);

/** Poses of the bumpers, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(14, Kind.DATA, 2, 'bumper.data.geom', Geom);

/** Requests the poses of the bumpers. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(14, Kind.REQ, 1, 'bumper.req.get_geom', Geom);
