#ifndef PLAYHOUSE_C_SPEECH_H
#define PLAYHOUSE_C_SPEECH_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Speech output of a robot. */
PH_PROXY(speech)

/** Sets the text that the robot says, in UTF-8, replacing the previous one; "": none. */
ph_status ph_speech_say(ph_speech *speech, const char *text, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_SPEECH_H */
