/**
 * Interface dio, code 20. Digital inputs and outputs.
 *
 * Generated from interfaces/020_dio.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 20;

/** State of the inputs. (player_dio_data_t) */
export interface Data {
  /** Number of valid bits. */
  count: number;
  /** One bit per input, the first in the lowest bit. */
  bits: number;
}

export const Data: Codec<Data> = new Codec<Data>('dio.Data', {
  zero: () => ({ count: 0, bits: 0 }),
  write(to, value) {
    to.uint32(value.count);
    to.uint32(value.bits);
  },
  read(from) {
    const count = from.uint32();
    const bits = from.uint32();
    return { count, bits };
  },
});

/** Commanded state of the outputs. (player_dio_cmd_t) */
export interface Cmd {
  /** Number of valid bits. */
  count: number;
  /** One bit per output, the first in the lowest bit. */
  digout: number;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('dio.Cmd', {
  zero: () => ({ count: 0, digout: 0 }),
  write(to, value) {
    to.uint32(value.count);
    to.uint32(value.digout);
  },
  read(from) {
    const count = from.uint32();
    const digout = from.uint32();
    return { count, digout };
  },
});

/** State of the inputs. */
export const DATA_VALUES: MessageType<Data> = new MessageType(20, Kind.DATA, 1, 'dio.data.values', Data);

/** Commanded state of the outputs. */
export const CMD_VALUES: MessageType<Cmd> = new MessageType(20, Kind.CMD, 1, 'dio.cmd.values', Cmd);
