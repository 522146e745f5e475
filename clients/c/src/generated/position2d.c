/** Generated from interfaces/004_position2d.toml by codegen; do not edit. */
#include "playhouse/c/generated/position2d.h"

#include <stddef.h>

static const ph_field ph_position2d_data_fields[3] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_data, pos), 0, &ph_common_pose2d_type},
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_data, vel), 0, &ph_common_pose2d_type},
    {"stall", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_data, stall), 0, NULL},
};
const ph_struct_type ph_position2d_data_type = {"position2d.Data", ph_position2d_data_fields, 3, 52, sizeof(ph_position2d_data)};

static const ph_field ph_position2d_cmd_vel_fields[2] = {
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_vel, vel), 0, &ph_common_pose2d_type},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_vel, state), 0, NULL},
};
const ph_struct_type ph_position2d_cmd_vel_type = {"position2d.CmdVel", ph_position2d_cmd_vel_fields, 2, 28, sizeof(ph_position2d_cmd_vel)};

static const ph_field ph_position2d_cmd_pos_fields[3] = {
    {"pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_pos, pos), 0, &ph_common_pose2d_type},
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_pos, vel), 0, &ph_common_pose2d_type},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_pos, state), 0, NULL},
};
const ph_struct_type ph_position2d_cmd_pos_type = {"position2d.CmdPos", ph_position2d_cmd_pos_fields, 3, 52, sizeof(ph_position2d_cmd_pos)};

static const ph_field ph_position2d_cmd_car_fields[2] = {
    {"velocity", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_car, velocity), 0, NULL},
    {"angle", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_car, angle), 0, NULL},
};
const ph_struct_type ph_position2d_cmd_car_type = {"position2d.CmdCar", ph_position2d_cmd_car_fields, 2, 16, sizeof(ph_position2d_cmd_car)};

static const ph_field ph_position2d_cmd_vel_head_fields[2] = {
    {"velocity", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_vel_head, velocity), 0, NULL},
    {"angle", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_cmd_vel_head, angle), 0, NULL},
};
const ph_struct_type ph_position2d_cmd_vel_head_type = {"position2d.CmdVelHead", ph_position2d_cmd_vel_head_fields, 2, 16, sizeof(ph_position2d_cmd_vel_head)};

static const ph_field ph_position2d_geom_fields[2] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_geom, size), 0, &ph_common_bbox3d_type},
};
const ph_struct_type ph_position2d_geom_type = {"position2d.Geom", ph_position2d_geom_fields, 2, 72, sizeof(ph_position2d_geom)};

static const ph_field ph_position2d_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_power_config, state), 0, NULL},
};
const ph_struct_type ph_position2d_power_config_type = {"position2d.PowerConfig", ph_position2d_power_config_fields, 1, 4, sizeof(ph_position2d_power_config)};

static const ph_field ph_position2d_velocity_mode_config_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_velocity_mode_config, value), 0, NULL},
};
const ph_struct_type ph_position2d_velocity_mode_config_type = {"position2d.VelocityModeConfig", ph_position2d_velocity_mode_config_fields, 1, 4, sizeof(ph_position2d_velocity_mode_config)};

static const ph_field ph_position2d_position_mode_req_fields[1] = {
    {"state", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_position_mode_req, state), 0, NULL},
};
const ph_struct_type ph_position2d_position_mode_req_type = {"position2d.PositionModeReq", ph_position2d_position_mode_req_fields, 1, 4, sizeof(ph_position2d_position_mode_req)};

static const ph_field ph_position2d_set_odom_req_fields[1] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_set_odom_req, pose), 0, &ph_common_pose2d_type},
};
const ph_struct_type ph_position2d_set_odom_req_type = {"position2d.SetOdomReq", ph_position2d_set_odom_req_fields, 1, 24, sizeof(ph_position2d_set_odom_req)};

static const ph_field ph_position2d_speed_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_speed_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_speed_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_speed_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position2d_speed_pid_req_type = {"position2d.SpeedPidReq", ph_position2d_speed_pid_req_fields, 3, 12, sizeof(ph_position2d_speed_pid_req)};

static const ph_field ph_position2d_position_pid_req_fields[3] = {
    {"kp", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_position_pid_req, kp), 0, NULL},
    {"ki", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_position_pid_req, ki), 0, NULL},
    {"kd", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_position_pid_req, kd), 0, NULL},
};
const ph_struct_type ph_position2d_position_pid_req_type = {"position2d.PositionPidReq", ph_position2d_position_pid_req_fields, 3, 12, sizeof(ph_position2d_position_pid_req)};

static const ph_field ph_position2d_speed_prof_req_fields[2] = {
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_speed_prof_req, speed), 0, NULL},
    {"acc", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_position2d_speed_prof_req, acc), 0, NULL},
};
const ph_struct_type ph_position2d_speed_prof_req_type = {"position2d.SpeedProfReq", ph_position2d_speed_prof_req_fields, 2, 8, sizeof(ph_position2d_speed_prof_req)};

const ph_message_type ph_position2d_messages[15] = {
    {4, PH_KIND_DATA, 1, "position2d.data.state", &ph_position2d_data_type},
    {4, PH_KIND_DATA, 2, "position2d.data.geom", &ph_position2d_geom_type},
    {4, PH_KIND_CMD, 1, "position2d.cmd.vel", &ph_position2d_cmd_vel_type},
    {4, PH_KIND_CMD, 2, "position2d.cmd.pos", &ph_position2d_cmd_pos_type},
    {4, PH_KIND_CMD, 3, "position2d.cmd.car", &ph_position2d_cmd_car_type},
    {4, PH_KIND_CMD, 4, "position2d.cmd.vel_head", &ph_position2d_cmd_vel_head_type},
    {4, PH_KIND_REQ, 1, "position2d.req.get_geom", &ph_position2d_geom_type},
    {4, PH_KIND_REQ, 2, "position2d.req.motor_power", &ph_position2d_power_config_type},
    {4, PH_KIND_REQ, 3, "position2d.req.velocity_mode", &ph_position2d_velocity_mode_config_type},
    {4, PH_KIND_REQ, 4, "position2d.req.position_mode", &ph_position2d_position_mode_req_type},
    {4, PH_KIND_REQ, 5, "position2d.req.set_odom", &ph_position2d_set_odom_req_type},
    {4, PH_KIND_REQ, 6, "position2d.req.reset_odom", NULL},
    {4, PH_KIND_REQ, 7, "position2d.req.speed_pid", &ph_position2d_speed_pid_req_type},
    {4, PH_KIND_REQ, 8, "position2d.req.position_pid", &ph_position2d_position_pid_req_type},
    {4, PH_KIND_REQ, 9, "position2d.req.speed_prof", &ph_position2d_speed_prof_req_type},
};
