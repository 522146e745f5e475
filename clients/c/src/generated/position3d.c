/** Generated from interfaces/030_position3d.toml by codegen; do not edit. */
#include "playhouse/c/generated/position3d.h"

#include <stddef.h>

static const ph_field ph_position3d_data_fields[3] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_data, pos), 0, &ph_common_pose3d_type},
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_data, vel), 0, &ph_common_pose3d_type},
    {"stall", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_data, stall), 0, NULL},
};
const ph_struct_type ph_position3d_data_type = {"position3d.Data", ph_position3d_data_fields, 3, 100, sizeof(ph_position3d_data)};

static const ph_field ph_position3d_cmd_pos_fields[3] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_cmd_pos, pos), 0, &ph_common_pose3d_type},
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_cmd_pos, vel), 0, &ph_common_pose3d_type},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_cmd_pos, state), 0, NULL},
};
const ph_struct_type ph_position3d_cmd_pos_type = {"position3d.CmdPos", ph_position3d_cmd_pos_fields, 3, 100, sizeof(ph_position3d_cmd_pos)};

static const ph_field ph_position3d_cmd_vel_fields[2] = {
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_cmd_vel, vel), 0, &ph_common_pose3d_type},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_cmd_vel, state), 0, NULL},
};
const ph_struct_type ph_position3d_cmd_vel_type = {"position3d.CmdVel", ph_position3d_cmd_vel_fields, 2, 52, sizeof(ph_position3d_cmd_vel)};

static const ph_field ph_position3d_geom_fields[2] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_geom, size), 0, &ph_common_bbox3d_type},
};
const ph_struct_type ph_position3d_geom_type = {"position3d.Geom", ph_position3d_geom_fields, 2, 72, sizeof(ph_position3d_geom)};

static const ph_field ph_position3d_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_power_config, state), 0, NULL},
};
const ph_struct_type ph_position3d_power_config_type = {"position3d.PowerConfig", ph_position3d_power_config_fields, 1, 4, sizeof(ph_position3d_power_config)};

static const ph_field ph_position3d_position_mode_req_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_position_mode_req, value), 0, NULL},
};
const ph_struct_type ph_position3d_position_mode_req_type = {"position3d.PositionModeReq", ph_position3d_position_mode_req_fields, 1, 4, sizeof(ph_position3d_position_mode_req)};

static const ph_field ph_position3d_velocity_mode_config_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_velocity_mode_config, value), 0, NULL},
};
const ph_struct_type ph_position3d_velocity_mode_config_type = {"position3d.VelocityModeConfig", ph_position3d_velocity_mode_config_fields, 1, 4, sizeof(ph_position3d_velocity_mode_config)};

static const ph_field ph_position3d_set_odom_req_fields[1] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_set_odom_req, pos), 0, &ph_common_pose3d_type},
};
const ph_struct_type ph_position3d_set_odom_req_type = {"position3d.SetOdomReq", ph_position3d_set_odom_req_fields, 1, 48, sizeof(ph_position3d_set_odom_req)};

static const ph_field ph_position3d_speed_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_speed_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_speed_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_speed_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position3d_speed_pid_req_type = {"position3d.SpeedPidReq", ph_position3d_speed_pid_req_fields, 3, 12, sizeof(ph_position3d_speed_pid_req)};

static const ph_field ph_position3d_position_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_position_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_position_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_position_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position3d_position_pid_req_type = {"position3d.PositionPidReq", ph_position3d_position_pid_req_fields, 3, 12, sizeof(ph_position3d_position_pid_req)};

static const ph_field ph_position3d_speed_prof_req_fields[2] = {
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_speed_prof_req, speed), 0, NULL},
    {"acc", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position3d_speed_prof_req, acc), 0, NULL},
};
const ph_struct_type ph_position3d_speed_prof_req_type = {"position3d.SpeedProfReq", ph_position3d_speed_prof_req_fields, 2, 8, sizeof(ph_position3d_speed_prof_req)};

const ph_message_type ph_position3d_messages[13] = {
    {30, PH_KIND_DATA, 1, "position3d.data.state", &ph_position3d_data_type},
    {30, PH_KIND_DATA, 2, "position3d.data.geometry", &ph_position3d_geom_type},
    {30, PH_KIND_CMD, 1, "position3d.cmd.set_vel", &ph_position3d_cmd_vel_type},
    {30, PH_KIND_CMD, 2, "position3d.cmd.set_pos", &ph_position3d_cmd_pos_type},
    {30, PH_KIND_REQ, 1, "position3d.req.get_geom", &ph_position3d_geom_type},
    {30, PH_KIND_REQ, 2, "position3d.req.motor_power", &ph_position3d_power_config_type},
    {30, PH_KIND_REQ, 3, "position3d.req.velocity_mode", &ph_position3d_velocity_mode_config_type},
    {30, PH_KIND_REQ, 4, "position3d.req.position_mode", &ph_position3d_position_mode_req_type},
    {30, PH_KIND_REQ, 5, "position3d.req.reset_odom", NULL},
    {30, PH_KIND_REQ, 6, "position3d.req.set_odom", &ph_position3d_set_odom_req_type},
    {30, PH_KIND_REQ, 7, "position3d.req.speed_pid", &ph_position3d_speed_pid_req_type},
    {30, PH_KIND_REQ, 8, "position3d.req.position_pid", &ph_position3d_position_pid_req_type},
    {30, PH_KIND_REQ, 9, "position3d.req.speed_prof", &ph_position3d_speed_prof_req_type},
};
