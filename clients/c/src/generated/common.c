/** Generated from interfaces/000_common.toml by codegen; do not edit. */
#include "playhouse/c/generated/common.h"

#include <stddef.h>

static const ph_field ph_common_devaddr_fields[4] = {
    {"host", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_devaddr, host), 0, NULL},
    {"robot", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_devaddr, robot), 0, NULL},
    {"interf", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_devaddr, interf), 0, NULL},
    {"index", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_devaddr, index), 0, NULL},
};
const ph_struct_type ph_common_devaddr_type = {"common.Devaddr", ph_common_devaddr_fields, 4, 16, sizeof(ph_common_devaddr)};

static const ph_field ph_common_point2d_fields[2] = {
    {"px", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_point2d, px), 0, NULL},
    {"py", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_point2d, py), 0, NULL},
};
const ph_struct_type ph_common_point2d_type = {"common.Point2d", ph_common_point2d_fields, 2, 16, sizeof(ph_common_point2d)};

static const ph_field ph_common_point3d_fields[3] = {
    {"px", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_point3d, px), 0, NULL},
    {"py", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_point3d, py), 0, NULL},
    {"pz", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_point3d, pz), 0, NULL},
};
const ph_struct_type ph_common_point3d_type = {"common.Point3d", ph_common_point3d_fields, 3, 24, sizeof(ph_common_point3d)};

static const ph_field ph_common_orientation3d_fields[3] = {
    {"proll", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_orientation3d, proll), 0, NULL},
    {"ppitch", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_orientation3d, ppitch), 0, NULL},
    {"pyaw", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_orientation3d, pyaw), 0, NULL},
};
const ph_struct_type ph_common_orientation3d_type = {"common.Orientation3d", ph_common_orientation3d_fields, 3, 24, sizeof(ph_common_orientation3d)};

static const ph_field ph_common_pose2d_fields[3] = {
    {"px", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose2d, px), 0, NULL},
    {"py", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose2d, py), 0, NULL},
    {"pa", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose2d, pa), 0, NULL},
};
const ph_struct_type ph_common_pose2d_type = {"common.Pose2d", ph_common_pose2d_fields, 3, 24, sizeof(ph_common_pose2d)};

static const ph_field ph_common_pose3d_fields[6] = {
    {"px", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, px), 0, NULL},
    {"py", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, py), 0, NULL},
    {"pz", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, pz), 0, NULL},
    {"proll", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, proll), 0, NULL},
    {"ppitch", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, ppitch), 0, NULL},
    {"pyaw", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_pose3d, pyaw), 0, NULL},
};
const ph_struct_type ph_common_pose3d_type = {"common.Pose3d", ph_common_pose3d_fields, 6, 48, sizeof(ph_common_pose3d)};

static const ph_field ph_common_bbox2d_fields[2] = {
    {"sw", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bbox2d, sw), 0, NULL},
    {"sl", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bbox2d, sl), 0, NULL},
};
const ph_struct_type ph_common_bbox2d_type = {"common.Bbox2d", ph_common_bbox2d_fields, 2, 16, sizeof(ph_common_bbox2d)};

static const ph_field ph_common_bbox3d_fields[3] = {
    {"sw", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bbox3d, sw), 0, NULL},
    {"sl", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bbox3d, sl), 0, NULL},
    {"sh", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bbox3d, sh), 0, NULL},
};
const ph_struct_type ph_common_bbox3d_type = {"common.Bbox3d", ph_common_bbox3d_fields, 3, 24, sizeof(ph_common_bbox3d)};

static const ph_field ph_common_blackboard_entry_fields[7] = {
    {"key", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_blackboard_entry, key), offsetof(ph_common_blackboard_entry, key_count), NULL},
    {"group", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_blackboard_entry, group), offsetof(ph_common_blackboard_entry, group_count), NULL},
    {"type", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_blackboard_entry, type), 0, NULL},
    {"subtype", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_blackboard_entry, subtype), 0, NULL},
    {"data", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_blackboard_entry, data), offsetof(ph_common_blackboard_entry, data_count), NULL},
    {"timestamp_sec", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_blackboard_entry, timestamp_sec), 0, NULL},
    {"timestamp_usec", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_blackboard_entry, timestamp_usec), 0, NULL},
};
const ph_struct_type ph_common_blackboard_entry_type = {"common.BlackboardEntry", ph_common_blackboard_entry_fields, 7, 40, sizeof(ph_common_blackboard_entry)};

static const ph_field ph_common_segment_fields[4] = {
    {"x0", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_segment, x0), 0, NULL},
    {"y0", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_segment, y0), 0, NULL},
    {"x1", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_segment, x1), 0, NULL},
    {"y1", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_segment, y1), 0, NULL},
};
const ph_struct_type ph_common_segment_type = {"common.Segment", ph_common_segment_fields, 4, 32, sizeof(ph_common_segment)};

static const ph_field ph_common_extent2d_fields[4] = {
    {"x0", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_extent2d, x0), 0, NULL},
    {"y0", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_extent2d, y0), 0, NULL},
    {"x1", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_extent2d, x1), 0, NULL},
    {"y1", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_extent2d, y1), 0, NULL},
};
const ph_struct_type ph_common_extent2d_type = {"common.Extent2d", ph_common_extent2d_fields, 4, 32, sizeof(ph_common_extent2d)};

static const ph_field ph_common_color_fields[4] = {
    {"alpha", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_color, alpha), 0, NULL},
    {"red", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_color, red), 0, NULL},
    {"green", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_color, green), 0, NULL},
    {"blue", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_color, blue), 0, NULL},
};
const ph_struct_type ph_common_color_type = {"common.Color", ph_common_color_fields, 4, 16, sizeof(ph_common_color)};

static const ph_field ph_common_bool_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_bool, state), 0, NULL},
};
const ph_struct_type ph_common_bool_type = {"common.Bool", ph_common_bool_fields, 1, 4, sizeof(ph_common_bool)};

static const ph_field ph_common_uint32_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_uint32, value), 0, NULL},
};
const ph_struct_type ph_common_uint32_type = {"common.Uint32", ph_common_uint32_fields, 1, 4, sizeof(ph_common_uint32)};

static const ph_field ph_common_capabilities_req_fields[2] = {
    {"type", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_capabilities_req, type), 0, NULL},
    {"subtype", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_capabilities_req, subtype), 0, NULL},
};
const ph_struct_type ph_common_capabilities_req_type = {"common.CapabilitiesReq", ph_common_capabilities_req_fields, 2, 8, sizeof(ph_common_capabilities_req)};

static const ph_field ph_common_boolprop_req_fields[2] = {
    {"key", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_boolprop_req, key), offsetof(ph_common_boolprop_req, key_count), NULL},
    {"value", PH_TYPE_CHAR, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_boolprop_req, value), 0, NULL},
};
const ph_struct_type ph_common_boolprop_req_type = {"common.BoolpropReq", ph_common_boolprop_req_fields, 2, 12, sizeof(ph_common_boolprop_req)};

static const ph_field ph_common_intprop_req_fields[2] = {
    {"key", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_intprop_req, key), offsetof(ph_common_intprop_req, key_count), NULL},
    {"value", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_intprop_req, value), 0, NULL},
};
const ph_struct_type ph_common_intprop_req_type = {"common.IntpropReq", ph_common_intprop_req_fields, 2, 12, sizeof(ph_common_intprop_req)};

static const ph_field ph_common_dblprop_req_fields[2] = {
    {"key", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_dblprop_req, key), offsetof(ph_common_dblprop_req, key_count), NULL},
    {"value", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_common_dblprop_req, value), 0, NULL},
};
const ph_struct_type ph_common_dblprop_req_type = {"common.DblpropReq", ph_common_dblprop_req_fields, 2, 16, sizeof(ph_common_dblprop_req)};

static const ph_field ph_common_strprop_req_fields[2] = {
    {"key", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_strprop_req, key), offsetof(ph_common_strprop_req, key_count), NULL},
    {"value", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_common_strprop_req, value), offsetof(ph_common_strprop_req, value_count), NULL},
};
const ph_struct_type ph_common_strprop_req_type = {"common.StrpropReq", ph_common_strprop_req_fields, 2, 16, sizeof(ph_common_strprop_req)};

const ph_message_type ph_common_messages[9] = {
    {0, PH_KIND_REQ, 247, "universal.req.set_boolprop", &ph_common_boolprop_req_type},
    {0, PH_KIND_REQ, 248, "universal.req.get_boolprop", &ph_common_boolprop_req_type},
    {0, PH_KIND_REQ, 249, "universal.req.set_strprop", &ph_common_strprop_req_type},
    {0, PH_KIND_REQ, 250, "universal.req.get_strprop", &ph_common_strprop_req_type},
    {0, PH_KIND_REQ, 251, "universal.req.set_dblprop", &ph_common_dblprop_req_type},
    {0, PH_KIND_REQ, 252, "universal.req.get_dblprop", &ph_common_dblprop_req_type},
    {0, PH_KIND_REQ, 253, "universal.req.set_intprop", &ph_common_intprop_req_type},
    {0, PH_KIND_REQ, 254, "universal.req.get_intprop", &ph_common_intprop_req_type},
    {0, PH_KIND_REQ, 255, "universal.req.capabilities", &ph_common_capabilities_req_type},
};
