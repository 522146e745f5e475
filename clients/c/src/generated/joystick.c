/** Generated from interfaces/049_joystick.toml by codegen; do not edit. */
#include "playhouse/c/generated/joystick.h"

#include <stddef.h>

static const ph_field ph_joystick_data_fields[4] = {
    {"pos", PH_TYPE_INT32, PH_SHAPE_FIXED, 0, 0, 8, offsetof(ph_joystick_data, pos), 0, NULL},
    {"scale", PH_TYPE_INT32, PH_SHAPE_FIXED, 0, 0, 8, offsetof(ph_joystick_data, scale), 0, NULL},
    {"buttons", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_joystick_data, buttons), 0, NULL},
    {"axes_count", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_joystick_data, axes_count), 0, NULL},
};
const ph_struct_type ph_joystick_data_type = {"joystick.Data", ph_joystick_data_fields, 4, 72, sizeof(ph_joystick_data)};

const ph_message_type ph_joystick_messages[1] = {
    {49, PH_KIND_DATA, 1, "joystick.data.state", &ph_joystick_data_type},
};
