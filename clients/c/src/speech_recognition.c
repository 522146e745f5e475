#include "playhouse/c/speech_recognition.h"

#include "playhouse/c/generated/speech_recognition.h"
#include "proxy.h"

struct ph_speech_recognition {
  ph_device device;
  ph_kept kept;
};

static void take(ph_device *device, const ph_value *value) {
  ph_kept_add(&((ph_speech_recognition *)device)->kept, value);
}

static void forget(ph_device *device) {
  ph_kept_clear(&((ph_speech_recognition *)device)->kept);
}

static void release(ph_device *device) {
  ph_kept_free(&((ph_speech_recognition *)device)->kept);
}

const ph_class ph_speech_recognition_class = {.interface_name = "speech_recognition",
                                              .size = sizeof(ph_speech_recognition),
                                              .take = take,
                                              .forget = forget,
                                              .release = release};
PH_DEFINE_PROXY(speech_recognition)

const char *ph_speech_recognition_take_text(ph_speech_recognition *ears) {
  const ph_value *value = ph_kept_take(&ears->kept);
  return value != NULL ? ((const ph_speech_recognition_data *)value->data)->text : NULL;
}
