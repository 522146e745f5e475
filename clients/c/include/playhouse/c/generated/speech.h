/** Interface speech, code 12. Speaks text. Generated from interfaces/012_speech.toml by codegen; do not
 * edit. */
#ifndef PLAYHOUSE_C_GENERATED_SPEECH_H
#define PLAYHOUSE_C_GENERATED_SPEECH_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_SPEECH_CODE 12

/** A text to speak. (player_speech_cmd_t) */
typedef struct ph_speech_cmd {
  /** NUL-terminated. */
  const char *string;
  uint32_t string_count;
} ph_speech_cmd;
PH_CODEC(ph_speech_cmd)

/** The messages, each under its name below. */
extern const ph_message_type ph_speech_messages[1];
/** Speaks a text; texts are spoken one after the other. */
#define PH_SPEECH_CMD_SAY (&ph_speech_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_SPEECH_H */
