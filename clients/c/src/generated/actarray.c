/** Generated from interfaces/053_actarray.toml by codegen; do not edit. */
#include "playhouse/c/generated/actarray.h"

#include <stddef.h>

static const ph_field ph_actarray_actuator_fields[5] = {
    {"position", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuator, position), 0, NULL},
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuator, speed), 0, NULL},
    {"acceleration", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuator, acceleration), 0, NULL},
    {"current", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuator, current), 0, NULL},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuator, state), 0, NULL},
};
const ph_struct_type ph_actarray_actuator_type = {"actarray.Actuator", ph_actarray_actuator_fields, 5, 20, sizeof(ph_actarray_actuator)};

static const ph_field ph_actarray_data_fields[2] = {
    {"actuators", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1677719, offsetof(ph_actarray_data, actuators), offsetof(ph_actarray_data, actuators_count), &ph_actarray_actuator_type},
    {"motor_state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_data, motor_state), 0, NULL},
};
const ph_struct_type ph_actarray_data_type = {"actarray.Data", ph_actarray_data_fields, 2, 12, sizeof(ph_actarray_data)};

static const ph_field ph_actarray_actuatorgeom_fields[10] = {
    {"type", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, type), 0, NULL},
    {"length", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, length), 0, NULL},
    {"orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, orientation), 0, &ph_common_orientation3d_type},
    {"axis", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, axis), 0, &ph_common_point3d_type},
    {"min", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, min), 0, NULL},
    {"centre", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, centre), 0, NULL},
    {"max", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, max), 0, NULL},
    {"home", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, home), 0, NULL},
    {"config_speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, config_speed), 0, NULL},
    {"hasbrakes", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_actuatorgeom, hasbrakes), 0, NULL},
};
const ph_struct_type ph_actarray_actuatorgeom_type = {"actarray.Actuatorgeom", ph_actarray_actuatorgeom_fields, 10, 80, sizeof(ph_actarray_actuatorgeom)};

static const ph_field ph_actarray_geom_fields[3] = {
    {"actuators", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 419429, offsetof(ph_actarray_geom, actuators), offsetof(ph_actarray_geom, actuators_count), &ph_actarray_actuatorgeom_type},
    {"base_pos", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_geom, base_pos), 0, &ph_common_point3d_type},
    {"base_orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_geom, base_orientation), 0, &ph_common_orientation3d_type},
};
const ph_struct_type ph_actarray_geom_type = {"actarray.Geom", ph_actarray_geom_fields, 3, 56, sizeof(ph_actarray_geom)};

static const ph_field ph_actarray_position_cmd_fields[2] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_position_cmd, joint), 0, NULL},
    {"position", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_position_cmd, position), 0, NULL},
};
const ph_struct_type ph_actarray_position_cmd_type = {"actarray.PositionCmd", ph_actarray_position_cmd_fields, 2, 8, sizeof(ph_actarray_position_cmd)};

static const ph_field ph_actarray_multi_position_cmd_fields[1] = {
    {"positions", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_actarray_multi_position_cmd, positions), offsetof(ph_actarray_multi_position_cmd, positions_count), NULL},
};
const ph_struct_type ph_actarray_multi_position_cmd_type = {"actarray.MultiPositionCmd", ph_actarray_multi_position_cmd_fields, 1, 8, sizeof(ph_actarray_multi_position_cmd)};

static const ph_field ph_actarray_speed_cmd_fields[2] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_speed_cmd, joint), 0, NULL},
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_speed_cmd, speed), 0, NULL},
};
const ph_struct_type ph_actarray_speed_cmd_type = {"actarray.SpeedCmd", ph_actarray_speed_cmd_fields, 2, 8, sizeof(ph_actarray_speed_cmd)};

static const ph_field ph_actarray_multi_speed_cmd_fields[1] = {
    {"speeds", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_actarray_multi_speed_cmd, speeds), offsetof(ph_actarray_multi_speed_cmd, speeds_count), NULL},
};
const ph_struct_type ph_actarray_multi_speed_cmd_type = {"actarray.MultiSpeedCmd", ph_actarray_multi_speed_cmd_fields, 1, 8, sizeof(ph_actarray_multi_speed_cmd)};

static const ph_field ph_actarray_home_cmd_fields[1] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_home_cmd, joint), 0, NULL},
};
const ph_struct_type ph_actarray_home_cmd_type = {"actarray.HomeCmd", ph_actarray_home_cmd_fields, 1, 4, sizeof(ph_actarray_home_cmd)};

static const ph_field ph_actarray_current_cmd_fields[2] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_current_cmd, joint), 0, NULL},
    {"current", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_current_cmd, current), 0, NULL},
};
const ph_struct_type ph_actarray_current_cmd_type = {"actarray.CurrentCmd", ph_actarray_current_cmd_fields, 2, 8, sizeof(ph_actarray_current_cmd)};

static const ph_field ph_actarray_multi_current_cmd_fields[1] = {
    {"currents", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_actarray_multi_current_cmd, currents), offsetof(ph_actarray_multi_current_cmd, currents_count), NULL},
};
const ph_struct_type ph_actarray_multi_current_cmd_type = {"actarray.MultiCurrentCmd", ph_actarray_multi_current_cmd_fields, 1, 8, sizeof(ph_actarray_multi_current_cmd)};

static const ph_field ph_actarray_power_config_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_power_config, value), 0, NULL},
};
const ph_struct_type ph_actarray_power_config_type = {"actarray.PowerConfig", ph_actarray_power_config_fields, 1, 4, sizeof(ph_actarray_power_config)};

static const ph_field ph_actarray_brakes_config_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_brakes_config, value), 0, NULL},
};
const ph_struct_type ph_actarray_brakes_config_type = {"actarray.BrakesConfig", ph_actarray_brakes_config_fields, 1, 4, sizeof(ph_actarray_brakes_config)};

static const ph_field ph_actarray_speed_config_fields[2] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_speed_config, joint), 0, NULL},
    {"speed", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_speed_config, speed), 0, NULL},
};
const ph_struct_type ph_actarray_speed_config_type = {"actarray.SpeedConfig", ph_actarray_speed_config_fields, 2, 8, sizeof(ph_actarray_speed_config)};

static const ph_field ph_actarray_accel_config_fields[2] = {
    {"joint", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_accel_config, joint), 0, NULL},
    {"accel", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_actarray_accel_config, accel), 0, NULL},
};
const ph_struct_type ph_actarray_accel_config_type = {"actarray.AccelConfig", ph_actarray_accel_config_fields, 2, 8, sizeof(ph_actarray_accel_config)};

const ph_message_type ph_actarray_messages[13] = {
    {53, PH_KIND_DATA, 1, "actarray.data.state", &ph_actarray_data_type},
    {53, PH_KIND_CMD, 1, "actarray.cmd.pos", &ph_actarray_position_cmd_type},
    {53, PH_KIND_CMD, 2, "actarray.cmd.multi_pos", &ph_actarray_multi_position_cmd_type},
    {53, PH_KIND_CMD, 3, "actarray.cmd.speed", &ph_actarray_speed_cmd_type},
    {53, PH_KIND_CMD, 4, "actarray.cmd.multi_speed", &ph_actarray_multi_speed_cmd_type},
    {53, PH_KIND_CMD, 5, "actarray.cmd.home", &ph_actarray_home_cmd_type},
    {53, PH_KIND_CMD, 6, "actarray.cmd.current", &ph_actarray_current_cmd_type},
    {53, PH_KIND_CMD, 7, "actarray.cmd.multi_current", &ph_actarray_multi_current_cmd_type},
    {53, PH_KIND_REQ, 1, "actarray.req.power", &ph_actarray_power_config_type},
    {53, PH_KIND_REQ, 2, "actarray.req.brakes", &ph_actarray_brakes_config_type},
    {53, PH_KIND_REQ, 3, "actarray.req.get_geom", &ph_actarray_geom_type},
    {53, PH_KIND_REQ, 4, "actarray.req.speed", &ph_actarray_speed_config_type},
    {53, PH_KIND_REQ, 5, "actarray.req.accel", &ph_actarray_accel_config_type},
};
