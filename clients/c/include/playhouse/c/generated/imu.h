/** Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation. Generated from
 * interfaces/060_imu.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_IMU_H
#define PLAYHOUSE_C_GENERATED_IMU_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_IMU_CODE 60

/** Pose by integration. (player_imu_data_state_t) */
typedef struct ph_imu_data_state {
  /** In m, m, m, rad, rad, rad, frame X_WS. */
  ph_common_pose3d pose;
} ph_imu_data_state;
PH_CODEC(ph_imu_data_state)

/** Calibrated readings. (player_imu_data_calib_t) */
typedef struct ph_imu_data_calib {
  /** In m/s^2, frame a_WS_S. */
  float accel_x;
  /** In m/s^2, frame a_WS_S. */
  float accel_y;
  /** In m/s^2, frame a_WS_S. */
  float accel_z;
  /** In rad/s, frame v_WS_S. */
  float gyro_x;
  /** In rad/s, frame v_WS_S. */
  float gyro_y;
  /** In rad/s, frame v_WS_S. */
  float gyro_z;
  /** Magnetic field, in a driver-specific unit (frame n_S). */
  float magn_x;
  /** Frame n_S. */
  float magn_y;
  /** Frame n_S. */
  float magn_z;
} ph_imu_data_calib;
PH_CODEC(ph_imu_data_calib)

/** Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t) */
typedef struct ph_imu_data_quat {
  ph_imu_data_calib calib_data;
  /** Real part (frame R_WS). */
  float q0;
  /** Frame R_WS. */
  float q1;
  /** Frame R_WS. */
  float q2;
  /** Frame R_WS. */
  float q3;
} ph_imu_data_quat;
PH_CODEC(ph_imu_data_quat)

/** Calibrated readings and orientation as angles. (player_imu_data_euler_t) */
typedef struct ph_imu_data_euler {
  ph_imu_data_calib calib_data;
  /** In rad, frame R_WS. */
  ph_common_orientation3d orientation;
} ph_imu_data_euler;
PH_CODEC(ph_imu_data_euler)

/** Pose, velocity and acceleration. (player_imu_data_fullstate_t) */
typedef struct ph_imu_data_fullstate {
  /** In m, m, m, rad, rad, rad, frame X_WS. */
  ph_common_pose3d pose;
  /** In m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S. */
  ph_common_pose3d vel;
  /** In m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S. */
  ph_common_pose3d acc;
} ph_imu_data_fullstate;
PH_CODEC(ph_imu_data_fullstate)

/** Selected data message. (player_imu_datatype_config_t) */
typedef struct ph_imu_datatype_config {
  /** Its subtype. */
  uint8_t value;
} ph_imu_datatype_config;
PH_CODEC(ph_imu_datatype_config)

/** Quantity that becomes the reference. (player_imu_reset_orientation_config_t) */
typedef struct ph_imu_reset_orientation_config {
  /** 0: heading, 1: orientation, 2: driver-specific. */
  uint32_t value;
} ph_imu_reset_orientation_config;
PH_CODEC(ph_imu_reset_orientation_config)

/** A new orientation. (player_imu_reset_euler_config_t) */
typedef struct ph_imu_reset_euler_config {
  /** Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS). */
  ph_common_pose3d orientation;
} ph_imu_reset_euler_config;
PH_CODEC(ph_imu_reset_euler_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_imu_messages[8];
/** Pose by integration. */
#define PH_IMU_DATA_STATE (&ph_imu_messages[0])
/** Calibrated readings. */
#define PH_IMU_DATA_CALIB (&ph_imu_messages[1])
/** Calibrated readings and orientation as a quaternion. */
#define PH_IMU_DATA_QUAT (&ph_imu_messages[2])
/** Calibrated readings and orientation as angles. */
#define PH_IMU_DATA_EULER (&ph_imu_messages[3])
/** Pose, velocity and acceleration. */
#define PH_IMU_DATA_FULLSTATE (&ph_imu_messages[4])
/** Selects which data message is sent. */
#define PH_IMU_REQ_SET_DATATYPE (&ph_imu_messages[5])
/** Makes the current orientation the reference. */
#define PH_IMU_REQ_RESET_ORIENTATION (&ph_imu_messages[6])
/** Sets the current orientation. */
#define PH_IMU_REQ_RESET_EULER (&ph_imu_messages[7])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_IMU_H */
