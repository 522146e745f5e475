/** Generated from interfaces/052_position1d.toml by codegen; do not edit. */
#include "playhouse/c/generated/position1d.h"

#include <stddef.h>

static const ph_field ph_position1d_data_fields[4] = {
    {"pos", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_data, pos), 0, NULL},
    {"vel", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_data, vel), 0, NULL},
    {"stall", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_data, stall), 0, NULL},
    {"status", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_data, status), 0, NULL},
};
const ph_struct_type ph_position1d_data_type = {"position1d.Data", ph_position1d_data_fields, 4, 16, sizeof(ph_position1d_data)};

static const ph_field ph_position1d_cmd_vel_fields[2] = {
    {"vel", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_cmd_vel, vel), 0, NULL},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_cmd_vel, state), 0, NULL},
};
const ph_struct_type ph_position1d_cmd_vel_type = {"position1d.CmdVel", ph_position1d_cmd_vel_fields, 2, 8, sizeof(ph_position1d_cmd_vel)};

static const ph_field ph_position1d_cmd_pos_fields[3] = {
    {"pos", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_cmd_pos, pos), 0, NULL},
    {"vel", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_cmd_pos, vel), 0, NULL},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_cmd_pos, state), 0, NULL},
};
const ph_struct_type ph_position1d_cmd_pos_type = {"position1d.CmdPos", ph_position1d_cmd_pos_fields, 3, 12, sizeof(ph_position1d_cmd_pos)};

static const ph_field ph_position1d_geom_fields[2] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_geom, size), 0, &ph_common_bbox3d_type},
};
const ph_struct_type ph_position1d_geom_type = {"position1d.Geom", ph_position1d_geom_fields, 2, 72, sizeof(ph_position1d_geom)};

static const ph_field ph_position1d_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_power_config, state), 0, NULL},
};
const ph_struct_type ph_position1d_power_config_type = {"position1d.PowerConfig", ph_position1d_power_config_fields, 1, 4, sizeof(ph_position1d_power_config)};

static const ph_field ph_position1d_velocity_mode_config_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_velocity_mode_config, value), 0, NULL},
};
const ph_struct_type ph_position1d_velocity_mode_config_type = {"position1d.VelocityModeConfig", ph_position1d_velocity_mode_config_fields, 1, 4, sizeof(ph_position1d_velocity_mode_config)};

static const ph_field ph_position1d_reset_odom_config_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_reset_odom_config, value), 0, NULL},
};
const ph_struct_type ph_position1d_reset_odom_config_type = {"position1d.ResetOdomConfig", ph_position1d_reset_odom_config_fields, 1, 4, sizeof(ph_position1d_reset_odom_config)};

static const ph_field ph_position1d_position_mode_req_fields[1] = {
    {"state", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_position_mode_req, state), 0, NULL},
};
const ph_struct_type ph_position1d_position_mode_req_type = {"position1d.PositionModeReq", ph_position1d_position_mode_req_fields, 1, 4, sizeof(ph_position1d_position_mode_req)};

static const ph_field ph_position1d_set_odom_req_fields[1] = {
    {"pos", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_set_odom_req, pos), 0, NULL},
};
const ph_struct_type ph_position1d_set_odom_req_type = {"position1d.SetOdomReq", ph_position1d_set_odom_req_fields, 1, 4, sizeof(ph_position1d_set_odom_req)};

static const ph_field ph_position1d_speed_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_speed_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_speed_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_speed_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position1d_speed_pid_req_type = {"position1d.SpeedPidReq", ph_position1d_speed_pid_req_fields, 3, 12, sizeof(ph_position1d_speed_pid_req)};

static const ph_field ph_position1d_position_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_position_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_position_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_position_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position1d_position_pid_req_type = {"position1d.PositionPidReq", ph_position1d_position_pid_req_fields, 3, 12, sizeof(ph_position1d_position_pid_req)};

static const ph_field ph_position1d_speed_prof_req_fields[2] = {
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_speed_prof_req, speed), 0, NULL},
    {"acc", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position1d_speed_prof_req, acc), 0, NULL},
};
const ph_struct_type ph_position1d_speed_prof_req_type = {"position1d.SpeedProfReq", ph_position1d_speed_prof_req_fields, 2, 8, sizeof(ph_position1d_speed_prof_req)};

const ph_message_type ph_position1d_messages[13] = {
    {52, PH_KIND_DATA, 1, "position1d.data.state", &ph_position1d_data_type},
    {52, PH_KIND_DATA, 2, "position1d.data.geom", &ph_position1d_geom_type},
    {52, PH_KIND_CMD, 1, "position1d.cmd.vel", &ph_position1d_cmd_vel_type},
    {52, PH_KIND_CMD, 2, "position1d.cmd.pos", &ph_position1d_cmd_pos_type},
    {52, PH_KIND_REQ, 1, "position1d.req.get_geom", &ph_position1d_geom_type},
    {52, PH_KIND_REQ, 2, "position1d.req.motor_power", &ph_position1d_power_config_type},
    {52, PH_KIND_REQ, 3, "position1d.req.velocity_mode", &ph_position1d_velocity_mode_config_type},
    {52, PH_KIND_REQ, 4, "position1d.req.position_mode", &ph_position1d_position_mode_req_type},
    {52, PH_KIND_REQ, 5, "position1d.req.set_odom", &ph_position1d_set_odom_req_type},
    {52, PH_KIND_REQ, 6, "position1d.req.reset_odom", &ph_position1d_reset_odom_config_type},
    {52, PH_KIND_REQ, 7, "position1d.req.speed_pid", &ph_position1d_speed_pid_req_type},
    {52, PH_KIND_REQ, 8, "position1d.req.position_pid", &ph_position1d_position_pid_req_type},
    {52, PH_KIND_REQ, 9, "position1d.req.speed_prof", &ph_position1d_speed_prof_req_type},
};
