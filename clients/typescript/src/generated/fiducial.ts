/**
 * Interface fiducial, code 10. Detects markers and reports their ids and poses.
 *
 * Generated from interfaces/010_fiducial.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 10;

/** One marker in view. (player_fiducial_item_t) */
export interface Item {
  /** Id of the marker; -1 if it cannot be identified, from simulated finders 0. */
  id: number;
  /** Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST). */
  pose: common.Pose3d;
  /** Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad, frame X_ST). */
  upose: common.Pose3d;
}

export const Item: Codec<Item> = new Codec<Item>('fiducial.Item', {
  zero: () => ({ id: 0, pose: common.Pose3d.make(), upose: common.Pose3d.make() }),
  write(to, value) {
    to.int32(value.id);
    common.Pose3d.write(to, value.pose);
    common.Pose3d.write(to, value.upose);
  },
  read(from) {
    const id = from.int32();
    const pose = common.Pose3d.read(from);
    const upose = common.Pose3d.read(from);
    return { id, pose, upose };
  },
});

/** The markers in view. (player_fiducial_data_t) */
export interface Data {
  fiducials: Item[];
}

export const Data: Codec<Data> = new Codec<Data>('fiducial.Data', {
  zero: () => ({ fiducials: [] }),
  write(to, value) {
    to.length('fiducials', value.fiducials.length, 335543);
    to.length('fiducials', value.fiducials.length, 335543);
    for (const each of value.fiducials) Item.write(to, each);
  },
  read(from) {
    const fiducialsCount = from.uint32();
    const fiducials = from.many(from.length('fiducials', fiducialsCount, 100), () => Item.read(from));
    return { fiducials };
  },
});

/** Size and pose. (player_fiducial_geom_t) */
export interface Geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pose: common.Pose3d;
  /** Bounding box of the device (in m, m, m). */
  size: common.Bbox3d;
  /** Of the markers; 0 if unknown (in m, m). */
  fiducialSize: common.Bbox2d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('fiducial.Geom', {
  zero: () => ({ pose: common.Pose3d.make(), size: common.Bbox3d.make(), fiducialSize: common.Bbox2d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pose);
    common.Bbox3d.write(to, value.size);
    common.Bbox2d.write(to, value.fiducialSize);
  },
  read(from) {
    const pose = common.Pose3d.read(from);
    const size = common.Bbox3d.read(from);
    const fiducialSize = common.Bbox2d.read(from);
    return { pose, size, fiducialSize };
  },
});

/** Range and field of view. (player_fiducial_fov_t) */
export interface Fov {
  /** In m. */
  minRange: number;
  /** In m. */
  maxRange: number;
  /** From the first to the last direction (in rad). */
  viewAngle: number;
}

export const Fov: Codec<Fov> = new Codec<Fov>('fiducial.Fov', {
  zero: () => ({ minRange: 0, maxRange: 0, viewAngle: 0 }),
  write(to, value) {
    to.float32(value.minRange);
    to.float32(value.maxRange);
    to.float32(value.viewAngle);
  },
  read(from) {
    const minRange = from.float32();
    const maxRange = from.float32();
    const viewAngle = from.float32();
    return { minRange, maxRange, viewAngle };
  },
});

/** A marker id. (player_fiducial_id_t) */
export interface Id {
  id: number;
}

export const Id: Codec<Id> = new Codec<Id>('fiducial.Id', {
  zero: () => ({ id: 0 }),
  write(to, value) {
    to.uint32(value.id);
  },
  read(from) {
    const id = from.uint32();
    return { id };
  },
});

/** The markers in view. */
export const DATA_SCAN: MessageType<Data> = new MessageType(10, Kind.DATA, 1, 'fiducial.data.scan', Data);

/** Requests the device's size and pose and the markers' size. */
export const REQ_GET_GEOM: MessageType<Geom> = new MessageType(10, Kind.REQ, 1, 'fiducial.req.get_geom', Geom);

/** Requests the range and the field of view. */
export const REQ_GET_FOV: MessageType<Fov> = new MessageType(10, Kind.REQ, 2, 'fiducial.req.get_fov', Fov);

/** Sets the range and the field of view; the answer has the values in effect. */
export const REQ_SET_FOV: MessageType<Fov> = new MessageType(10, Kind.REQ, 3, 'fiducial.req.set_fov', Fov);

/** Requests the robot's own marker id. */
export const REQ_GET_ID: MessageType<Id> = new MessageType(10, Kind.REQ, 7, 'fiducial.req.get_id', Id);

/** Sets the robot's own marker id. */
export const REQ_SET_ID: MessageType<Id> = new MessageType(10, Kind.REQ, 8, 'fiducial.req.set_id', Id);
