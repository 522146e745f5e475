/** Generated from interfaces/012_speech.toml by codegen; do not edit. */
#include "playhouse/c/generated/speech.h"

#include <stddef.h>

static const ph_field ph_speech_cmd_fields[1] = {
    {"string", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_speech_cmd, string), offsetof(ph_speech_cmd, string_count), NULL},
};
const ph_struct_type ph_speech_cmd_type = {"speech.Cmd", ph_speech_cmd_fields, 1, 8, sizeof(ph_speech_cmd)};

const ph_message_type ph_speech_messages[1] = {
    {12, PH_KIND_CMD, 1, "speech.cmd.say", &ph_speech_cmd_type},
};
