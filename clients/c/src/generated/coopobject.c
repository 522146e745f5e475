/** Generated from interfaces/066_coopobject.toml by codegen; do not edit. */
#include "playhouse/c/generated/coopobject.h"

#include <stddef.h>

static const ph_field ph_coopobject_header_fields[3] = {
    {"origin", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_header, origin), 0, NULL},
    {"id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_header, id), 0, NULL},
    {"parent_id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_header, parent_id), 0, NULL},
};
const ph_struct_type ph_coopobject_header_type = {"coopobject.Header", ph_coopobject_header_fields, 3, 12, sizeof(ph_coopobject_header)};

static const ph_field ph_coopobject_rssi_fields[9] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, header), 0, &ph_coopobject_header_type},
    {"sender_id", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, sender_id), 0, NULL},
    {"rssi", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, rssi), 0, NULL},
    {"stamp", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, stamp), 0, NULL},
    {"nodeTimeHigh", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, nodeTimeHigh), 0, NULL},
    {"nodeTimeLow", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, nodeTimeLow), 0, NULL},
    {"x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, x), 0, NULL},
    {"y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, y), 0, NULL},
    {"z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_rssi, z), 0, NULL},
};
const ph_struct_type ph_coopobject_rssi_type = {"coopobject.Rssi", ph_coopobject_rssi_fields, 9, 44, sizeof(ph_coopobject_rssi)};

static const ph_field ph_coopobject_position_fields[5] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_position, header), 0, &ph_coopobject_header_type},
    {"x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_position, x), 0, NULL},
    {"y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_position, y), 0, NULL},
    {"z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_position, z), 0, NULL},
    {"status", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_position, status), 0, NULL},
};
const ph_struct_type ph_coopobject_position_type = {"coopobject.Position", ph_coopobject_position_fields, 5, 28, sizeof(ph_coopobject_position)};

static const ph_field ph_coopobject_sensor_fields[2] = {
    {"type", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_sensor, type), 0, NULL},
    {"value", PH_TYPE_INT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_sensor, value), 0, NULL},
};
const ph_struct_type ph_coopobject_sensor_type = {"coopobject.Sensor", ph_coopobject_sensor_fields, 2, 8, sizeof(ph_coopobject_sensor)};

static const ph_field ph_coopobject_data_sensor_fields[2] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_data_sensor, header), 0, &ph_coopobject_header_type},
    {"data", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 4194299, offsetof(ph_coopobject_data_sensor, data), offsetof(ph_coopobject_data_sensor, data_count), &ph_coopobject_sensor_type},
};
const ph_struct_type ph_coopobject_data_sensor_type = {"coopobject.DataSensor", ph_coopobject_data_sensor_fields, 2, 20, sizeof(ph_coopobject_data_sensor)};

static const ph_field ph_coopobject_data_userdefined_fields[3] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_data_userdefined, header), 0, &ph_coopobject_header_type},
    {"type", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_data_userdefined, type), 0, NULL},
    {"data", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_coopobject_data_userdefined, data), offsetof(ph_coopobject_data_userdefined, data_count), NULL},
};
const ph_struct_type ph_coopobject_data_userdefined_type = {"coopobject.DataUserdefined", ph_coopobject_data_userdefined_fields, 3, 24, sizeof(ph_coopobject_data_userdefined)};

static const ph_field ph_coopobject_req_fields[3] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_req, header), 0, &ph_coopobject_header_type},
    {"request", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_req, request), 0, NULL},
    {"parameters", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_coopobject_req, parameters), offsetof(ph_coopobject_req, parameters_count), NULL},
};
const ph_struct_type ph_coopobject_req_type = {"coopobject.Req", ph_coopobject_req_fields, 3, 24, sizeof(ph_coopobject_req)};

static const ph_field ph_coopobject_cmd_fields[3] = {
    {"header", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_cmd, header), 0, &ph_coopobject_header_type},
    {"command", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_coopobject_cmd, command), 0, NULL},
    {"parameters", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_coopobject_cmd, parameters), offsetof(ph_coopobject_cmd, parameters_count), NULL},
};
const ph_struct_type ph_coopobject_cmd_type = {"coopobject.Cmd", ph_coopobject_cmd_fields, 3, 24, sizeof(ph_coopobject_cmd)};

const ph_message_type ph_coopobject_messages[12] = {
    {66, PH_KIND_DATA, 1, "coopobject.data.health", &ph_coopobject_header_type},
    {66, PH_KIND_DATA, 2, "coopobject.data.rssi", &ph_coopobject_rssi_type},
    {66, PH_KIND_DATA, 3, "coopobject.data.sensor", &ph_coopobject_data_sensor_type},
    {66, PH_KIND_DATA, 4, "coopobject.data.alarm", &ph_coopobject_data_sensor_type},
    {66, PH_KIND_DATA, 5, "coopobject.data.userdefined", &ph_coopobject_data_userdefined_type},
    {66, PH_KIND_DATA, 6, "coopobject.data.request", &ph_coopobject_req_type},
    {66, PH_KIND_DATA, 7, "coopobject.data.command", &ph_coopobject_cmd_type},
    {66, PH_KIND_DATA, 8, "coopobject.data.position", &ph_coopobject_position_type},
    {66, PH_KIND_CMD, 1, "coopobject.cmd.standard", &ph_coopobject_cmd_type},
    {66, PH_KIND_CMD, 2, "coopobject.cmd.data", &ph_coopobject_data_userdefined_type},
    {66, PH_KIND_CMD, 3, "coopobject.cmd.position", &ph_coopobject_position_type},
    {66, PH_KIND_REQ, 1, "coopobject.req.standard", &ph_coopobject_req_type},
};
