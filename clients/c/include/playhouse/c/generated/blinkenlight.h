/** Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink. Generated from
 * interfaces/033_blinkenlight.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_BLINKENLIGHT_H
#define PLAYHOUSE_C_GENERATED_BLINKENLIGHT_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_BLINKENLIGHT_CODE 33

/** State of the light. (player_blinkenlight_data_t) */
typedef struct ph_blinkenlight_data {
  /** 1: on, 0: off. */
  uint8_t enable;
  /** Blinking period; 0: steady light (in s). */
  float period;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  float dutycycle;
  ph_common_color color;
} ph_blinkenlight_data;
PH_CODEC(ph_blinkenlight_data)

/** Commanded state of one light. (player_blinkenlight_cmd_t) */
typedef struct ph_blinkenlight_cmd {
  /** Index of the light. */
  uint16_t id;
  /** 1: on, 0: off. */
  uint8_t enable;
  /** Blinking period; 0: steady light (in s). */
  float period;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  float dutycycle;
  ph_common_color color;
} ph_blinkenlight_cmd;
PH_CODEC(ph_blinkenlight_cmd)

/** Switch of one light. (player_blinkenlight_cmd_power_t) */
typedef struct ph_blinkenlight_cmd_power {
  /** Index of the light. */
  uint16_t id;
  /** 1: on, 0: off. */
  uint8_t enable;
} ph_blinkenlight_cmd_power;
PH_CODEC(ph_blinkenlight_cmd_power)

/** Color of one light. (player_blinkenlight_cmd_color_t) */
typedef struct ph_blinkenlight_cmd_color {
  /** Index of the light. */
  uint16_t id;
  ph_common_color color;
} ph_blinkenlight_cmd_color;
PH_CODEC(ph_blinkenlight_cmd_color)

/** Blinking of one light. (player_blinkenlight_cmd_flash_t) */
typedef struct ph_blinkenlight_cmd_flash {
  /** Index of the light. */
  uint16_t id;
  /** Blinking period (in s). */
  float period;
  /** Duty cycle: fraction of the period in which the light is on, 0 to 1. */
  float dutycycle;
} ph_blinkenlight_cmd_flash;
PH_CODEC(ph_blinkenlight_cmd_flash)

/** The messages, each under its name below. */
extern const ph_message_type ph_blinkenlight_messages[5];
/** State of the light. */
#define PH_BLINKENLIGHT_DATA_STATE (&ph_blinkenlight_messages[0])
/** Sets all properties of one light. */
#define PH_BLINKENLIGHT_CMD_STATE (&ph_blinkenlight_messages[1])
/** Switches one light. */
#define PH_BLINKENLIGHT_CMD_POWER (&ph_blinkenlight_messages[2])
/** Colors one light. */
#define PH_BLINKENLIGHT_CMD_COLOR (&ph_blinkenlight_messages[3])
/** Makes one light blink. */
#define PH_BLINKENLIGHT_CMD_FLASH (&ph_blinkenlight_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_BLINKENLIGHT_H */
