/**
 * Interface joystick, code 49. A joystick or gamepad.
 *
 * Generated from interfaces/049_joystick.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 49;

/** Sticks and buttons. (player_joystick_data_t) */
export interface Data {
  /** One per axis, from -scale to scale. */
  pos: number[];
  /** Maximum value per axis. */
  scale: number[];
  /** One bit per button, the first in the lowest bit. */
  buttons: number;
  /** Number of axes. */
  axesCount: number;
}

export const Data: Codec<Data> = new Codec<Data>('joystick.Data', {
  zero: () => ({
    pos: Array.from({ length: 8 }, () => 0),
    scale: Array.from({ length: 8 }, () => 0),
    buttons: 0,
    axesCount: 0,
  }),
  write(to, value) {
    to.exactly('pos', value.pos.length, 8);
    for (const each of value.pos) to.int32(each);
    to.exactly('scale', value.scale.length, 8);
    for (const each of value.scale) to.int32(each);
    to.uint32(value.buttons);
    to.uint32(value.axesCount);
  },
  read(from) {
    const pos = from.many(8, () => from.int32());
    const scale = from.many(8, () => from.int32());
    const buttons = from.uint32();
    const axesCount = from.uint32();
    return { pos, scale, buttons, axesCount };
  },
});

/** Sticks and buttons. */
export const DATA_STATE: MessageType<Data> = new MessageType(49, Kind.DATA, 1, 'joystick.data.state', Data);
