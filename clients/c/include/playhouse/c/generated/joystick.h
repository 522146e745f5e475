/** Interface joystick, code 49. A joystick or gamepad. Generated from interfaces/049_joystick.toml by
 * codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_JOYSTICK_H
#define PLAYHOUSE_C_GENERATED_JOYSTICK_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_JOYSTICK_CODE 49

/** Sticks and buttons. (player_joystick_data_t) */
typedef struct ph_joystick_data {
  /** One per axis, from -scale to scale. */
  int32_t pos[8];
  /** Maximum value per axis. */
  int32_t scale[8];
  /** One bit per button, the first in the lowest bit. */
  uint32_t buttons;
  /** Number of axes. */
  uint32_t axes_count;
} ph_joystick_data;
PH_CODEC(ph_joystick_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_joystick_messages[1];
/** Sticks and buttons. */
#define PH_JOYSTICK_DATA_STATE (&ph_joystick_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_JOYSTICK_H */
