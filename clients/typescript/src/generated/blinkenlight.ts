/**
 * Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink.
 *
 * Generated from interfaces/033_blinkenlight.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 33;

/** State of the light. (player_blinkenlight_data_t) */
export interface Data {
  /** 1: on, 0: off. */
  enable: number;
  /** Blinking period; 0: steady light (in s). */
  period: number;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  dutycycle: number;
  color: common.Color;
}

export const Data: Codec<Data> = new Codec<Data>('blinkenlight.Data', {
  zero: () => ({ enable: 0, period: 0, dutycycle: 0, color: common.Color.make() }),
  write(to, value) {
    to.uint8(value.enable);
    to.float32(value.period);
    to.float32(value.dutycycle);
    common.Color.write(to, value.color);
  },
  read(from) {
    const enable = from.uint8();
    const period = from.float32();
    const dutycycle = from.float32();
    const color = common.Color.read(from);
    return { enable, period, dutycycle, color };
  },
});

/** Commanded state of one light. (player_blinkenlight_cmd_t) */
export interface Cmd {
  /** Index of the light. */
  id: number;
  /** 1: on, 0: off. */
  enable: number;
  /** Blinking period; 0: steady light (in s). */
  period: number;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  dutycycle: number;
  color: common.Color;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('blinkenlight.Cmd', {
  zero: () => ({ id: 0, enable: 0, period: 0, dutycycle: 0, color: common.Color.make() }),
  write(to, value) {
    to.uint16(value.id);
    to.uint8(value.enable);
    to.float32(value.period);
    to.float32(value.dutycycle);
    common.Color.write(to, value.color);
  },
  read(from) {
    const id = from.uint16();
    const enable = from.uint8();
    const period = from.float32();
    const dutycycle = from.float32();
    const color = common.Color.read(from);
    return { id, enable, period, dutycycle, color };
  },
});

/** Switch of one light. (player_blinkenlight_cmd_power_t) */
export interface CmdPower {
  /** Index of the light. */
  id: number;
  /** 1: on, 0: off. */
  enable: number;
}

export const CmdPower: Codec<CmdPower> = new Codec<CmdPower>('blinkenlight.CmdPower', {
  zero: () => ({ id: 0, enable: 0 }),
  write(to, value) {
    to.uint16(value.id);
    to.uint8(value.enable);
  },
  read(from) {
    const id = from.uint16();
    const enable = from.uint8();
    return { id, enable };
  },
});

/** Color of one light. (player_blinkenlight_cmd_color_t) */
export interface CmdColor {
  /** Index of the light. */
  id: number;
  color: common.Color;
}

export const CmdColor: Codec<CmdColor> = new Codec<CmdColor>('blinkenlight.CmdColor', {
  zero: () => ({ id: 0, color: common.Color.make() }),
  write(to, value) {
    to.uint16(value.id);
    common.Color.write(to, value.color);
  },
  read(from) {
    const id = from.uint16();
    const color = common.Color.read(from);
    return { id, color };
  },
});

/** Blinking of one light. (player_blinkenlight_cmd_flash_t) */
export interface CmdFlash {
  /** Index of the light. */
  id: number;
  /** Blinking period (in s). */
  period: number;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  dutycycle: number;
}

export const CmdFlash: Codec<CmdFlash> = new Codec<CmdFlash>('blinkenlight.CmdFlash', {
  zero: () => ({ id: 0, period: 0, dutycycle: 0 }),
  write(to, value) {
    to.uint16(value.id);
    to.float32(value.period);
    to.float32(value.dutycycle);
  },
  read(from) {
    const id = from.uint16();
    const period = from.float32();
    const dutycycle = from.float32();
    return { id, period, dutycycle };
  },
});

/** State of the light. */
export const DATA_STATE: MessageType<Data> = new MessageType(33, Kind.DATA, 1, 'blinkenlight.data.state', Data);

/** Sets all properties of one light. */
export const CMD_STATE: MessageType<Cmd> = new MessageType(33, Kind.CMD, 1, 'blinkenlight.cmd.state', Cmd);

/** Switches one light. */
export const CMD_POWER: MessageType<CmdPower> = new MessageType(33, Kind.CMD, 2, 'blinkenlight.cmd.power', CmdPower);

/** Colors one light. */
export const CMD_COLOR: MessageType<CmdColor> = new MessageType(33, Kind.CMD, 3, 'blinkenlight.cmd.color', CmdColor);

/** Makes one light blink. */
export const CMD_FLASH: MessageType<CmdFlash> = new MessageType(33, Kind.CMD, 4, 'blinkenlight.cmd.flash', CmdFlash);
