/**
 * Interface wifi, code 23. State of wireless network links.
 *
 * Generated from interfaces/023_wifi.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 23;

// Values of Data.qual_type: unit of link quality.
export const QUAL_DBM = 1;
export const QUAL_REL = 2;
export const QUAL_UNKNOWN = 3;

// Values of Data.mode and Link.mode.
export const MODE_UNKNOWN = 0;
export const MODE_AUTO = 1;
export const MODE_ADHOC = 2;
export const MODE_INFRA = 3;
export const MODE_MASTER = 4;
export const MODE_REPEAT = 5;
export const MODE_SECOND = 6;

/** One link. (player_wifi_link_t) */
export interface Link {
  /** Hardware address, as a string. */
  mac: Uint8Array;
  /** Network address, as a string. */
  ip: Uint8Array;
  /** Name of the network, as a string. */
  essid: Uint8Array;
  /** Role in the network. */
  mode: number;
  /** In MHz. */
  freq: number;
  /** 0: open, else encrypted. */
  encrypt: number;
  /** Quality, up to Data.maxqual. */
  qual: number;
  /** Signal, up to Data.maxlevel (signed). */
  level: number;
  /** Noise, up to Data.maxnoise (signed). */
  noise: number;
}

export const Link: Codec<Link> = new Codec<Link>('wifi.Link', {
  zero: () => ({
    mac: new Uint8Array(),
    ip: new Uint8Array(),
    essid: new Uint8Array(),
    mode: 0,
    freq: 0,
    encrypt: 0,
    qual: 0,
    level: 0,
    noise: 0,
  }),
  write(to, value) {
    to.length('mac', value.mac.length, 32);
    to.length('mac', value.mac.length, 32);
    to.opaque(value.mac);
    to.length('ip', value.ip.length, 32);
    to.length('ip', value.ip.length, 32);
    to.opaque(value.ip);
    to.length('essid', value.essid.length, 32);
    to.length('essid', value.essid.length, 32);
    to.opaque(value.essid);
    to.uint32(value.mode);
    to.uint32(value.freq);
    to.uint32(value.encrypt);
    to.uint32(value.qual);
    to.int32(value.level);
    to.int32(value.noise);
  },
  read(from) {
    from.uint32();
    const mac = from.opaque(from.length('mac', 32, 1));
    from.uint32();
    const ip = from.opaque(from.length('ip', 32, 1));
    from.uint32();
    const essid = from.opaque(from.length('essid', 32, 1));
    const mode = from.uint32();
    const freq = from.uint32();
    const encrypt = from.uint32();
    const qual = from.uint32();
    const level = from.int32();
    const noise = from.int32();
    return { mac, ip, essid, mode, freq, encrypt, qual, level, noise };
  },
});

/** Every link and the state of the card. (player_wifi_data_t) */
export interface Data {
  links: Link[];
  /** Estimated throughput of the card (in bit/s). */
  throughput: number;
  /** Configured bit rate of the card (in bit/s). */
  bitrate: number;
  /** Role in the network. */
  mode: number;
  /** Unit of quality, level and noise. */
  qualType: number;
  /** Maximum reported quality. */
  maxqual: number;
  /** Maximum reported signal level (signed). */
  maxlevel: number;
  /** Maximum reported noise level (signed). */
  maxnoise: number;
  /** Hardware address of the access point, as a string. */
  ap: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('wifi.Data', {
  zero: () => ({
    links: [],
    throughput: 0,
    bitrate: 0,
    mode: 0,
    qualType: 0,
    maxqual: 0,
    maxlevel: 0,
    maxnoise: 0,
    ap: new Uint8Array(),
  }),
  write(to, value) {
    to.length('links', value.links.length, 699049);
    to.length('links', value.links.length, 699049);
    for (const each of value.links) Link.write(to, each);
    to.uint32(value.throughput);
    to.uint32(value.bitrate);
    to.uint32(value.mode);
    to.uint32(value.qualType);
    to.uint32(value.maxqual);
    to.int32(value.maxlevel);
    to.int32(value.maxnoise);
    to.fixed('ap', value.ap, 32);
  },
  read(from) {
    const linksCount = from.uint32();
    const links = from.many(from.length('links', linksCount, 48), () => Link.read(from));
    const throughput = from.uint32();
    const bitrate = from.uint32();
    const mode = from.uint32();
    const qualType = from.uint32();
    const maxqual = from.uint32();
    const maxlevel = from.int32();
    const maxnoise = from.int32();
    const ap = from.opaque(32);
    return { links, throughput, bitrate, mode, qualType, maxqual, maxlevel, maxnoise, ap };
  },
});

/** The card's own address. (player_wifi_mac_req_t) */
export interface MacReq {
  /** Hardware address, as a string. */
  mac: Uint8Array;
}

export const MacReq: Codec<MacReq> = new Codec<MacReq>('wifi.MacReq', {
  zero: () => ({ mac: new Uint8Array() }),
  write(to, value) {
    to.length('mac', value.mac.length, 32);
    to.length('mac', value.mac.length, 32);
    to.opaque(value.mac);
  },
  read(from) {
    from.uint32();
    const mac = from.opaque(from.length('mac', 32, 1));
    return { mac };
  },
});

/** The address of a station. (player_wifi_iwspy_addr_req_t) */
export interface IwspyAddrReq {
  /** Hardware address, as a string. */
  address: Uint8Array;
}

export const IwspyAddrReq: Codec<IwspyAddrReq> = new Codec<IwspyAddrReq>('wifi.IwspyAddrReq', {
  zero: () => ({ address: new Uint8Array() }),
  write(to, value) {
    to.fixed('address', value.address, 32);
  },
  read(from) {
    const address = from.opaque(32);
    return { address };
  },
});

/** Requests the card's own address. */
export const REQ_MAC: MessageType<MacReq> = new MessageType(23, Kind.REQ, 1, 'wifi.req.mac', MacReq);

/** Starts monitoring the links to an address. */
export const REQ_IWSPY_ADD: MessageType<IwspyAddrReq> = new MessageType(
  23,
  Kind.REQ,
  2,
  'wifi.req.iwspy_add',
  IwspyAddrReq,
);

/** Stops monitoring the links to an address. */
export const REQ_IWSPY_DEL: MessageType<IwspyAddrReq> = new MessageType(
  23,
  Kind.REQ,
  3,
  'wifi.req.iwspy_del',
  IwspyAddrReq,
);

/** Sends a packet to an address to measure its link. */
export const REQ_IWSPY_PING: MessageType<IwspyAddrReq> = new MessageType(
  23,
  Kind.REQ,
  4,
  'wifi.req.iwspy_ping',
  IwspyAddrReq,
);

/** Every link and the state of the card. */
export const DATA_STATE: MessageType<Data> = new MessageType(23, Kind.DATA, 1, 'wifi.data.state', Data);
