/**
 * Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that report to each
 * other.
 *
 * Generated from interfaces/066_coopobject.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 66;

// Values of Header.origin.
export const ORIGIN_STATICBASE = 0;
export const ORIGIN_MOBILEBASE = 1;
export const ORIGIN_MOTE = 2;
export const ORIGIN_ROBOT = 3;

// Types of messages between nodes.
export const MSG_NONE = -1;
export const MSG_HEALTH = 0;
export const MSG_POSITION = 1;
export const MSG_RSSI = 2;
export const MSG_SENSOR = 3;
export const MSG_ALARM = 4;
export const MSG_REQUEST = 5;
export const MSG_COMMAND = 6;

// Values of Sensor.type.
export const TEMPERATURE = 0;
export const HUMIDITY = 1;
export const PRESSURE = 2;
export const LIGHT_1 = 3;
export const LIGHT_2 = 4;
export const ACCEL_X = 5;
export const ACCEL_Y = 6;
export const ACCEL_Z = 7;
export const MAGNETOMETER_X = 8;
export const MAGNETOMETER_Y = 9;
export const MAGNETOMETER_Z = 10;
export const COMPASS = 11;
export const CO = 12;
export const CO2 = 13;
export const H2 = 14;
export const SMOKE = 15;
export const OPTSWITCH = 16;

/** Id of the node. (player_coopobject_header_t) */
export interface Header {
  /** Type of node. */
  origin: number;
  id: number;
  /** Node that relayed the message. */
  parentId: number;
}

export const Header: Codec<Header> = new Codec<Header>('coopobject.Header', {
  zero: () => ({ origin: 0, id: 0, parentId: 0 }),
  write(to, value) {
    to.uint8(value.origin);
    to.uint16(value.id);
    to.uint16(value.parentId);
  },
  read(from) {
    const origin = from.uint8();
    const id = from.uint16();
    const parentId = from.uint16();
    return { origin, id, parentId };
  },
});

/** Radio signal strength. (player_coopobject_rssi_t) */
export interface Rssi {
  header: Header;
  /** Node that sent the signal. */
  senderId: number;
  /** As the radio reports it. */
  rssi: number;
  /** Counter of measurements. */
  stamp: number;
  /** Clock of the node: upper half. */
  nodeTimeHigh: number;
  /** Clock of the node: lower half. */
  nodeTimeLow: number;
  /** Position of the receiver (in m, frame p_WS). */
  x: number;
  /** In m, frame p_WS. */
  y: number;
  /** In m, frame p_WS. */
  z: number;
}

export const Rssi: Codec<Rssi> = new Codec<Rssi>('coopobject.Rssi', {
  zero: () => ({
    header: Header.make(),
    senderId: 0,
    rssi: 0,
    stamp: 0,
    nodeTimeHigh: 0,
    nodeTimeLow: 0,
    x: 0,
    y: 0,
    z: 0,
  }),
  write(to, value) {
    Header.write(to, value.header);
    to.uint16(value.senderId);
    to.uint16(value.rssi);
    to.uint16(value.stamp);
    to.uint32(value.nodeTimeHigh);
    to.uint32(value.nodeTimeLow);
    to.float32(value.x);
    to.float32(value.y);
    to.float32(value.z);
  },
  read(from) {
    const header = Header.read(from);
    const senderId = from.uint16();
    const rssi = from.uint16();
    const stamp = from.uint16();
    const nodeTimeHigh = from.uint32();
    const nodeTimeLow = from.uint32();
    const x = from.float32();
    const y = from.float32();
    const z = from.float32();
    return { header, senderId, rssi, stamp, nodeTimeHigh, nodeTimeLow, x, y, z };
  },
});

/** Position of a node. (player_coopobject_position_t) */
export interface Position {
  header: Header;
  /** In m, frame p_WS. */
  x: number;
  /** In m, frame p_WS. */
  y: number;
  /** In m, frame p_WS. */
  z: number;
  /** Driver-specific. */
  status: number;
}

export const Position: Codec<Position> = new Codec<Position>('coopobject.Position', {
  zero: () => ({ header: Header.make(), x: 0, y: 0, z: 0, status: 0 }),
  write(to, value) {
    Header.write(to, value.header);
    to.float32(value.x);
    to.float32(value.y);
    to.float32(value.z);
    to.uint8(value.status);
  },
  read(from) {
    const header = Header.read(from);
    const x = from.float32();
    const y = from.float32();
    const z = from.float32();
    const status = from.uint8();
    return { header, x, y, z, status };
  },
});

/** One reading. (player_coopobject_sensor_t) */
export interface Sensor {
  /** Measured quantity. */
  type: number;
  /** As the sensor reports it. */
  value: number;
}

export const Sensor: Codec<Sensor> = new Codec<Sensor>('coopobject.Sensor', {
  zero: () => ({ type: 0, value: 0 }),
  write(to, value) {
    to.uint8(value.type);
    to.int16(value.value);
  },
  read(from) {
    const type = from.uint8();
    const value = from.int16();
    return { type, value };
  },
});

/** Readings of a node. (player_coopobject_data_sensor_t) */
export interface DataSensor {
  header: Header;
  data: Sensor[];
}

export const DataSensor: Codec<DataSensor> = new Codec<DataSensor>('coopobject.DataSensor', {
  zero: () => ({ header: Header.make(), data: [] }),
  write(to, value) {
    Header.write(to, value.header);
    to.length('data', value.data.length, 4194299);
    to.length('data', value.data.length, 4194299);
    for (const each of value.data) Sensor.write(to, each);
  },
  read(from) {
    const header = Header.read(from);
    const dataCount = from.uint32();
    const data = from.many(from.length('data', dataCount, 8), () => Sensor.read(from));
    return { header, data };
  },
});

/** Bytes from or to a node. (player_coopobject_data_userdefined_t) */
export interface DataUserdefined {
  header: Header;
  /** User-specific. */
  type: number;
  data: Uint8Array;
}

export const DataUserdefined: Codec<DataUserdefined> = new Codec<DataUserdefined>('coopobject.DataUserdefined', {
  zero: () => ({ header: Header.make(), type: 0, data: new Uint8Array() }),
  write(to, value) {
    Header.write(to, value.header);
    to.uint8(value.type);
    to.length('data', value.data.length, 33554392);
    to.length('data', value.data.length, 33554392);
    to.opaque(value.data);
  },
  read(from) {
    const header = Header.read(from);
    const type = from.uint8();
    const dataCount = from.uint32();
    const data = from.opaque(from.length('data', dataCount, 1));
    return { header, type, data };
  },
});

/** A request. (player_coopobject_req_t) */
export interface Req {
  header: Header;
  /** Which. */
  request: number;
  /** Request-specific. */
  parameters: Uint8Array;
}

export const Req: Codec<Req> = new Codec<Req>('coopobject.Req', {
  zero: () => ({ header: Header.make(), request: 0, parameters: new Uint8Array() }),
  write(to, value) {
    Header.write(to, value.header);
    to.uint8(value.request);
    to.length('parameters', value.parameters.length, 33554392);
    to.length('parameters', value.parameters.length, 33554392);
    to.opaque(value.parameters);
  },
  read(from) {
    const header = Header.read(from);
    const request = from.uint8();
    const parametersCount = from.uint32();
    const parameters = from.opaque(from.length('parameters', parametersCount, 1));
    return { header, request, parameters };
  },
});

/** A command. (player_coopobject_cmd_t) */
export interface Cmd {
  header: Header;
  /** Which. */
  command: number;
  /** Command-specific. */
  parameters: Uint8Array;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('coopobject.Cmd', {
  zero: () => ({ header: Header.make(), command: 0, parameters: new Uint8Array() }),
  write(to, value) {
    Header.write(to, value.header);
    to.uint8(value.command);
    to.length('parameters', value.parameters.length, 33554392);
    to.length('parameters', value.parameters.length, 33554392);
    to.opaque(value.parameters);
  },
  read(from) {
    const header = Header.read(from);
    const command = from.uint8();
    const parametersCount = from.uint32();
    const parameters = from.opaque(from.length('parameters', parametersCount, 1));
    return { header, command, parameters };
  },
});

/** A node is alive. */
export const DATA_HEALTH: MessageType<Header> = new MessageType(66, Kind.DATA, 1, 'coopobject.data.health', Header);

/** Signal strength received by a node. */
export const DATA_RSSI: MessageType<Rssi> = new MessageType(66, Kind.DATA, 2, 'coopobject.data.rssi', Rssi);

/** Readings of a node. */
export const DATA_SENSOR: MessageType<DataSensor> = new MessageType(
  66,
  Kind.DATA,
  3,
  'coopobject.data.sensor',
  DataSensor,
);

/** Readings of a node that crossed a threshold. */
export const DATA_ALARM: MessageType<DataSensor> = new MessageType(
  66,
  Kind.DATA,
  4,
  'coopobject.data.alarm',
  DataSensor,
);

/** Bytes from a node. */
export const DATA_USERDEFINED: MessageType<DataUserdefined> = new MessageType(
  66,
  Kind.DATA,
  5,
  'coopobject.data.userdefined',
  DataUserdefined,
);

/** A request of a node. */
export const DATA_REQUEST: MessageType<Req> = new MessageType(66, Kind.DATA, 6, 'coopobject.data.request', Req);

/** A command of a node. */
export const DATA_COMMAND: MessageType<Cmd> = new MessageType(66, Kind.DATA, 7, 'coopobject.data.command', Cmd);

/** Position of a node. */
export const DATA_POSITION: MessageType<Position> = new MessageType(
  66,
  Kind.DATA,
  8,
  'coopobject.data.position',
  Position,
);

/** Sends a command to a node. */
export const CMD_STANDARD: MessageType<Cmd> = new MessageType(66, Kind.CMD, 1, 'coopobject.cmd.standard', Cmd);

/** Sends bytes to a node. */
export const CMD_DATA: MessageType<DataUserdefined> = new MessageType(
  66,
  Kind.CMD,
  2,
  'coopobject.cmd.data',
  DataUserdefined,
);

/** Sends the position of a node to a node. */
export const CMD_POSITION: MessageType<Position> = new MessageType(
  66,
  Kind.CMD,
  3,
  'coopobject.cmd.position',
  Position,
);

/** Sends a request to a node. */
export const REQ_STANDARD: MessageType<Req> = new MessageType(66, Kind.REQ, 1, 'coopobject.req.standard', Req);
