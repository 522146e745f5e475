#ifndef PLAYHOUSE_C_IMU_H
#define PLAYHOUSE_C_IMU_H

#include "playhouse/c/generated/imu.h"
#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An inertial unit. ph_imu_send() selects the data message; initially it is that of ph_imu_pose(). */
PH_PROXY(imu)

/** Measurements of an inertial unit along and about its own axes x, y and z: specific force in m/s^2, (0,
 * 0, 9.81) when level and at rest; turn rates in rad/s; magnetic field, in a unit of the server. */
typedef struct ph_inertia {
  double acceleration[3];
  double turn_rate[3];
  double field[3];
} ph_inertia;

/** One of PH_IMU_DATA_STATE (pose), PH_IMU_DATA_CALIB (inertia), PH_IMU_DATA_QUAT (inertia and quaternion),
 * PH_IMU_DATA_EULER (inertia and attitude) and PH_IMU_DATA_FULLSTATE (pose and velocity), for all
 * subscribers of the device. */
ph_status ph_imu_send(ph_imu *unit, const ph_message_type *datatype, ph_error *error);
/** Estimated pose. */
ph_status ph_imu_pose(ph_imu *unit, ph_pose3d *pose, ph_error *error);
/** Estimated velocity, along and about its own axes. */
ph_status ph_imu_velocity(ph_imu *unit, ph_pose3d *velocity, ph_error *error);
ph_status ph_imu_inertia(ph_imu *unit, ph_inertia *inertia, ph_error *error);
/** Roll, pitch and yaw, in rad. */
ph_status ph_imu_attitude(ph_imu *unit, double attitude[3], ph_error *error);
/** Orientation, the real part first. */
ph_status ph_imu_quaternion(ph_imu *unit, double quaternion[4], ph_error *error);
/** Makes the current heading, or the whole current orientation, the reference. */
ph_status ph_imu_reset_orientation(ph_imu *unit, bool all_axes, ph_error *error);
/** Sets the current orientation, in rad. */
ph_status ph_imu_reset_attitude(ph_imu *unit, double roll, double pitch, double yaw, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_IMU_H */
