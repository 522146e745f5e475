#ifndef PLAYHOUSE_C_POSITION2D_H
#define PLAYHOUSE_C_POSITION2D_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A mobile base. Closing it while it moves stops it first. */
PH_PROXY(position2d)

/** The data of a base: pose estimate, velocity, and whether it is blocked. `pose` is in the frame of the
 * estimate: with odometry that of the start pose, or as set by ph_position2d_set_odometry(); with
 * localization by gps the world. `time` is the server's, in s. */
typedef struct ph_state {
  ph_pose pose;
  ph_velocity velocity;
  bool stalled;
  double time;
} ph_state;

ph_status ph_position2d_state(ph_position2d *robot, ph_state *state, ph_error *error);
/** Forward and to the left in m/s, turning in rad/s, until the next command. */
ph_status ph_position2d_drive(ph_position2d *robot, double vx, double va, double vy, ph_error *error);
ph_status ph_position2d_stop(ph_position2d *robot, ph_error *error);
/** For a base with car steering: speed in m/s, and steering angle in rad, positive to the left. */
ph_status ph_position2d_drive_car(ph_position2d *robot, double speed, double steering, ph_error *error);
/** Drives to a pose in the frame of ph_state.pose, by the driver's position control; speed 0: the driver's
 * choice. */
ph_status ph_position2d_go_to(ph_position2d *robot, ph_pose pose, double speed, ph_error *error);
ph_status ph_position2d_set_motor_power(ph_position2d *robot, bool on, ph_error *error);
/** Sets the pose estimate; the robot does not move. */
ph_status ph_position2d_set_odometry(ph_position2d *robot, ph_pose pose, ph_error *error);
ph_status ph_position2d_reset_odometry(ph_position2d *robot, ph_error *error);
ph_status ph_position2d_geometry(ph_position2d *robot, ph_geometry *geometry, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_POSITION2D_H */
