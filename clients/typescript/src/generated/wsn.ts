/**
 * Interface wsn, code 57. A network of wireless sensor nodes.
 *
 * Generated from interfaces/057_wsn.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 57;

/** Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t) */
export interface NodeData {
  /** In 1 or lx. */
  light: number;
  mic: number;
  /** In 1 or m/s^2. */
  accelX: number;
  /** In 1 or m/s^2. */
  accelY: number;
  /** In 1 or m/s^2. */
  accelZ: number;
  /** In 1 or G. */
  magnX: number;
  /** In 1 or G. */
  magnY: number;
  /** In 1 or G. */
  magnZ: number;
  /** In 1 or degC. */
  temperature: number;
  /** In 1 or V. */
  battery: number;
}

export const NodeData: Codec<NodeData> = new Codec<NodeData>('wsn.NodeData', {
  zero: () => ({
    light: 0,
    mic: 0,
    accelX: 0,
    accelY: 0,
    accelZ: 0,
    magnX: 0,
    magnY: 0,
    magnZ: 0,
    temperature: 0,
    battery: 0,
  }),
  write(to, value) {
    to.float32(value.light);
    to.float32(value.mic);
    to.float32(value.accelX);
    to.float32(value.accelY);
    to.float32(value.accelZ);
    to.float32(value.magnX);
    to.float32(value.magnY);
    to.float32(value.magnZ);
    to.float32(value.temperature);
    to.float32(value.battery);
  },
  read(from) {
    const light = from.float32();
    const mic = from.float32();
    const accelX = from.float32();
    const accelY = from.float32();
    const accelZ = from.float32();
    const magnX = from.float32();
    const magnY = from.float32();
    const magnZ = from.float32();
    const temperature = from.float32();
    const battery = from.float32();
    return { light, mic, accelX, accelY, accelZ, magnX, magnY, magnZ, temperature, battery };
  },
});

/** Readings of one node. (player_wsn_data_t) */
export interface Data {
  /** Type of node. */
  nodeType: number;
  /** Id of the node. */
  nodeId: number;
  /** Node that relayed the readings. */
  nodeParentId: number;
  dataPacket: NodeData;
}

export const Data: Codec<Data> = new Codec<Data>('wsn.Data', {
  zero: () => ({ nodeType: 0, nodeId: 0, nodeParentId: 0, dataPacket: NodeData.make() }),
  write(to, value) {
    to.uint32(value.nodeType);
    to.uint32(value.nodeId);
    to.uint32(value.nodeParentId);
    NodeData.write(to, value.dataPacket);
  },
  read(from) {
    const nodeType = from.uint32();
    const nodeId = from.uint32();
    const nodeParentId = from.uint32();
    const dataPacket = NodeData.read(from);
    return { nodeType, nodeId, nodeParentId, dataPacket };
  },
});

/** Switch of an actuator of a node. (player_wsn_cmd_t) */
export interface Cmd {
  /** Id of the node; -1: all. */
  nodeId: number;
  /** Group of the node; -1: all. */
  groupId: number;
  /** Actuator, such as a light or a buzzer. */
  device: number;
  /** 1: on, 0: off. */
  enable: number;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('wsn.Cmd', {
  zero: () => ({ nodeId: 0, groupId: 0, device: 0, enable: 0 }),
  write(to, value) {
    to.int32(value.nodeId);
    to.int32(value.groupId);
    to.uint32(value.device);
    to.uint8(value.enable);
  },
  read(from) {
    const nodeId = from.int32();
    const groupId = from.int32();
    const device = from.uint32();
    const enable = from.uint8();
    return { nodeId, groupId, device, enable };
  },
});

/** Sleep mode of nodes. (player_wsn_power_config_t) */
export interface PowerConfig {
  /** Id of the node; -1: all. */
  nodeId: number;
  /** Group of the node; -1: all. */
  groupId: number;
  /** 0: asleep, 1: awake, 2: driver-specific. */
  value: number;
}

export const PowerConfig: Codec<PowerConfig> = new Codec<PowerConfig>('wsn.PowerConfig', {
  zero: () => ({ nodeId: 0, groupId: 0, value: 0 }),
  write(to, value) {
    to.int32(value.nodeId);
    to.int32(value.groupId);
    to.uint8(value.value);
  },
  read(from) {
    const nodeId = from.int32();
    const groupId = from.int32();
    const value = from.uint8();
    return { nodeId, groupId, value };
  },
});

/** Format of readings. (player_wsn_datatype_config_t) */
export interface DatatypeConfig {
  /** 0: raw, 1: converted. */
  value: number;
}

export const DatatypeConfig: Codec<DatatypeConfig> = new Codec<DatatypeConfig>('wsn.DatatypeConfig', {
  zero: () => ({ value: 0 }),
  write(to, value) {
    to.uint8(value.value);
  },
  read(from) {
    const value = from.uint8();
    return { value };
  },
});

/** Rate of reports. (player_wsn_datafreq_config_t) */
export interface DatafreqConfig {
  /** Id of the node; -1: all. */
  nodeId: number;
  /** Group of the node; -1: all. */
  groupId: number;
  /** In Hz. */
  frequency: number;
}

export const DatafreqConfig: Codec<DatafreqConfig> = new Codec<DatafreqConfig>('wsn.DatafreqConfig', {
  zero: () => ({ nodeId: 0, groupId: 0, frequency: 0 }),
  write(to, value) {
    to.int32(value.nodeId);
    to.int32(value.groupId);
    to.float64(value.frequency);
  },
  read(from) {
    const nodeId = from.int32();
    const groupId = from.int32();
    const frequency = from.float64();
    return { nodeId, groupId, frequency };
  },
});

/** Readings of one node. */
export const DATA_STATE: MessageType<Data> = new MessageType(57, Kind.DATA, 1, 'wsn.data.state', Data);

/** Switches an actuator of a node. */
export const CMD_DEVSTATE: MessageType<Cmd> = new MessageType(57, Kind.CMD, 1, 'wsn.cmd.devstate', Cmd);

/** Puts nodes to sleep or wakes them. */
export const REQ_POWER: MessageType<PowerConfig> = new MessageType(57, Kind.REQ, 1, 'wsn.req.power', PowerConfig);

/** Selects between raw and converted readings. */
export const REQ_DATATYPE: MessageType<DatatypeConfig> = new MessageType(
  57,
  Kind.REQ,
  2,
  'wsn.req.datatype',
  DatatypeConfig,
);

/** Sets the reporting rate of nodes. */
export const REQ_DATAFREQ: MessageType<DatafreqConfig> = new MessageType(
  57,
  Kind.REQ,
  3,
  'wsn.req.datafreq',
  DatafreqConfig,
);
