/** Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control.
 * Generated from interfaces/004_position2d.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_POSITION2D_H
#define PLAYHOUSE_C_GENERATED_POSITION2D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_POSITION2D_CODE 4

/** Odometry. (player_position2d_data_t) */
typedef struct ph_position2d_data {
  /** Pose from odometry (in m, m, rad, frame X_OR). */
  ph_common_pose2d pos;
  /** Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R). */
  ph_common_pose2d vel;
  /** 1 if the robot is blocked by an obstacle. */
  uint8_t stall;
} ph_position2d_data;
PH_CODEC(ph_position2d_data)

/** Commanded velocity. (player_position2d_cmd_vel_t) */
typedef struct ph_position2d_cmd_vel {
  /** Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad
   * (in m/s, m/s, rad/s, frame v_OR_R). */
  ph_common_pose2d vel;
  /** 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER. */
  uint8_t state;
} ph_position2d_cmd_vel;
PH_CODEC(ph_position2d_cmd_vel)

/** Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t) */
typedef struct ph_position2d_cmd_pos {
  /** Goal (in m, m, rad, frame X_OG). */
  ph_common_pose2d pos;
  /** Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s, rad/s,
   * frame v_OR_R). */
  ph_common_pose2d vel;
  /** 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER. */
  uint8_t state;
} ph_position2d_cmd_pos;
PH_CODEC(ph_position2d_cmd_pos)

/** Commanded motion of a car. (player_position2d_cmd_car_t) */
typedef struct ph_position2d_cmd_car {
  /** Forward (in m/s). */
  double velocity;
  /** Steering angle of the front wheels, positive to the left; a simulated robot without them uses it as
   * turn rate in rad/s (in rad). */
  double angle;
} ph_position2d_cmd_car;
PH_CODEC(ph_position2d_cmd_car)

/** Commanded speed and heading. (player_position2d_cmd_vel_head_t) */
typedef struct ph_position2d_cmd_vel_head {
  /** Forward (in m/s). */
  double velocity;
  /** Heading in the odometry frame (in rad). */
  double angle;
} ph_position2d_cmd_vel_head;
PH_CODEC(ph_position2d_cmd_vel_head)

/** The robot's size and centre of rotation. (player_position2d_geom_t) */
typedef struct ph_position2d_geom {
  /** Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame
   * X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the robot (in m, m, m). */
  ph_common_bbox3d size;
} ph_position2d_geom;
PH_CODEC(ph_position2d_geom)

/** The motors' switch. (player_position2d_power_config_t) */
typedef struct ph_position2d_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_position2d_power_config;
PH_CODEC(ph_position2d_power_config)

/** A velocity controller. (player_position2d_velocity_mode_config_t) */
typedef struct ph_position2d_velocity_mode_config {
  /** Driver-specific. */
  uint32_t value;
} ph_position2d_velocity_mode_config;
PH_CODEC(ph_position2d_velocity_mode_config)

/** A control mode. (player_position2d_position_mode_req_t) */
typedef struct ph_position2d_position_mode_req {
  /** 0: velocity, 1: position. */
  uint32_t state;
} ph_position2d_position_mode_req;
PH_CODEC(ph_position2d_position_mode_req)

/** A new odometric pose. (player_position2d_set_odom_req_t) */
typedef struct ph_position2d_set_odom_req {
  /** New odometric pose (in m, m, rad, frame X_OR). */
  ph_common_pose2d pose;
} ph_position2d_set_odom_req;
PH_CODEC(ph_position2d_set_odom_req)

/** Gains of velocity control. (player_position2d_speed_pid_req_t) */
typedef struct ph_position2d_speed_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position2d_speed_pid_req;
PH_CODEC(ph_position2d_speed_pid_req)

/** Gains of position control. (player_position2d_position_pid_req_t) */
typedef struct ph_position2d_position_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position2d_position_pid_req;
PH_CODEC(ph_position2d_position_pid_req)

/** Limits of position control. (player_position2d_speed_prof_req_t) */
typedef struct ph_position2d_speed_prof_req {
  /** Maximum speed (in m/s). */
  float speed;
  /** Maximum acceleration (in m/s^2). */
  float acc;
} ph_position2d_speed_prof_req;
PH_CODEC(ph_position2d_speed_prof_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_position2d_messages[15];
/** Odometry. */
#define PH_POSITION2D_DATA_STATE (&ph_position2d_messages[0])
/** The robot's size, sent on change. */
#define PH_POSITION2D_DATA_GEOM (&ph_position2d_messages[1])
/** Commanded velocity. */
#define PH_POSITION2D_CMD_VEL (&ph_position2d_messages[2])
/** Commanded pose in the odometry frame. */
#define PH_POSITION2D_CMD_POS (&ph_position2d_messages[3])
/** Commanded speed and steering angle of a car. */
#define PH_POSITION2D_CMD_CAR (&ph_position2d_messages[4])
/** Commanded speed and heading. */
#define PH_POSITION2D_CMD_VEL_HEAD (&ph_position2d_messages[5])
/** Requests the robot's size and centre of rotation. */
#define PH_POSITION2D_REQ_GET_GEOM (&ph_position2d_messages[6])
/** Switches the motors on or off. */
#define PH_POSITION2D_REQ_MOTOR_POWER (&ph_position2d_messages[7])
/** Selects the driver's velocity controller. */
#define PH_POSITION2D_REQ_VELOCITY_MODE (&ph_position2d_messages[8])
/** Selects between velocity and position control. */
#define PH_POSITION2D_REQ_POSITION_MODE (&ph_position2d_messages[9])
/** Sets the odometric pose. */
#define PH_POSITION2D_REQ_SET_ODOM (&ph_position2d_messages[10])
/** Sets the odometric pose to zero. */
#define PH_POSITION2D_REQ_RESET_ODOM (&ph_position2d_messages[11])
/** Sets the gains of velocity control. */
#define PH_POSITION2D_REQ_SPEED_PID (&ph_position2d_messages[12])
/** Sets the gains of position control. */
#define PH_POSITION2D_REQ_POSITION_PID (&ph_position2d_messages[13])
/** Sets the speed and acceleration limits of position control. */
#define PH_POSITION2D_REQ_SPEED_PROF (&ph_position2d_messages[14])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_POSITION2D_H */
