/**
 * What every interface shares. Types shared by several interfaces, and requests to any device.
 *
 * Generated from interfaces/000_common.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

// Limits shared by all implementations of the protocol.
export const MAX_MESSAGE_SIZE = 8388608;
export const MAX_DRIVER_STRING_LEN = 64;
export const MAX_DEVICES = 4096;
export const MSGQUEUE_DEFAULT_MAXLEN = 1024;
export const IDENT_STRLEN = 32;
export const KEYLEN = 32;

/** Address of a device. (player_devaddr_t) */
export interface Devaddr {
  /** Host of the device's server; receivers compare only interf and index. */
  host: number;
  /** TCP port of the device's server: its name space. */
  robot: number;
  /** Interface code. */
  interf: number;
  /** Index of the device within its interface. */
  index: number;
}

export const Devaddr: Codec<Devaddr> = new Codec<Devaddr>('common.Devaddr', {
  zero: () => ({ host: 0, robot: 0, interf: 0, index: 0 }),
  write(to, value) {
    to.uint32(value.host);
    to.uint32(value.robot);
    to.uint16(value.interf);
    to.uint16(value.index);
  },
  read(from) {
    const host = from.uint32();
    const robot = from.uint32();
    const interf = from.uint16();
    const index = from.uint16();
    return { host, robot, interf, index };
  },
});

/** A point or vector in the plane. (player_point_2d_t) */
export interface Point2d {
  /** In m. */
  px: number;
  /** In m. */
  py: number;
}

export const Point2d: Codec<Point2d> = new Codec<Point2d>('common.Point2d', {
  zero: () => ({ px: 0, py: 0 }),
  write(to, value) {
    to.float64(value.px);
    to.float64(value.py);
  },
  read(from) {
    const px = from.float64();
    const py = from.float64();
    return { px, py };
  },
});

/** A point or vector in space. (player_point_3d_t) */
export interface Point3d {
  /** In m. */
  px: number;
  /** In m. */
  py: number;
  /** In m. */
  pz: number;
}

export const Point3d: Codec<Point3d> = new Codec<Point3d>('common.Point3d', {
  zero: () => ({ px: 0, py: 0, pz: 0 }),
  write(to, value) {
    to.float64(value.px);
    to.float64(value.py);
    to.float64(value.pz);
  },
  read(from) {
    const px = from.float64();
    const py = from.float64();
    const pz = from.float64();
    return { px, py, pz };
  },
});

/** An orientation in space: rotations about z (yaw), then y (pitch), then x (roll). (player_orientation_3d_t) */
export interface Orientation3d {
  /** About x (in rad). */
  proll: number;
  /** About y (in rad). */
  ppitch: number;
  /** About z (in rad). */
  pyaw: number;
}

export const Orientation3d: Codec<Orientation3d> = new Codec<Orientation3d>('common.Orientation3d', {
  zero: () => ({ proll: 0, ppitch: 0, pyaw: 0 }),
  write(to, value) {
    to.float64(value.proll);
    to.float64(value.ppitch);
    to.float64(value.pyaw);
  },
  read(from) {
    const proll = from.float64();
    const ppitch = from.float64();
    const pyaw = from.float64();
    return { proll, ppitch, pyaw };
  },
});

/** A pose in the plane, or, if the message says so, a velocity with the same three components. (player_pose2d_t) */
export interface Pose2d {
  /** In m. */
  px: number;
  /** In m. */
  py: number;
  /** Heading, counter-clockwise from x (in rad). */
  pa: number;
}

export const Pose2d: Codec<Pose2d> = new Codec<Pose2d>('common.Pose2d', {
  zero: () => ({ px: 0, py: 0, pa: 0 }),
  write(to, value) {
    to.float64(value.px);
    to.float64(value.py);
    to.float64(value.pa);
  },
  read(from) {
    const px = from.float64();
    const py = from.float64();
    const pa = from.float64();
    return { px, py, pa };
  },
});

/**
 * A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
 * (player_pose3d_t)
 */
export interface Pose3d {
  /** In m. */
  px: number;
  /** In m. */
  py: number;
  /** In m. */
  pz: number;
  /** About x (in rad). */
  proll: number;
  /** About y (in rad). */
  ppitch: number;
  /** About z (in rad). */
  pyaw: number;
}

export const Pose3d: Codec<Pose3d> = new Codec<Pose3d>('common.Pose3d', {
  zero: () => ({ px: 0, py: 0, pz: 0, proll: 0, ppitch: 0, pyaw: 0 }),
  write(to, value) {
    to.float64(value.px);
    to.float64(value.py);
    to.float64(value.pz);
    to.float64(value.proll);
    to.float64(value.ppitch);
    to.float64(value.pyaw);
  },
  read(from) {
    const px = from.float64();
    const py = from.float64();
    const pz = from.float64();
    const proll = from.float64();
    const ppitch = from.float64();
    const pyaw = from.float64();
    return { px, py, pz, proll, ppitch, pyaw };
  },
});

/** Size of a bounding rectangle. (player_bbox2d_t) */
export interface Bbox2d {
  /** Width, along y (in m). */
  sw: number;
  /** Length, along x (in m). */
  sl: number;
}

export const Bbox2d: Codec<Bbox2d> = new Codec<Bbox2d>('common.Bbox2d', {
  zero: () => ({ sw: 0, sl: 0 }),
  write(to, value) {
    to.float64(value.sw);
    to.float64(value.sl);
  },
  read(from) {
    const sw = from.float64();
    const sl = from.float64();
    return { sw, sl };
  },
});

/** Size of a bounding box. (player_bbox3d_t) */
export interface Bbox3d {
  /** Width, along y (in m). */
  sw: number;
  /** Length, along x (in m). */
  sl: number;
  /** Height, along z (in m). */
  sh: number;
}

export const Bbox3d: Codec<Bbox3d> = new Codec<Bbox3d>('common.Bbox3d', {
  zero: () => ({ sw: 0, sl: 0, sh: 0 }),
  write(to, value) {
    to.float64(value.sw);
    to.float64(value.sl);
    to.float64(value.sh);
  },
  read(from) {
    const sw = from.float64();
    const sl = from.float64();
    const sh = from.float64();
    return { sw, sl, sh };
  },
});

/** One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t) */
export interface BlackboardEntry {
  /** Name of the entry within its group. */
  key: Uint8Array;
  /** Name of the group, a namespace of keys. */
  group: Uint8Array;
  /** Category of `data`: simple values or types of other interfaces. */
  type: number;
  /** Exact type of `data`; of simple values: string, integer or floating-point number. */
  subtype: number;
  /** Bytes of the value, opaque to the blackboard. */
  data: Uint8Array;
  /** Time at which the value was set: whole seconds (in s). */
  timestampSec: number;
  /** Time at which the value was set: microseconds of the second (in us). */
  timestampUsec: number;
}

export const BlackboardEntry: Codec<BlackboardEntry> = new Codec<BlackboardEntry>('common.BlackboardEntry', {
  zero: () => ({
    key: new Uint8Array(),
    group: new Uint8Array(),
    type: 0,
    subtype: 0,
    data: new Uint8Array(),
    timestampSec: 0,
    timestampUsec: 0,
  }),
  write(to, value) {
    to.length('key', value.key.length, 33554392);
    to.length('key', value.key.length, 33554392);
    to.opaque(value.key);
    to.length('group', value.group.length, 33554392);
    to.length('group', value.group.length, 33554392);
    to.opaque(value.group);
    to.uint16(value.type);
    to.uint16(value.subtype);
    to.length('data', value.data.length, 33554392);
    to.length('data', value.data.length, 33554392);
    to.opaque(value.data);
    to.uint32(value.timestampSec);
    to.uint32(value.timestampUsec);
  },
  read(from) {
    const keyCount = from.uint32();
    const key = from.opaque(from.length('key', keyCount, 1));
    const groupCount = from.uint32();
    const group = from.opaque(from.length('group', groupCount, 1));
    const type = from.uint16();
    const subtype = from.uint16();
    const dataCount = from.uint32();
    const data = from.opaque(from.length('data', dataCount, 1));
    const timestampSec = from.uint32();
    const timestampUsec = from.uint32();
    return { key, group, type, subtype, data, timestampSec, timestampUsec };
  },
});

/** A line segment. (player_segment_t) */
export interface Segment {
  /** x of the start (in m). */
  x0: number;
  /** y of the start (in m). */
  y0: number;
  /** x of the end (in m). */
  x1: number;
  /** y of the end (in m). */
  y1: number;
}

export const Segment: Codec<Segment> = new Codec<Segment>('common.Segment', {
  zero: () => ({ x0: 0, y0: 0, x1: 0, y1: 0 }),
  write(to, value) {
    to.float64(value.x0);
    to.float64(value.y0);
    to.float64(value.x1);
    to.float64(value.y1);
  },
  read(from) {
    const x0 = from.float64();
    const y0 = from.float64();
    const x1 = from.float64();
    const y1 = from.float64();
    return { x0, y0, x1, y1 };
  },
});

/** An axis-aligned rectangle, given by two corners. (player_extent2d_t) */
export interface Extent2d {
  /** Smallest x (in m). */
  x0: number;
  /** Smallest y (in m). */
  y0: number;
  /** Largest x (in m). */
  x1: number;
  /** Largest y (in m). */
  y1: number;
}

export const Extent2d: Codec<Extent2d> = new Codec<Extent2d>('common.Extent2d', {
  zero: () => ({ x0: 0, y0: 0, x1: 0, y1: 0 }),
  write(to, value) {
    to.float64(value.x0);
    to.float64(value.y0);
    to.float64(value.x1);
    to.float64(value.y1);
  },
  read(from) {
    const x0 = from.float64();
    const y0 = from.float64();
    const x1 = from.float64();
    const y1 = from.float64();
    return { x0, y0, x1, y1 };
  },
});

/** A color with opacity, each component from 0 to 255. (player_color_t) */
export interface Color {
  /** 255 is opaque, 0 invisible. */
  alpha: number;
  red: number;
  green: number;
  blue: number;
}

export const Color: Codec<Color> = new Codec<Color>('common.Color', {
  zero: () => ({ alpha: 0, red: 0, green: 0, blue: 0 }),
  write(to, value) {
    to.uint8(value.alpha);
    to.uint8(value.red);
    to.uint8(value.green);
    to.uint8(value.blue);
  },
  read(from) {
    const alpha = from.uint8();
    const red = from.uint8();
    const green = from.uint8();
    const blue = from.uint8();
    return { alpha, red, green, blue };
  },
});

/** A switch. (player_bool_t) */
export interface Bool {
  /** 0: off, else on. */
  state: number;
}

export const Bool: Codec<Bool> = new Codec<Bool>('common.Bool', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** One integer. (player_uint32_t) */
export interface Uint32 {
  value: number;
}

export const Uint32: Codec<Uint32> = new Codec<Uint32>('common.Uint32', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint32(value.value);
  },
  read(from) {
    const value = from.uint32();
    return { value };
  },
});

/** The queried message. (player_capabilities_req_t) */
export interface CapabilitiesReq {
  /** Type of the message, as in a header. */
  type: number;
  /** Subtype of the message, as in a header. */
  subtype: number;
}

export const CapabilitiesReq: Codec<CapabilitiesReq> = new Codec<CapabilitiesReq>('common.CapabilitiesReq', {
  zero: () => ({ type: 0, subtype: 0 }),
  write(to, value) {
    to.uint32(value.type);
    to.uint32(value.subtype);
  },
  read(from) {
    const type = from.uint32();
    const subtype = from.uint32();
    return { type, subtype };
  },
});

/** A named switch. (player_boolprop_req_t) */
export interface BoolpropReq {
  /** Name of the property, NUL-terminated. */
  key: Uint8Array;
  /** 0 false, else true; ignored in a request. */
  value: number;
}

export const BoolpropReq: Codec<BoolpropReq> = new Codec<BoolpropReq>('common.BoolpropReq', {
  zero: () => ({ key: new Uint8Array(), value: 0 }),
  write(to, value) {
    to.length('key', value.key.length, 33554392);
    to.length('key', value.key.length, 33554392);
    to.opaque(value.key);
    to.int8(value.value);
  },
  read(from) {
    const keyCount = from.uint32();
    const key = from.opaque(from.length('key', keyCount, 1));
    const value = from.int8();
    return { key, value };
  },
});

/** A named integer. (player_intprop_req_t) */
export interface IntpropReq {
  /** Name of the property, NUL-terminated. */
  key: Uint8Array;
  /** Ignored in a question. */
  value: number;
}

export const IntpropReq: Codec<IntpropReq> = new Codec<IntpropReq>('common.IntpropReq', {
  zero: () => ({ key: new Uint8Array(), value: 0 }),
  write(to, value) {
    to.length('key', value.key.length, 33554392);
    to.length('key', value.key.length, 33554392);
    to.opaque(value.key);
    to.int32(value.value);
  },
  read(from) {
    const keyCount = from.uint32();
    const key = from.opaque(from.length('key', keyCount, 1));
    const value = from.int32();
    return { key, value };
  },
});

/** A named number. (player_dblprop_req_t) */
export interface DblpropReq {
  /** Name of the property, NUL-terminated. */
  key: Uint8Array;
  /** In the driver's unit for the property; ignored in a request. */
  value: number;
}

export const DblpropReq: Codec<DblpropReq> = new Codec<DblpropReq>('common.DblpropReq', {
  zero: () => ({ key: new Uint8Array(), value: 0 }),
  write(to, value) {
    to.length('key', value.key.length, 33554392);
    to.length('key', value.key.length, 33554392);
    to.opaque(value.key);
    to.float64(value.value);
  },
  read(from) {
    const keyCount = from.uint32();
    const key = from.opaque(from.length('key', keyCount, 1));
    const value = from.float64();
    return { key, value };
  },
});

/** A named string. (player_strprop_req_t) */
export interface StrpropReq {
  /** Name of the property, NUL-terminated. */
  key: Uint8Array;
  /** NUL-terminated; ignored in a request. */
  value: Uint8Array;
}

export const StrpropReq: Codec<StrpropReq> = new Codec<StrpropReq>('common.StrpropReq', {
  zero: () => ({ key: new Uint8Array(), value: new Uint8Array() }),
  write(to, value) {
    to.length('key', value.key.length, 33554392);
    to.length('key', value.key.length, 33554392);
    to.opaque(value.key);
    to.length('value', value.value.length, 33554392);
    to.length('value', value.value.length, 33554392);
    to.opaque(value.value);
  },
  read(from) {
    const keyCount = from.uint32();
    const key = from.opaque(from.length('key', keyCount, 1));
    const valueCount = from.uint32();
    const value = from.opaque(from.length('value', valueCount, 1));
    return { key, value };
  },
});

/** Queries whether the device supports a message: an empty ACK means yes, NACK no. */
export const REQ_CAPABILITIES: MessageType<CapabilitiesReq> = new MessageType(
  0,
  Kind.REQ,
  255,
  'universal.req.capabilities',
  CapabilitiesReq,
);

/** Reads a named integer of the driver; the answer repeats the key. */
export const REQ_GET_INTPROP: MessageType<IntpropReq> = new MessageType(
  0,
  Kind.REQ,
  254,
  'universal.req.get_intprop',
  IntpropReq,
);

/** Changes a named integer of the driver. */
export const REQ_SET_INTPROP: MessageType<IntpropReq> = new MessageType(
  0,
  Kind.REQ,
  253,
  'universal.req.set_intprop',
  IntpropReq,
);

/** Reads a named number of the driver; the answer repeats the key. */
export const REQ_GET_DBLPROP: MessageType<DblpropReq> = new MessageType(
  0,
  Kind.REQ,
  252,
  'universal.req.get_dblprop',
  DblpropReq,
);

/** Changes a named number of the driver. */
export const REQ_SET_DBLPROP: MessageType<DblpropReq> = new MessageType(
  0,
  Kind.REQ,
  251,
  'universal.req.set_dblprop',
  DblpropReq,
);

/** Reads a named string of the driver; the answer repeats the key. */
export const REQ_GET_STRPROP: MessageType<StrpropReq> = new MessageType(
  0,
  Kind.REQ,
  250,
  'universal.req.get_strprop',
  StrpropReq,
);

/** Changes a named string of the driver. */
export const REQ_SET_STRPROP: MessageType<StrpropReq> = new MessageType(
  0,
  Kind.REQ,
  249,
  'universal.req.set_strprop',
  StrpropReq,
);

/** Reads a named switch of the driver; the answer repeats the key. */
export const REQ_GET_BOOLPROP: MessageType<BoolpropReq> = new MessageType(
  0,
  Kind.REQ,
  248,
  'universal.req.get_boolprop',
  BoolpropReq,
);

/** Changes a named switch of the driver. */
export const REQ_SET_BOOLPROP: MessageType<BoolpropReq> = new MessageType(
  0,
  Kind.REQ,
  247,
  'universal.req.set_boolprop',
  BoolpropReq,
);
