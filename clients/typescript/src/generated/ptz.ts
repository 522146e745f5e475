/**
 * Interface ptz, code 8. A camera mount that pans, tilts and zooms.
 *
 * Generated from interfaces/008_ptz.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 8;

// Values of ReqControlMode.mode.
export const VELOCITY_CONTROL = 0;
export const POSITION_CONTROL = 1;

/** Direction of the mount. (player_ptz_data_t) */
export interface Data {
  /** Positive to the left (in rad). */
  pan: number;
  /** Positive upwards (in rad). */
  tilt: number;
  /** Field of view (in rad). */
  zoom: number;
  /** Positive to the left (in rad/s). */
  panspeed: number;
  /** Positive upwards (in rad/s). */
  tiltspeed: number;
  /** Driver-specific. */
  status: number;
}

export const Data: Codec<Data> = new Codec<Data>('ptz.Data', {
  zero: () => ({ pan: 0, tilt: 0, zoom: 0, panspeed: 0, tiltspeed: 0, status: 0 }),
  write(to, value) {
    to.float32(value.pan);
    to.float32(value.tilt);
    to.float32(value.zoom);
    to.float32(value.panspeed);
    to.float32(value.tiltspeed);
    to.uint32(value.status);
  },
  read(from) {
    const pan = from.float32();
    const tilt = from.float32();
    const zoom = from.float32();
    const panspeed = from.float32();
    const tiltspeed = from.float32();
    const status = from.uint32();
    return { pan, tilt, zoom, panspeed, tiltspeed, status };
  },
});

/** Commanded direction or velocity of the mount. (player_ptz_cmd_t) */
export interface Cmd {
  /** Positive to the left (in rad). */
  pan: number;
  /** Positive upwards (in rad). */
  tilt: number;
  /** Field of view (in rad). */
  zoom: number;
  /** Used by velocity control (in rad/s). */
  panspeed: number;
  /** Used by velocity control (in rad/s). */
  tiltspeed: number;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('ptz.Cmd', {
  zero: () => ({ pan: 0, tilt: 0, zoom: 0, panspeed: 0, tiltspeed: 0 }),
  write(to, value) {
    to.float32(value.pan);
    to.float32(value.tilt);
    to.float32(value.zoom);
    to.float32(value.panspeed);
    to.float32(value.tiltspeed);
  },
  read(from) {
    const pan = from.float32();
    const tilt = from.float32();
    const zoom = from.float32();
    const panspeed = from.float32();
    const tiltspeed = from.float32();
    return { pan, tilt, zoom, panspeed, tiltspeed };
  },
});

/** The mount's status. (player_ptz_req_status_t) */
export interface ReqStatus {
  /** Driver-specific. */
  status: number;
}

export const ReqStatus: Codec<ReqStatus> = new Codec<ReqStatus>('ptz.ReqStatus', {
  zero: () => ({ status: 0 }),
  write(to, value) {
    to.uint32(value.status);
  },
  read(from) {
    const status = from.uint32();
    return { status };
  },
});

/** The mount's size and pose. (player_ptz_geom_t) */
export interface Geom {
  /** Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  pos: common.Pose3d;
  /** Bounding box of the mount (in m, m, m). */
  size: common.Bbox3d;
}

export const Geom: Codec<Geom> = new Codec<Geom>('ptz.Geom', {
  zero: () => ({ pos: common.Pose3d.make(), size: common.Bbox3d.make() }),
  write(to, value) {
    common.Pose3d.write(to, value.pos);
    common.Bbox3d.write(to, value.size);
  },
  read(from) {
    const pos = common.Pose3d.read(from);
    const size = common.Bbox3d.read(from);
    return { pos, size };
  },
});

/** Driver-specific words. (player_ptz_req_generic_t) */
export interface ReqGeneric {
  /** Driver-specific. */
  config: number[];
}

export const ReqGeneric: Codec<ReqGeneric> = new Codec<ReqGeneric>('ptz.ReqGeneric', {
  zero: () => ({ config: [] }),
  write(to, value) {
    to.length('config', value.config.length, 8388598);
    to.length('config', value.config.length, 8388598);
    for (const each of value.config) to.uint32(each);
  },
  read(from) {
    const configCount = from.uint32();
    const config = from.many(from.length('config', configCount, 4), () => from.uint32());
    return { config };
  },
});

/** A control mode. (player_ptz_req_control_mode_t) */
export interface ReqControlMode {
  /** Velocity or position. */
  mode: number;
}

export const ReqControlMode: Codec<ReqControlMode> = new Codec<ReqControlMode>('ptz.ReqControlMode', {
  zero: () => ({ mode: 0 }),
  write(to, value) {
    to.uint32(value.mode);
  },
  read(from) {
    const mode = from.uint32();
    return { mode };
  },
});

/** Exchanges driver-specific words with the mount. */
export const REQ_GENERIC: MessageType<ReqGeneric> = new MessageType(8, Kind.REQ, 1, 'ptz.req.generic', ReqGeneric);

/** Selects between velocity and position control. */
export const REQ_CONTROL_MODE: MessageType<ReqControlMode> = new MessageType(
  8,
  Kind.REQ,
  2,
  'ptz.req.control_mode',
  ReqControlMode,
);

/** Requests size and pose. */
export const REQ_GEOM: MessageType<Geom> = new MessageType(8, Kind.REQ, 4, 'ptz.req.geom', Geom);

/** Requests the mount's status. */
export const REQ_STATUS: MessageType<ReqStatus> = new MessageType(8, Kind.REQ, 5, 'ptz.req.status', ReqStatus);

/** Direction of the mount. */
export const DATA_STATE: MessageType<Data> = new MessageType(8, Kind.DATA, 1, 'ptz.data.state', Data);

/** Size and pose, sent on change. */
export const DATA_GEOM: MessageType<Geom> = new MessageType(8, Kind.DATA, 2, 'ptz.data.geom', Geom);

/** Commanded direction of the mount. */
export const CMD_STATE: MessageType<Cmd> = new MessageType(8, Kind.CMD, 1, 'ptz.cmd.state', Cmd);
