/** Interface position3d, code 30. A robot that moves in 3D. Generated from interfaces/030_position3d.toml
 * by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_POSITION3D_H
#define PLAYHOUSE_C_GENERATED_POSITION3D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_POSITION3D_CODE 30

/** Odometry. (player_position3d_data_t) */
typedef struct ph_position3d_data {
  /** Pose from odometry (in m, m, m, rad, rad, rad, frame X_OR). */
  ph_common_pose3d pos;
  /** Velocity along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R). */
  ph_common_pose3d vel;
  /** 1 if the robot is blocked by an obstacle. */
  uint8_t stall;
} ph_position3d_data;
PH_CODEC(ph_position3d_data)

/** Commanded pose, and the velocity on the way. (player_position3d_cmd_pos_t) */
typedef struct ph_position3d_cmd_pos {
  /** Goal (in m, m, m, rad, rad, rad, frame X_OG). */
  ph_common_pose3d pos;
  /** Velocity on the way; zero: chosen by the driver (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame
   * v_OR_R). */
  ph_common_pose3d vel;
  /** 1: motors on, 0: off. */
  uint8_t state;
} ph_position3d_cmd_pos;
PH_CODEC(ph_position3d_cmd_pos)

/** Commanded velocity. (player_position3d_cmd_vel_t) */
typedef struct ph_position3d_cmd_vel {
  /** Along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R). */
  ph_common_pose3d vel;
  /** 1: motors on, 0: off. */
  uint8_t state;
} ph_position3d_cmd_vel;
PH_CODEC(ph_position3d_cmd_vel)

/** The robot's size and centre of rotation. (player_position3d_geom_t) */
typedef struct ph_position3d_geom {
  /** Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame
   * X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the robot (in m, m, m). */
  ph_common_bbox3d size;
} ph_position3d_geom;
PH_CODEC(ph_position3d_geom)

/** The motors' switch. (player_position3d_power_config_t) */
typedef struct ph_position3d_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_position3d_power_config;
PH_CODEC(ph_position3d_power_config)

/** A control mode. (player_position3d_position_mode_req_t) */
typedef struct ph_position3d_position_mode_req {
  /** 0: velocity, 1: position. */
  uint32_t value;
} ph_position3d_position_mode_req;
PH_CODEC(ph_position3d_position_mode_req)

/** A velocity controller. (player_position3d_velocity_mode_config_t) */
typedef struct ph_position3d_velocity_mode_config {
  /** Driver-specific. */
  uint32_t value;
} ph_position3d_velocity_mode_config;
PH_CODEC(ph_position3d_velocity_mode_config)

/** A new odometric pose. (player_position3d_set_odom_req_t) */
typedef struct ph_position3d_set_odom_req {
  /** New odometric pose (in m, m, m, rad, rad, rad, frame X_OR). */
  ph_common_pose3d pos;
} ph_position3d_set_odom_req;
PH_CODEC(ph_position3d_set_odom_req)

/** Gains of velocity control. (player_position3d_speed_pid_req_t) */
typedef struct ph_position3d_speed_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position3d_speed_pid_req;
PH_CODEC(ph_position3d_speed_pid_req)

/** Gains of position control. (player_position3d_position_pid_req_t) */
typedef struct ph_position3d_position_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position3d_position_pid_req;
PH_CODEC(ph_position3d_position_pid_req)

/** Limits of position control. (player_position3d_speed_prof_req_t) */
typedef struct ph_position3d_speed_prof_req {
  /** Maximum turn rate (in rad/s). */
  float speed;
  /** Maximum angular acceleration (in rad/s^2). */
  float acc;
} ph_position3d_speed_prof_req;
PH_CODEC(ph_position3d_speed_prof_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_position3d_messages[13];
/** Odometry. */
#define PH_POSITION3D_DATA_STATE (&ph_position3d_messages[0])
/** The robot's size, sent on change. */
#define PH_POSITION3D_DATA_GEOMETRY (&ph_position3d_messages[1])
/** Commanded velocity. */
#define PH_POSITION3D_CMD_SET_VEL (&ph_position3d_messages[2])
/** Commanded pose in the odometry frame. */
#define PH_POSITION3D_CMD_SET_POS (&ph_position3d_messages[3])
/** Requests the robot's size and centre of rotation. */
#define PH_POSITION3D_REQ_GET_GEOM (&ph_position3d_messages[4])
/** Switches the motors on or off. */
#define PH_POSITION3D_REQ_MOTOR_POWER (&ph_position3d_messages[5])
/** Selects the driver's velocity controller. */
#define PH_POSITION3D_REQ_VELOCITY_MODE (&ph_position3d_messages[6])
/** Selects between velocity and position control. */
#define PH_POSITION3D_REQ_POSITION_MODE (&ph_position3d_messages[7])
/** Sets the odometric pose to zero. */
#define PH_POSITION3D_REQ_RESET_ODOM (&ph_position3d_messages[8])
/** Sets the odometric pose. */
#define PH_POSITION3D_REQ_SET_ODOM (&ph_position3d_messages[9])
/** Sets the gains of velocity control. */
#define PH_POSITION3D_REQ_SPEED_PID (&ph_position3d_messages[10])
/** Sets the gains of position control. */
#define PH_POSITION3D_REQ_POSITION_PID (&ph_position3d_messages[11])
/** Sets the turn rate and angular acceleration limits of position control. */
#define PH_POSITION3D_REQ_SPEED_PROF (&ph_position3d_messages[12])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_POSITION3D_H */
