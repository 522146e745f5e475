/** Generated from interfaces/031_simulation.toml by codegen; do not edit. */
#include "playhouse/c/generated/simulation.h"

#include <stddef.h>

static const ph_field ph_simulation_data_fields[1] = {
    {"data", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_data, data), 0, NULL},
};
const ph_struct_type ph_simulation_data_type = {"simulation.Data", ph_simulation_data_fields, 1, 4, sizeof(ph_simulation_data)};

static const ph_field ph_simulation_cmd_fields[1] = {
    {"cmd", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_cmd, cmd), 0, NULL},
};
const ph_struct_type ph_simulation_cmd_type = {"simulation.Cmd", ph_simulation_cmd_fields, 1, 4, sizeof(ph_simulation_cmd)};

static const ph_field ph_simulation_pose2d_req_fields[2] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_simulation_pose2d_req, name), offsetof(ph_simulation_pose2d_req, name_count), NULL},
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_pose2d_req, pose), 0, &ph_common_pose2d_type},
};
const ph_struct_type ph_simulation_pose2d_req_type = {"simulation.Pose2dReq", ph_simulation_pose2d_req_fields, 2, 32, sizeof(ph_simulation_pose2d_req)};

static const ph_field ph_simulation_pose3d_req_fields[3] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_simulation_pose3d_req, name), offsetof(ph_simulation_pose3d_req, name_count), NULL},
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_pose3d_req, pose), 0, &ph_common_pose3d_type},
    {"simtime", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_pose3d_req, simtime), 0, NULL},
};
const ph_struct_type ph_simulation_pose3d_req_type = {"simulation.Pose3dReq", ph_simulation_pose3d_req_fields, 3, 64, sizeof(ph_simulation_pose3d_req)};

static const ph_field ph_simulation_property_req_fields[4] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_simulation_property_req, name), offsetof(ph_simulation_property_req, name_count), NULL},
    {"prop", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_simulation_property_req, prop), offsetof(ph_simulation_property_req, prop_count), NULL},
    {"index", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_simulation_property_req, index), 0, NULL},
    {"value", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_simulation_property_req, value), offsetof(ph_simulation_property_req, value_count), NULL},
};
const ph_struct_type ph_simulation_property_req_type = {"simulation.PropertyReq", ph_simulation_property_req_fields, 4, 28, sizeof(ph_simulation_property_req)};

const ph_message_type ph_simulation_messages[9] = {
    {31, PH_KIND_CMD, 1, "simulation.cmd.pause", NULL},
    {31, PH_KIND_CMD, 2, "simulation.cmd.reset", NULL},
    {31, PH_KIND_CMD, 3, "simulation.cmd.save", NULL},
    {31, PH_KIND_REQ, 1, "simulation.req.get_pose2d", &ph_simulation_pose2d_req_type},
    {31, PH_KIND_REQ, 2, "simulation.req.set_pose2d", &ph_simulation_pose2d_req_type},
    {31, PH_KIND_REQ, 3, "simulation.req.get_pose3d", &ph_simulation_pose3d_req_type},
    {31, PH_KIND_REQ, 4, "simulation.req.set_pose3d", &ph_simulation_pose3d_req_type},
    {31, PH_KIND_REQ, 5, "simulation.req.get_property", &ph_simulation_property_req_type},
    {31, PH_KIND_REQ, 6, "simulation.req.set_property", &ph_simulation_property_req_type},
};
