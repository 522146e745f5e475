/** Generated from interfaces/057_wsn.toml by codegen; do not edit. */
#include "playhouse/c/generated/wsn.h"

#include <stddef.h>

static const ph_field ph_wsn_node_data_fields[10] = {
    {"light", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, light), 0, NULL},
    {"mic", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, mic), 0, NULL},
    {"accel_x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, accel_x), 0, NULL},
    {"accel_y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, accel_y), 0, NULL},
    {"accel_z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, accel_z), 0, NULL},
    {"magn_x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, magn_x), 0, NULL},
    {"magn_y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, magn_y), 0, NULL},
    {"magn_z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, magn_z), 0, NULL},
    {"temperature", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, temperature), 0, NULL},
    {"battery", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_node_data, battery), 0, NULL},
};
const ph_struct_type ph_wsn_node_data_type = {"wsn.NodeData", ph_wsn_node_data_fields, 10, 40, sizeof(ph_wsn_node_data)};

static const ph_field ph_wsn_data_fields[4] = {
    {"node_type", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_data, node_type), 0, NULL},
    {"node_id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_data, node_id), 0, NULL},
    {"node_parent_id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_data, node_parent_id), 0, NULL},
    {"data_packet", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_data, data_packet), 0, &ph_wsn_node_data_type},
};
const ph_struct_type ph_wsn_data_type = {"wsn.Data", ph_wsn_data_fields, 4, 52, sizeof(ph_wsn_data)};

static const ph_field ph_wsn_cmd_fields[4] = {
    {"node_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_cmd, node_id), 0, NULL},
    {"group_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_cmd, group_id), 0, NULL},
    {"device", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_cmd, device), 0, NULL},
    {"enable", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_cmd, enable), 0, NULL},
};
const ph_struct_type ph_wsn_cmd_type = {"wsn.Cmd", ph_wsn_cmd_fields, 4, 16, sizeof(ph_wsn_cmd)};

static const ph_field ph_wsn_power_config_fields[3] = {
    {"node_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_power_config, node_id), 0, NULL},
    {"group_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_power_config, group_id), 0, NULL},
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_power_config, value), 0, NULL},
};
const ph_struct_type ph_wsn_power_config_type = {"wsn.PowerConfig", ph_wsn_power_config_fields, 3, 12, sizeof(ph_wsn_power_config)};

static const ph_field ph_wsn_datatype_config_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_datatype_config, value), 0, NULL},
};
const ph_struct_type ph_wsn_datatype_config_type = {"wsn.DatatypeConfig", ph_wsn_datatype_config_fields, 1, 4, sizeof(ph_wsn_datatype_config)};

static const ph_field ph_wsn_datafreq_config_fields[3] = {
    {"node_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_datafreq_config, node_id), 0, NULL},
    {"group_id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_datafreq_config, group_id), 0, NULL},
    {"frequency", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wsn_datafreq_config, frequency), 0, NULL},
};
const ph_struct_type ph_wsn_datafreq_config_type = {"wsn.DatafreqConfig", ph_wsn_datafreq_config_fields, 3, 16, sizeof(ph_wsn_datafreq_config)};

const ph_message_type ph_wsn_messages[5] = {
    {57, PH_KIND_DATA, 1, "wsn.data.state", &ph_wsn_data_type},
    {57, PH_KIND_CMD, 1, "wsn.cmd.devstate", &ph_wsn_cmd_type},
    {57, PH_KIND_REQ, 1, "wsn.req.power", &ph_wsn_power_config_type},
    {57, PH_KIND_REQ, 2, "wsn.req.datatype", &ph_wsn_datatype_config_type},
    {57, PH_KIND_REQ, 3, "wsn.req.datafreq", &ph_wsn_datafreq_config_type},
};
