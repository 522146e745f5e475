/**
 * Interface power, code 2. Battery and charger of a robot.
 *
 * Generated from interfaces/002_power.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 2;

// Bits of Data.valid: valid fields.
export const MASK_VOLTS = 1;
export const MASK_WATTS = 2;
export const MASK_JOULES = 4;
export const MASK_PERCENT = 8;
export const MASK_CHARGING = 16;

/** State of charge; only the fields flagged in `valid` apply. (player_power_data_t) */
export interface Data {
  /** Bits of the valid fields. */
  valid: number;
  /** In V. */
  volts: number;
  /** Percentage of a full charge, 0 to 100 (in %). */
  percent: number;
  /** Remaining energy (in J). */
  joules: number;
  /** Power drawn from the battery; negative while charging (in W). */
  watts: number;
  /** 1 charging, 0 not, -1 charging is impossible. */
  charging: number;
}

export const Data: Codec<Data> = new Codec<Data>('power.Data', {
  zero: () => ({ valid: 0, volts: 0, percent: 0, joules: 0, watts: 0, charging: 0 }),
  write(to, value) {
    to.uint32(value.valid);
    to.float32(value.volts);
    to.float32(value.percent);
    to.float32(value.joules);
    to.float32(value.watts);
    to.int32(value.charging);
  },
  read(from) {
    const valid = from.uint32();
    const volts = from.float32();
    const percent = from.float32();
    const joules = from.float32();
    const watts = from.float32();
    const charging = from.int32();
    return { valid, volts, percent, joules, watts, charging };
  },
});

/** Enabled flows of power. (player_power_chargepolicy_config_t) */
export interface ChargepolicyConfig {
  /** 1: the battery may be charged. */
  enableInput: number;
  /** 1: the battery may supply others. */
  enableOutput: number;
}

export const ChargepolicyConfig: Codec<ChargepolicyConfig> = new Codec<ChargepolicyConfig>('power.ChargepolicyConfig', {
  zero: () => ({ enableInput: 0, enableOutput: 0 }),
  write(to, value) {
    to.uint8(value.enableInput);
    to.uint8(value.enableOutput);
  },
  read(from) {
    const enableInput = from.uint8();
    const enableOutput = from.uint8();
    return { enableInput, enableOutput };
  },
});

/** State of charge. */
export const DATA_STATE: MessageType<Data> = new MessageType(2, Kind.DATA, 1, 'power.data.state', Data);

/** Enables or disables charging and discharging of the battery. */
export const REQ_SET_CHARGING_POLICY: MessageType<ChargepolicyConfig> = new MessageType(
  2,
  Kind.REQ,
  1,
  'power.req.set_charging_policy',
  ChargepolicyConfig,
);
