/** Generated from interfaces/020_dio.toml by codegen; do not edit. */
#include "playhouse/c/generated/dio.h"

#include <stddef.h>

static const ph_field ph_dio_data_fields[2] = {
    {"count", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_dio_data, count), 0, NULL},
    {"bits", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_dio_data, bits), 0, NULL},
};
const ph_struct_type ph_dio_data_type = {"dio.Data", ph_dio_data_fields, 2, 8, sizeof(ph_dio_data)};

static const ph_field ph_dio_cmd_fields[2] = {
    {"count", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_dio_cmd, count), 0, NULL},
    {"digout", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_dio_cmd, digout), 0, NULL},
};
const ph_struct_type ph_dio_cmd_type = {"dio.Cmd", ph_dio_cmd_fields, 2, 8, sizeof(ph_dio_cmd)};

const ph_message_type ph_dio_messages[2] = {
    {20, PH_KIND_DATA, 1, "dio.data.values", &ph_dio_data_type},
    {20, PH_KIND_CMD, 1, "dio.cmd.values", &ph_dio_cmd_type},
};
