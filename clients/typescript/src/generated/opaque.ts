/**
 * Interface opaque, code 51. Opaque bytes, defined by the driver and its clients.
 *
 * Generated from interfaces/051_opaque.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 51;

// Subtypes under their older names.
export const REQ = 1;
export const CMD = 1;

/** Opaque bytes. (player_opaque_data_t) */
export interface Data {
  data: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('opaque.Data', {
  zero: () => ({ data: new Uint8Array() }),
  write(to, value) {
    to.length('data', value.data.length, 33554392);
    to.length('data', value.data.length, 33554392);
    to.opaque(value.data);
  },
  read(from) {
    const dataCount = from.uint32();
    const data = from.opaque(from.length('data', dataCount, 1));
    return { data };
  },
});

/** Bytes from the driver. */
export const DATA_STATE: MessageType<Data> = new MessageType(51, Kind.DATA, 1, 'opaque.data.state', Data);

/** Bytes for the driver. */
export const CMD_DATA: MessageType<Data> = new MessageType(51, Kind.CMD, 1, 'opaque.cmd.data', Data);

/** Bytes for the driver, which answers with bytes. */
export const REQ_DATA: MessageType<Data> = new MessageType(51, Kind.REQ, 1, 'opaque.req.data', Data);
