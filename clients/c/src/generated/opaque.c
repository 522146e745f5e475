/** Generated from interfaces/051_opaque.toml by codegen; do not edit. */
#include "playhouse/c/generated/opaque.h"

#include <stddef.h>

static const ph_field ph_opaque_data_fields[1] = {
    {"data", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_opaque_data, data), offsetof(ph_opaque_data, data_count), NULL},
};
const ph_struct_type ph_opaque_data_type = {"opaque.Data", ph_opaque_data_fields, 1, 8, sizeof(ph_opaque_data)};

const ph_message_type ph_opaque_messages[3] = {
    {51, PH_KIND_DATA, 1, "opaque.data.state", &ph_opaque_data_type},
    {51, PH_KIND_CMD, 1, "opaque.cmd.data", &ph_opaque_data_type},
    {51, PH_KIND_REQ, 1, "opaque.req.data", &ph_opaque_data_type},
};
