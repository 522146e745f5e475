/** Interface power, code 2. Battery and charger of a robot. Generated from interfaces/002_power.toml by
 * codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_POWER_H
#define PLAYHOUSE_C_GENERATED_POWER_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_POWER_CODE 2

/** Bits of Data.valid: valid fields. */
enum {
  PH_POWER_MASK_VOLTS = 1,
  PH_POWER_MASK_WATTS = 2,
  PH_POWER_MASK_JOULES = 4,
  PH_POWER_MASK_PERCENT = 8,
  PH_POWER_MASK_CHARGING = 16,
};

/** State of charge; only the fields flagged in `valid` apply. (player_power_data_t) */
typedef struct ph_power_data {
  /** Bits of the valid fields. */
  uint32_t valid;
  /** In V. */
  float volts;
  /** Percentage of a full charge, 0 to 100 (in %). */
  float percent;
  /** Remaining energy (in J). */
  float joules;
  /** Power drawn from the battery; negative while charging (in W). */
  float watts;
  /** 1 charging, 0 not, -1 charging is impossible. */
  int32_t charging;
} ph_power_data;
PH_CODEC(ph_power_data)

/** Enabled flows of power. (player_power_chargepolicy_config_t) */
typedef struct ph_power_chargepolicy_config {
  /** 1: the battery may be charged. */
  uint8_t enable_input;
  /** 1: the battery may supply others. */
  uint8_t enable_output;
} ph_power_chargepolicy_config;
PH_CODEC(ph_power_chargepolicy_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_power_messages[2];
/** State of charge. */
#define PH_POWER_DATA_STATE (&ph_power_messages[0])
/** Enables or disables charging and discharging of the battery. */
#define PH_POWER_REQ_SET_CHARGING_POLICY (&ph_power_messages[1])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_POWER_H */
