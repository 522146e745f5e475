#ifndef PLAYHOUSE_C_SPEECH_RECOGNITION_H
#define PLAYHOUSE_C_SPEECH_RECOGNITION_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Speech recognition: texts of other models heard by a robot. */
PH_PROXY(speech_recognition)

/** The oldest text of the reads so far that was not taken yet; NULL if there is none. A device keeps the last
 * 1024. Valid until the next call for this device. */
const char *ph_speech_recognition_take_text(ph_speech_recognition *ears);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_SPEECH_RECOGNITION_H */
