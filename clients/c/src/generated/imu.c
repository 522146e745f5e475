/** Generated from interfaces/060_imu.toml by codegen; do not edit. */
#include "playhouse/c/generated/imu.h"

#include <stddef.h>

static const ph_field ph_imu_data_state_fields[1] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_state, pose), 0, &ph_common_pose3d_type},
};
const ph_struct_type ph_imu_data_state_type = {"imu.DataState", ph_imu_data_state_fields, 1, 48, sizeof(ph_imu_data_state)};

static const ph_field ph_imu_data_calib_fields[9] = {
    {"accel_x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, accel_x), 0, NULL},
    {"accel_y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, accel_y), 0, NULL},
    {"accel_z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, accel_z), 0, NULL},
    {"gyro_x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, gyro_x), 0, NULL},
    {"gyro_y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, gyro_y), 0, NULL},
    {"gyro_z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, gyro_z), 0, NULL},
    {"magn_x", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, magn_x), 0, NULL},
    {"magn_y", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, magn_y), 0, NULL},
    {"magn_z", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_calib, magn_z), 0, NULL},
};
const ph_struct_type ph_imu_data_calib_type = {"imu.DataCalib", ph_imu_data_calib_fields, 9, 36, sizeof(ph_imu_data_calib)};

static const ph_field ph_imu_data_quat_fields[5] = {
    {"calib_data", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_quat, calib_data), 0, &ph_imu_data_calib_type},
    {"q0", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_quat, q0), 0, NULL},
    {"q1", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_quat, q1), 0, NULL},
    {"q2", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_quat, q2), 0, NULL},
    {"q3", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_quat, q3), 0, NULL},
};
const ph_struct_type ph_imu_data_quat_type = {"imu.DataQuat", ph_imu_data_quat_fields, 5, 52, sizeof(ph_imu_data_quat)};

static const ph_field ph_imu_data_euler_fields[2] = {
    {"calib_data", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_euler, calib_data), 0, &ph_imu_data_calib_type},
    {"orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_euler, orientation), 0, &ph_common_orientation3d_type},
};
const ph_struct_type ph_imu_data_euler_type = {"imu.DataEuler", ph_imu_data_euler_fields, 2, 60, sizeof(ph_imu_data_euler)};

static const ph_field ph_imu_data_fullstate_fields[3] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_fullstate, pose), 0, &ph_common_pose3d_type},
    {"vel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_fullstate, vel), 0, &ph_common_pose3d_type},
    {"acc", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_data_fullstate, acc), 0, &ph_common_pose3d_type},
};
const ph_struct_type ph_imu_data_fullstate_type = {"imu.DataFullstate", ph_imu_data_fullstate_fields, 3, 144, sizeof(ph_imu_data_fullstate)};

static const ph_field ph_imu_datatype_config_fields[1] = {
    {"value", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_datatype_config, value), 0, NULL},
};
const ph_struct_type ph_imu_datatype_config_type = {"imu.DatatypeConfig", ph_imu_datatype_config_fields, 1, 4, sizeof(ph_imu_datatype_config)};

static const ph_field ph_imu_reset_orientation_config_fields[1] = {
    {"value", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_reset_orientation_config, value), 0, NULL},
};
const ph_struct_type ph_imu_reset_orientation_config_type = {"imu.ResetOrientationConfig", ph_imu_reset_orientation_config_fields, 1, 4, sizeof(ph_imu_reset_orientation_config)};

static const ph_field ph_imu_reset_euler_config_fields[1] = {
    {"orientation", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_imu_reset_euler_config, orientation), 0, &ph_common_pose3d_type},
};
const ph_struct_type ph_imu_reset_euler_config_type = {"imu.ResetEulerConfig", ph_imu_reset_euler_config_fields, 1, 48, sizeof(ph_imu_reset_euler_config)};

const ph_message_type ph_imu_messages[8] = {
    {60, PH_KIND_DATA, 1, "imu.data.state", &ph_imu_data_state_type},
    {60, PH_KIND_DATA, 2, "imu.data.calib", &ph_imu_data_calib_type},
    {60, PH_KIND_DATA, 3, "imu.data.quat", &ph_imu_data_quat_type},
    {60, PH_KIND_DATA, 4, "imu.data.euler", &ph_imu_data_euler_type},
    {60, PH_KIND_DATA, 5, "imu.data.fullstate", &ph_imu_data_fullstate_type},
    {60, PH_KIND_REQ, 1, "imu.req.set_datatype", &ph_imu_datatype_config_type},
    {60, PH_KIND_REQ, 2, "imu.req.reset_orientation", &ph_imu_reset_orientation_config_type},
    {60, PH_KIND_REQ, 3, "imu.req.reset_euler", &ph_imu_reset_euler_config_type},
};
