/** Interface opaque, code 51. Opaque bytes, defined by the driver and its clients. Generated from
 * interfaces/051_opaque.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_OPAQUE_H
#define PLAYHOUSE_C_GENERATED_OPAQUE_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_OPAQUE_CODE 51

/** Subtypes under their older names. */
enum {
  PH_OPAQUE_REQ = 1,
  PH_OPAQUE_CMD = 1,
};

/** Opaque bytes. (player_opaque_data_t) */
typedef struct ph_opaque_data {
  const uint8_t *data;
  uint32_t data_count;
} ph_opaque_data;
PH_CODEC(ph_opaque_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_opaque_messages[3];
/** Bytes from the driver. */
#define PH_OPAQUE_DATA_STATE (&ph_opaque_messages[0])
/** Bytes for the driver. */
#define PH_OPAQUE_CMD_DATA (&ph_opaque_messages[1])
/** Bytes for the driver, which answers with bytes. */
#define PH_OPAQUE_REQ_DATA (&ph_opaque_messages[2])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_OPAQUE_H */
