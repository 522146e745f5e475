/** Generated from interfaces/050_speech_recognition.toml by codegen; do not edit. */
#include "playhouse/c/generated/speech_recognition.h"

#include <stddef.h>

static const ph_field ph_speech_recognition_data_fields[1] = {
    {"text", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_speech_recognition_data, text), offsetof(ph_speech_recognition_data, text_count), NULL},
};
const ph_struct_type ph_speech_recognition_data_type = {"speech_recognition.Data", ph_speech_recognition_data_fields, 1, 8, sizeof(ph_speech_recognition_data)};

const ph_message_type ph_speech_recognition_messages[1] = {
    {50, PH_KIND_DATA, 1, "speech_recognition.data.string", &ph_speech_recognition_data_type},
};
