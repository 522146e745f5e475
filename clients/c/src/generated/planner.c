/** Generated from interfaces/044_planner.toml by codegen; do not edit. */
#include "playhouse/c/generated/planner.h"

#include <stddef.h>

static const ph_field ph_planner_data_fields[7] = {
    {"valid", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, valid), 0, NULL},
    {"done", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, done), 0, NULL},
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, pos), 0, &ph_common_pose2d_type},
    {"goal", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, goal), 0, &ph_common_pose2d_type},
    {"waypoint", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, waypoint), 0, &ph_common_pose2d_type},
    {"waypoint_idx", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, waypoint_idx), 0, NULL},
    {"waypoints_count", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_data, waypoints_count), 0, NULL},
};
const ph_struct_type ph_planner_data_type = {"planner.Data", ph_planner_data_fields, 7, 88, sizeof(ph_planner_data)};

static const ph_field ph_planner_cmd_fields[1] = {
    {"goal", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_cmd, goal), 0, &ph_common_pose2d_type},
};
const ph_struct_type ph_planner_cmd_type = {"planner.Cmd", ph_planner_cmd_fields, 1, 24, sizeof(ph_planner_cmd)};

static const ph_field ph_planner_waypoints_req_fields[2] = {
    {"waypoints_distance", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_waypoints_req, waypoints_distance), 0, NULL},
    {"waypoints", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1398099, offsetof(ph_planner_waypoints_req, waypoints), offsetof(ph_planner_waypoints_req, waypoints_count), &ph_common_pose2d_type},
};
const ph_struct_type ph_planner_waypoints_req_type = {"planner.WaypointsReq", ph_planner_waypoints_req_fields, 2, 16, sizeof(ph_planner_waypoints_req)};

static const ph_field ph_planner_enable_req_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_planner_enable_req, state), 0, NULL},
};
const ph_struct_type ph_planner_enable_req_type = {"planner.EnableReq", ph_planner_enable_req_fields, 1, 4, sizeof(ph_planner_enable_req)};

const ph_message_type ph_planner_messages[5] = {
    {44, PH_KIND_DATA, 1, "planner.data.state", &ph_planner_data_type},
    {44, PH_KIND_CMD, 1, "planner.cmd.goal", &ph_planner_cmd_type},
    {44, PH_KIND_CMD, 2, "planner.cmd.start", &ph_planner_cmd_type},
    {44, PH_KIND_REQ, 1, "planner.req.get_waypoints", &ph_planner_waypoints_req_type},
    {44, PH_KIND_REQ, 2, "planner.req.enable", &ph_planner_enable_req_type},
};
