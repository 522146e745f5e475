/** Interface speech_recognition, code 50. Reports recognised speech. Generated from
 * interfaces/050_speech_recognition.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_SPEECH_RECOGNITION_H
#define PLAYHOUSE_C_GENERATED_SPEECH_RECOGNITION_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_SPEECH_RECOGNITION_CODE 50

/** Recognised speech. (player_speech_recognition_data_t) */
typedef struct ph_speech_recognition_data {
  /** NUL-terminated. */
  const char *text;
  uint32_t text_count;
} ph_speech_recognition_data;
PH_CODEC(ph_speech_recognition_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_speech_recognition_messages[1];
/** Recognised words. */
#define PH_SPEECH_RECOGNITION_DATA_STRING (&ph_speech_recognition_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_SPEECH_RECOGNITION_H */
