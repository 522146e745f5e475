/** Generated from interfaces/033_blinkenlight.toml by codegen; do not edit. */
#include "playhouse/c/generated/blinkenlight.h"

#include <stddef.h>

static const ph_field ph_blinkenlight_data_fields[4] = {
    {"enable", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_data, enable), 0, NULL},
    {"period", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_data, period), 0, NULL},
    {"dutycycle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_data, dutycycle), 0, NULL},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_data, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_blinkenlight_data_type = {"blinkenlight.Data", ph_blinkenlight_data_fields, 4, 28, sizeof(ph_blinkenlight_data)};

static const ph_field ph_blinkenlight_cmd_fields[5] = {
    {"id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd, id), 0, NULL},
    {"enable", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd, enable), 0, NULL},
    {"period", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd, period), 0, NULL},
    {"dutycycle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd, dutycycle), 0, NULL},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_blinkenlight_cmd_type = {"blinkenlight.Cmd", ph_blinkenlight_cmd_fields, 5, 32, sizeof(ph_blinkenlight_cmd)};

static const ph_field ph_blinkenlight_cmd_power_fields[2] = {
    {"id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_power, id), 0, NULL},
    {"enable", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_power, enable), 0, NULL},
};
const ph_struct_type ph_blinkenlight_cmd_power_type = {"blinkenlight.CmdPower", ph_blinkenlight_cmd_power_fields, 2, 8, sizeof(ph_blinkenlight_cmd_power)};

static const ph_field ph_blinkenlight_cmd_color_fields[2] = {
    {"id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_color, id), 0, NULL},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_color, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_blinkenlight_cmd_color_type = {"blinkenlight.CmdColor", ph_blinkenlight_cmd_color_fields, 2, 20, sizeof(ph_blinkenlight_cmd_color)};

static const ph_field ph_blinkenlight_cmd_flash_fields[3] = {
    {"id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_flash, id), 0, NULL},
    {"period", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_flash, period), 0, NULL},
    {"dutycycle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blinkenlight_cmd_flash, dutycycle), 0, NULL},
};
const ph_struct_type ph_blinkenlight_cmd_flash_type = {"blinkenlight.CmdFlash", ph_blinkenlight_cmd_flash_fields, 3, 12, sizeof(ph_blinkenlight_cmd_flash)};

const ph_message_type ph_blinkenlight_messages[5] = {
    {33, PH_KIND_DATA, 1, "blinkenlight.data.state", &ph_blinkenlight_data_type},
    {33, PH_KIND_CMD, 1, "blinkenlight.cmd.state", &ph_blinkenlight_cmd_type},
    {33, PH_KIND_CMD, 2, "blinkenlight.cmd.power", &ph_blinkenlight_cmd_power_type},
    {33, PH_KIND_CMD, 3, "blinkenlight.cmd.color", &ph_blinkenlight_cmd_color_type},
    {33, PH_KIND_CMD, 4, "blinkenlight.cmd.flash", &ph_blinkenlight_cmd_flash_type},
};
