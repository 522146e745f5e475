/** Generated from interfaces/003_gripper.toml by codegen; do not edit. */
#include "playhouse/c/generated/gripper.h"

#include <stddef.h>

static const ph_field ph_gripper_data_fields[3] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_data, state), 0, NULL},
    {"beams", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_data, beams), 0, NULL},
    {"stored", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_data, stored), 0, NULL},
};
const ph_struct_type ph_gripper_data_type = {"gripper.Data", ph_gripper_data_fields, 3, 12, sizeof(ph_gripper_data)};

static const ph_field ph_gripper_geom_fields[5] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_geom, pose), 0, &ph_common_pose3d_type},
    {"outer_size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_geom, outer_size), 0, &ph_common_bbox3d_type},
    {"inner_size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_geom, inner_size), 0, &ph_common_bbox3d_type},
    {"num_beams", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_geom, num_beams), 0, NULL},
    {"capacity", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gripper_geom, capacity), 0, NULL},
};
const ph_struct_type ph_gripper_geom_type = {"gripper.Geom", ph_gripper_geom_fields, 5, 104, sizeof(ph_gripper_geom)};

const ph_message_type ph_gripper_messages[7] = {
    {3, PH_KIND_DATA, 1, "gripper.data.state", &ph_gripper_data_type},
    {3, PH_KIND_CMD, 1, "gripper.cmd.open", NULL},
    {3, PH_KIND_CMD, 2, "gripper.cmd.close", NULL},
    {3, PH_KIND_CMD, 3, "gripper.cmd.stop", NULL},
    {3, PH_KIND_CMD, 4, "gripper.cmd.store", NULL},
    {3, PH_KIND_CMD, 5, "gripper.cmd.retrieve", NULL},
    {3, PH_KIND_REQ, 1, "gripper.req.get_geom", &ph_gripper_geom_type},
};
