#ifndef PLAYHOUSE_C_POSITION3D_H
#define PLAYHOUSE_C_POSITION3D_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A mobile base in space. Closing it while it moves stops it first. */
PH_PROXY(position3d)

/** The data of a base that moves in space: pose estimate, velocity (m/s and rad/s along and about its own
 * axes), and whether it is blocked. `time` is the server's, in s. */
typedef struct ph_state3d {
  ph_pose3d pose;
  ph_pose3d velocity;
  bool stalled;
  double time;
} ph_state3d;

ph_status ph_position3d_state(ph_position3d *robot, ph_state3d *state, ph_error *error);
/** Forward, to the left and upwards in m/s, turning in rad/s, until the next command. */
ph_status ph_position3d_drive(ph_position3d *robot, double vx, double va, double vy, double vz,
                              ph_error *error);
ph_status ph_position3d_stop(ph_position3d *robot, ph_error *error);
/** Moves to a pose in the frame of ph_state3d.pose, by the driver's position control. */
ph_status ph_position3d_go_to(ph_position3d *robot, ph_pose3d pose, ph_error *error);
ph_status ph_position3d_set_motor_power(ph_position3d *robot, bool on, ph_error *error);
/** Sets the pose estimate, ph_state3d.pose. */
ph_status ph_position3d_set_odometry(ph_position3d *robot, ph_pose3d pose, ph_error *error);
ph_status ph_position3d_reset_odometry(ph_position3d *robot, ph_error *error);
ph_status ph_position3d_geometry(ph_position3d *robot, ph_geometry *geometry, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_POSITION3D_H */
