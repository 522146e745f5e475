/** Interface dio, code 20. Digital inputs and outputs. Generated from interfaces/020_dio.toml by codegen;
 * do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_DIO_H
#define PLAYHOUSE_C_GENERATED_DIO_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_DIO_CODE 20

/** State of the inputs. (player_dio_data_t) */
typedef struct ph_dio_data {
  /** Number of valid bits. */
  uint32_t count;
  /** One bit per input, the first in the lowest bit. */
  uint32_t bits;
} ph_dio_data;
PH_CODEC(ph_dio_data)

/** Commanded state of the outputs. (player_dio_cmd_t) */
typedef struct ph_dio_cmd {
  /** Number of valid bits. */
  uint32_t count;
  /** One bit per output, the first in the lowest bit. */
  uint32_t digout;
} ph_dio_cmd;
PH_CODEC(ph_dio_cmd)

/** The messages, each under its name below. */
extern const ph_message_type ph_dio_messages[2];
/** State of the inputs. */
#define PH_DIO_DATA_VALUES (&ph_dio_messages[0])
/** Commanded state of the outputs. */
#define PH_DIO_CMD_VALUES (&ph_dio_messages[1])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_DIO_H */
