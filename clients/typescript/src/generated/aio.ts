/**
 * Interface aio, code 21. Analog inputs and outputs.
 *
 * Generated from interfaces/021_aio.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 21;

/** Voltages of the inputs. (player_aio_data_t) */
export interface Data {
  /** In V. */
  voltages: Float32Array;
}

export const Data: Codec<Data> = new Codec<Data>('aio.Data', {
  zero: () => ({ voltages: new Float32Array() }),
  write(to, value) {
    to.length('voltages', value.voltages.length, 8388598);
    to.length('voltages', value.voltages.length, 8388598);
    to.float32s(value.voltages);
  },
  read(from) {
    const voltagesCount = from.uint32();
    const voltages = from.float32s(from.length('voltages', voltagesCount, 4));
    return { voltages };
  },
});

/** Commanded voltage of one output. (player_aio_cmd_t) */
export interface Cmd {
  /** Index of the output. */
  id: number;
  /** In V. */
  voltage: number;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('aio.Cmd', {
  zero: () => ({ id: 0, voltage: 0 }),
  write(to, value) {
    to.uint32(value.id);
    to.float32(value.voltage);
  },
  read(from) {
    const id = from.uint32();
    const voltage = from.float32();
    return { id, voltage };
  },
});

/** Commanded voltage of one output. */
export const CMD_STATE: MessageType<Cmd> = new MessageType(21, Kind.CMD, 1, 'aio.cmd.state', Cmd);

/** Voltages of the inputs. */
export const DATA_STATE: MessageType<Data> = new MessageType(21, Kind.DATA, 1, 'aio.data.state', Data);
