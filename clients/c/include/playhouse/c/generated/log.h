/** Interface log, code 45. Records data of devices to a file, or plays back such a file. Generated from
 * interfaces/045_log.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_LOG_H
#define PLAYHOUSE_C_GENERATED_LOG_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_LOG_CODE 45

/** Values of GetState.type. */
enum {
  PH_LOG_TYPE_READ = 1,
  PH_LOG_TYPE_WRITE = 2,
};

/** Whether data is being recorded. (player_log_set_write_state_t) */
typedef struct ph_log_set_write_state {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_log_set_write_state;
PH_CODEC(ph_log_set_write_state)

/** Whether the file is being played. (player_log_set_read_state_t) */
typedef struct ph_log_set_read_state {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_log_set_read_state;
PH_CODEC(ph_log_set_read_state)

/** Type and state of the device. (player_log_get_state_t) */
typedef struct ph_log_get_state {
  /** Reader or writer. */
  uint8_t type;
  /** 1: running, 0: stopped. */
  uint8_t state;
} ph_log_get_state;
PH_CODEC(ph_log_get_state)

/** The file to write to. (player_log_set_filename_t) */
typedef struct ph_log_set_filename {
  /** NUL-terminated. At most 256. */
  const char *filename;
  uint32_t filename_count;
} ph_log_set_filename;
PH_CODEC(ph_log_set_filename)

/** The messages, each under its name below. */
extern const ph_message_type ph_log_messages[5];
/** Starts or stops writing. */
#define PH_LOG_REQ_SET_WRITE_STATE (&ph_log_messages[0])
/** Starts or stops playing. */
#define PH_LOG_REQ_SET_READ_STATE (&ph_log_messages[1])
/** Requests the type and state of the device. */
#define PH_LOG_REQ_GET_STATE (&ph_log_messages[2])
/** Rewinds to the start of the file. */
#define PH_LOG_REQ_SET_READ_REWIND (&ph_log_messages[3])
/** Sets the file to write to. */
#define PH_LOG_REQ_SET_FILENAME (&ph_log_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_LOG_H */
