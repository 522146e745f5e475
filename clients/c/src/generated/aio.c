/** Generated from interfaces/021_aio.toml by codegen; do not edit. */
#include "playhouse/c/generated/aio.h"

#include <stddef.h>

static const ph_field ph_aio_data_fields[1] = {
    {"voltages", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_aio_data, voltages), offsetof(ph_aio_data, voltages_count), NULL},
};
const ph_struct_type ph_aio_data_type = {"aio.Data", ph_aio_data_fields, 1, 8, sizeof(ph_aio_data)};

static const ph_field ph_aio_cmd_fields[2] = {
    {"id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_aio_cmd, id), 0, NULL},
    {"voltage", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_aio_cmd, voltage), 0, NULL},
};
const ph_struct_type ph_aio_cmd_type = {"aio.Cmd", ph_aio_cmd_fields, 2, 8, sizeof(ph_aio_cmd)};

const ph_message_type ph_aio_messages[2] = {
    {21, PH_KIND_DATA, 1, "aio.data.state", &ph_aio_data_type},
    {21, PH_KIND_CMD, 1, "aio.cmd.state", &ph_aio_cmd_type},
};
