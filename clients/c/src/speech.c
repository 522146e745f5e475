#include "playhouse/c/speech.h"

#include "playhouse/c/generated/speech.h"
#include "proxy.h"

struct ph_speech {
  ph_device device;
};

const ph_class ph_speech_class = {.interface_name = "speech", .size = sizeof(ph_speech)};
PH_DEFINE_PROXY(speech)

ph_status ph_speech_say(ph_speech *speech, const char *text, ph_error *error) {
  const ph_speech_cmd command = {text, ph_text_count(text)};
  return ph_device_command(&speech->device, PH_SPEECH_CMD_SAY, &command, error);
}
