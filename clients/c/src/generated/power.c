/** Generated from interfaces/002_power.toml by codegen; do not edit. */
#include "playhouse/c/generated/power.h"

#include <stddef.h>

static const ph_field ph_power_data_fields[6] = {
    {"valid", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, valid), 0, NULL},
    {"volts", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, volts), 0, NULL},
    {"percent", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, percent), 0, NULL},
    {"joules", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, joules), 0, NULL},
    {"watts", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, watts), 0, NULL},
    {"charging", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_data, charging), 0, NULL},
};
const ph_struct_type ph_power_data_type = {"power.Data", ph_power_data_fields, 6, 24, sizeof(ph_power_data)};

static const ph_field ph_power_chargepolicy_config_fields[2] = {
    {"enable_input", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_chargepolicy_config, enable_input), 0, NULL},
    {"enable_output", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_power_chargepolicy_config, enable_output), 0, NULL},
};
const ph_struct_type ph_power_chargepolicy_config_type = {"power.ChargepolicyConfig", ph_power_chargepolicy_config_fields, 2, 8, sizeof(ph_power_chargepolicy_config)};

const ph_message_type ph_power_messages[2] = {
    {2, PH_KIND_DATA, 1, "power.data.state", &ph_power_data_type},
    {2, PH_KIND_REQ, 1, "power.req.set_charging_policy", &ph_power_chargepolicy_config_type},
};
