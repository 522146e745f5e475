/** Generated from interfaces/054_limb.toml by codegen; do not edit. */
#include "playhouse/c/generated/limb.h"

#include <stddef.h>

static const ph_field ph_limb_data_fields[4] = {
    {"position", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_data, position), 0, &ph_common_point3d_type},
    {"approach", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_data, approach), 0, &ph_common_point3d_type},
    {"orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_data, orientation), 0, &ph_common_point3d_type},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_data, state), 0, NULL},
};
const ph_struct_type ph_limb_data_type = {"limb.Data", ph_limb_data_fields, 4, 76, sizeof(ph_limb_data)};

static const ph_field ph_limb_setpose_cmd_fields[3] = {
    {"position", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_setpose_cmd, position), 0, &ph_common_point3d_type},
    {"approach", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_setpose_cmd, approach), 0, &ph_common_point3d_type},
    {"orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_setpose_cmd, orientation), 0, &ph_common_point3d_type},
};
const ph_struct_type ph_limb_setpose_cmd_type = {"limb.SetposeCmd", ph_limb_setpose_cmd_fields, 3, 72, sizeof(ph_limb_setpose_cmd)};

static const ph_field ph_limb_setposition_cmd_fields[1] = {
    {"position", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_setposition_cmd, position), 0, &ph_common_point3d_type},
};
const ph_struct_type ph_limb_setposition_cmd_type = {"limb.SetpositionCmd", ph_limb_setposition_cmd_fields, 1, 24, sizeof(ph_limb_setposition_cmd)};

static const ph_field ph_limb_vecmove_cmd_fields[2] = {
    {"direction", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_vecmove_cmd, direction), 0, &ph_common_point3d_type},
    {"length", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_vecmove_cmd, length), 0, NULL},
};
const ph_struct_type ph_limb_vecmove_cmd_type = {"limb.VecmoveCmd", ph_limb_vecmove_cmd_fields, 2, 28, sizeof(ph_limb_vecmove_cmd)};

static const ph_field ph_limb_power_req_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_power_req, value), 0, NULL},
};
const ph_struct_type ph_limb_power_req_type = {"limb.PowerReq", ph_limb_power_req_fields, 1, 4, sizeof(ph_limb_power_req)};

static const ph_field ph_limb_brakes_req_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_brakes_req, value), 0, NULL},
};
const ph_struct_type ph_limb_brakes_req_type = {"limb.BrakesReq", ph_limb_brakes_req_fields, 1, 4, sizeof(ph_limb_brakes_req)};

static const ph_field ph_limb_geom_req_fields[1] = {
    {"basePos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_geom_req, basePos), 0, &ph_common_point3d_type},
};
const ph_struct_type ph_limb_geom_req_type = {"limb.GeomReq", ph_limb_geom_req_fields, 1, 24, sizeof(ph_limb_geom_req)};

static const ph_field ph_limb_speed_req_fields[1] = {
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_limb_speed_req, speed), 0, NULL},
};
const ph_struct_type ph_limb_speed_req_type = {"limb.SpeedReq", ph_limb_speed_req_fields, 1, 4, sizeof(ph_limb_speed_req)};

const ph_message_type ph_limb_messages[10] = {
    {54, PH_KIND_DATA, 1, "limb.data.state", &ph_limb_data_type},
    {54, PH_KIND_CMD, 1, "limb.cmd.home", NULL},
    {54, PH_KIND_CMD, 2, "limb.cmd.stop", NULL},
    {54, PH_KIND_CMD, 3, "limb.cmd.setpose", &ph_limb_setpose_cmd_type},
    {54, PH_KIND_CMD, 4, "limb.cmd.setposition", &ph_limb_setposition_cmd_type},
    {54, PH_KIND_CMD, 5, "limb.cmd.vecmove", &ph_limb_vecmove_cmd_type},
    {54, PH_KIND_REQ, 1, "limb.req.power", &ph_limb_power_req_type},
    {54, PH_KIND_REQ, 2, "limb.req.brakes", &ph_limb_brakes_req_type},
    {54, PH_KIND_REQ, 3, "limb.req.geom", &ph_limb_geom_req_type},
    {54, PH_KIND_REQ, 4, "limb.req.speed", &ph_limb_speed_req_type},
};
