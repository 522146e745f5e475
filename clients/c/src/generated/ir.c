/** Generated from interfaces/022_ir.toml by codegen; do not edit. */
#include "playhouse/c/generated/ir.h"

#include <stddef.h>

static const ph_field ph_ir_data_fields[2] = {
    {"voltages", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_ir_data, voltages), offsetof(ph_ir_data, voltages_count), NULL},
    {"ranges", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_ir_data, ranges), offsetof(ph_ir_data, ranges_count), NULL},
};
const ph_struct_type ph_ir_data_type = {"ir.Data", ph_ir_data_fields, 2, 16, sizeof(ph_ir_data)};

static const ph_field ph_ir_pose_fields[1] = {
    {"poses", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 699049, offsetof(ph_ir_pose, poses), offsetof(ph_ir_pose, poses_count), &ph_common_pose3d_type},
};
const ph_struct_type ph_ir_pose_type = {"ir.Pose", ph_ir_pose_fields, 1, 8, sizeof(ph_ir_pose)};

static const ph_field ph_ir_power_req_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ir_power_req, state), 0, NULL},
};
const ph_struct_type ph_ir_power_req_type = {"ir.PowerReq", ph_ir_power_req_fields, 1, 4, sizeof(ph_ir_power_req)};

const ph_message_type ph_ir_messages[3] = {
    {22, PH_KIND_DATA, 1, "ir.data.ranges", &ph_ir_data_type},
    {22, PH_KIND_REQ, 1, "ir.req.pose", &ph_ir_pose_type},
    {22, PH_KIND_REQ, 2, "ir.req.power", &ph_ir_power_req_type},
};
