/** Generated from interfaces/008_ptz.toml by codegen; do not edit. */
#include "playhouse/c/generated/ptz.h"

#include <stddef.h>

static const ph_field ph_ptz_data_fields[6] = {
    {"pan", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, pan), 0, NULL},
    {"tilt", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, tilt), 0, NULL},
    {"zoom", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, zoom), 0, NULL},
    {"panspeed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, panspeed), 0, NULL},
    {"tiltspeed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, tiltspeed), 0, NULL},
    {"status", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_data, status), 0, NULL},
};
const ph_struct_type ph_ptz_data_type = {"ptz.Data", ph_ptz_data_fields, 6, 24, sizeof(ph_ptz_data)};

static const ph_field ph_ptz_cmd_fields[5] = {
    {"pan", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_cmd, pan), 0, NULL},
    {"tilt", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_cmd, tilt), 0, NULL},
    {"zoom", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_cmd, zoom), 0, NULL},
    {"panspeed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_cmd, panspeed), 0, NULL},
    {"tiltspeed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_cmd, tiltspeed), 0, NULL},
};
const ph_struct_type ph_ptz_cmd_type = {"ptz.Cmd", ph_ptz_cmd_fields, 5, 20, sizeof(ph_ptz_cmd)};

static const ph_field ph_ptz_req_status_fields[1] = {
    {"status", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_req_status, status), 0, NULL},
};
const ph_struct_type ph_ptz_req_status_type = {"ptz.ReqStatus", ph_ptz_req_status_fields, 1, 4, sizeof(ph_ptz_req_status)};

static const ph_field ph_ptz_geom_fields[2] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_geom, pos), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_geom, size), 0, &ph_common_bbox3d_type},
};
const ph_struct_type ph_ptz_geom_type = {"ptz.Geom", ph_ptz_geom_fields, 2, 72, sizeof(ph_ptz_geom)};

static const ph_field ph_ptz_req_generic_fields[1] = {
    {"config", PH_TYPE_UINT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_ptz_req_generic, config), offsetof(ph_ptz_req_generic, config_count), NULL},
};
const ph_struct_type ph_ptz_req_generic_type = {"ptz.ReqGeneric", ph_ptz_req_generic_fields, 1, 8, sizeof(ph_ptz_req_generic)};

static const ph_field ph_ptz_req_control_mode_fields[1] = {
    {"mode", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ptz_req_control_mode, mode), 0, NULL},
};
const ph_struct_type ph_ptz_req_control_mode_type = {"ptz.ReqControlMode", ph_ptz_req_control_mode_fields, 1, 4, sizeof(ph_ptz_req_control_mode)};

const ph_message_type ph_ptz_messages[7] = {
    {8, PH_KIND_DATA, 1, "ptz.data.state", &ph_ptz_data_type},
    {8, PH_KIND_DATA, 2, "ptz.data.geom", &ph_ptz_geom_type},
    {8, PH_KIND_CMD, 1, "ptz.cmd.state", &ph_ptz_cmd_type},
    {8, PH_KIND_REQ, 1, "ptz.req.generic", &ph_ptz_req_generic_type},
    {8, PH_KIND_REQ, 2, "ptz.req.control_mode", &ph_ptz_req_control_mode_type},
    {8, PH_KIND_REQ, 4, "ptz.req.geom", &ph_ptz_geom_type},
    {8, PH_KIND_REQ, 5, "ptz.req.status", &ph_ptz_req_status_type},
};
