/** Interface aio, code 21. Analog inputs and outputs. Generated from interfaces/021_aio.toml by codegen;
 * do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_AIO_H
#define PLAYHOUSE_C_GENERATED_AIO_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_AIO_CODE 21

/** Voltages of the inputs. (player_aio_data_t) */
typedef struct ph_aio_data {
  /** In V. */
  const float *voltages;
  uint32_t voltages_count;
} ph_aio_data;
PH_CODEC(ph_aio_data)

/** Commanded voltage of one output. (player_aio_cmd_t) */
typedef struct ph_aio_cmd {
  /** Index of the output. */
  uint32_t id;
  /** In V. */
  float voltage;
} ph_aio_cmd;
PH_CODEC(ph_aio_cmd)

/** The messages, each under its name below. */
extern const ph_message_type ph_aio_messages[2];
/** Voltages of the inputs. */
#define PH_AIO_DATA_STATE (&ph_aio_messages[0])
/** Commanded voltage of one output. */
#define PH_AIO_CMD_STATE (&ph_aio_messages[1])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_AIO_H */
