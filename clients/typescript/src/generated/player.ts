/**
 * Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery of data.
 * Always open as player:0.
 *
 * Generated from interfaces/001_player.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 1;

// Values of DeviceReq.access.
export const OPEN_MODE = 1;
export const CLOSE_MODE = 2;
export const ERROR_MODE = 3;

// Values of DeviceDatamodeReq.mode.
export const DATAMODE_PUSH = 1;
export const DATAMODE_PULL = 2;

// Values of AddReplaceRuleReq.replace.
export const MSG_REPLACE_RULE_ACCEPT = 0;
export const MSG_REPLACE_RULE_REPLACE = 1;
export const MSG_REPLACE_RULE_IGNORE = 2;

/** The devices of a server. (player_device_devlist_t) */
export interface DeviceDevlist {
  /** In the order of creation, without player:0. */
  devices: common.Devaddr[];
}

export const DeviceDevlist: Codec<DeviceDevlist> = new Codec<DeviceDevlist>('player.DeviceDevlist', {
  zero: () => ({ devices: [] }),
  write(to, value) {
    to.length('devices', value.devices.length, 4096);
    to.length('devices', value.devices.length, 4096);
    for (const each of value.devices) common.Devaddr.write(to, each);
  },
  read(from) {
    from.uint32();
    const devices = from.many(from.length('devices', 4096, 16), () => common.Devaddr.read(from));
    return { devices };
  },
});

/** A device and the driver behind it. (player_device_driverinfo_t) */
export interface DeviceDriverinfo {
  /** The queried device. */
  addr: common.Devaddr;
  /** NUL-terminated; empty in the request. */
  driverName: Uint8Array;
}

export const DeviceDriverinfo: Codec<DeviceDriverinfo> = new Codec<DeviceDriverinfo>('player.DeviceDriverinfo', {
  zero: () => ({ addr: common.Devaddr.make(), driverName: new Uint8Array() }),
  write(to, value) {
    common.Devaddr.write(to, value.addr);
    to.length('driver_name', value.driverName.length, 64);
    to.length('driver_name', value.driverName.length, 64);
    to.opaque(value.driverName);
  },
  read(from) {
    const addr = common.Devaddr.read(from);
    from.uint32();
    const driverName = from.opaque(from.length('driver_name', 64, 1));
    return { addr, driverName };
  },
});

/** Request to open or close a device, and its answer. (player_device_req_t) */
export interface DeviceReq {
  /** The device; in the answer, completed with host and robot. */
  addr: common.Devaddr;
  /** Requested or granted access. */
  access: number;
  /** NUL-terminated; empty in the request. */
  driverName: Uint8Array;
}

export const DeviceReq: Codec<DeviceReq> = new Codec<DeviceReq>('player.DeviceReq', {
  zero: () => ({ addr: common.Devaddr.make(), access: 0, driverName: new Uint8Array() }),
  write(to, value) {
    common.Devaddr.write(to, value.addr);
    to.uint8(value.access);
    to.length('driver_name', value.driverName.length, 64);
    to.length('driver_name', value.driverName.length, 64);
    to.opaque(value.driverName);
  },
  read(from) {
    const addr = common.Devaddr.read(from);
    const access = from.uint8();
    from.uint32();
    const driverName = from.opaque(from.length('driver_name', 64, 1));
    return { addr, access, driverName };
  },
});

/** A delivery mode. (player_device_datamode_req_t) */
export interface DeviceDatamodeReq {
  /** Push or pull. */
  mode: number;
}

export const DeviceDatamodeReq: Codec<DeviceDatamodeReq> = new Codec<DeviceDatamodeReq>('player.DeviceDatamodeReq', {
  zero: () => ({ mode: 0 }),
  write(to, value) {
    to.uint8(value.mode);
  },
  read(from) {
    const mode = from.uint8();
    return { mode };
  },
});

/** A key. (player_device_auth_req_t) */
export interface DeviceAuthReq {
  authKey: Uint8Array;
}

export const DeviceAuthReq: Codec<DeviceAuthReq> = new Codec<DeviceAuthReq>('player.DeviceAuthReq', {
  zero: () => ({ authKey: new Uint8Array() }),
  write(to, value) {
    to.length('auth_key', value.authKey.length, 32);
    to.length('auth_key', value.authKey.length, 32);
    to.opaque(value.authKey);
  },
  read(from) {
    from.uint32();
    const authKey = from.opaque(from.length('auth_key', 32, 1));
    return { authKey };
  },
});

/** A robot's name and its port. (player_device_nameservice_req_t) */
export interface DeviceNameserviceReq {
  name: Uint8Array;
  /** 0 in the request. */
  port: number;
}

export const DeviceNameserviceReq: Codec<DeviceNameserviceReq> = new Codec<DeviceNameserviceReq>('player.DeviceNameserviceReq', {
  zero: () => ({ name: new Uint8Array(), port: 0 }),
  write(to, value) {
    to.length('name', value.name.length, 64);
    to.length('name', value.name.length, 64);
    to.opaque(value.name);
    to.uint16(value.port);
  },
  read(from) {
    from.uint32();
    const name = from.opaque(from.length('name', 64, 1));
    const port = from.uint16();
    return { name, port };
  },
});

/** Messages to which a rule applies, and its effect; -1 matches anything. (player_add_replace_rule_req_t) */
export interface AddReplaceRuleReq {
  /** Interface code, or -1. */
  interf: number;
  /** Device index, or -1. */
  index: number;
  /** Message type, or -1. */
  type: number;
  /** Message subtype, or -1. */
  subtype: number;
  /** Keep all, keep the newest, or drop. */
  replace: number;
}

export const AddReplaceRuleReq: Codec<AddReplaceRuleReq> = new Codec<AddReplaceRuleReq>('player.AddReplaceRuleReq', {
  zero: () => ({ interf: 0, index: 0, type: 0, subtype: 0, replace: 0 }),
  write(to, value) {
    to.int32(value.interf);
    to.int32(value.index);
    to.int32(value.type);
    to.int32(value.subtype);
    to.int32(value.replace);
  },
  read(from) {
    const interf = from.int32();
    const index = from.int32();
    const type = from.int32();
    const subtype = from.int32();
    const replace = from.int32();
    return { interf, index, type, subtype, replace };
  },
});

/** Lists the devices that this connection can open. */
export const REQ_DEVLIST: MessageType<DeviceDevlist> = new MessageType(
  1,
  Kind.REQ,
  1,
  'player.req.devlist',
  DeviceDevlist,
);

/** Requests the name of the driver behind a device. */
export const REQ_DRIVERINFO: MessageType<DeviceDriverinfo> = new MessageType(
  1,
  Kind.REQ,
  2,
  'player.req.driverinfo',
  DeviceDriverinfo,
);

/** Opens or closes a device; the answer has the granted access. */
export const REQ_DEV: MessageType<DeviceReq> = new MessageType(1, Kind.REQ, 3, 'player.req.dev', DeviceReq);

/** Requests one round of data, in pull mode; a synch ends the round. */
export const REQ_DATA: MessageType<undefined> = new MessageType(1, Kind.REQ, 4, 'player.req.data');

/** Selects the delivery mode: immediately (push) or on request (pull). */
export const REQ_DATAMODE: MessageType<DeviceDatamodeReq> = new MessageType(
  1,
  Kind.REQ,
  5,
  'player.req.datamode',
  DeviceDatamodeReq,
);

/**
 * Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it admits
 * nobody.
 */
export const REQ_AUTH: MessageType<DeviceAuthReq> = new MessageType(1, Kind.REQ, 7, 'player.req.auth', DeviceAuthReq);

/** Requests the port of a named robot; unused, answered by NACK. */
export const REQ_NAMESERVICE: MessageType<DeviceNameserviceReq> = new MessageType(
  1,
  Kind.REQ,
  8,
  'player.req.nameservice',
  DeviceNameserviceReq,
);

/** Adds a replace rule: which queued messages a newer one replaces. */
export const REQ_ADD_REPLACE_RULE: MessageType<AddReplaceRuleReq> = new MessageType(
  1,
  Kind.REQ,
  10,
  'player.req.add_replace_rule',
  AddReplaceRuleReq,
);

/** Ends a round of data; no message was dropped since the previous one. */
export const SYNCH_OK: MessageType<undefined> = new MessageType(1, Kind.SYNCH, 1, 'player.synch.ok');

/** Ends a round of data; the body is the number of messages dropped since the previous one. */
export const SYNCH_OVERFLOW: MessageType<common.Uint32> = new MessageType(
  1,
  Kind.SYNCH,
  2,
  'player.synch.overflow',
  common.Uint32,
);
