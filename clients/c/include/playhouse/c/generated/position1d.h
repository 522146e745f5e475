/** Interface position1d, code 52. A single prismatic or revolute actuator. Generated from
 * interfaces/052_position1d.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_POSITION1D_H
#define PLAYHOUSE_C_GENERATED_POSITION1D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_POSITION1D_CODE 52

/** Bits of Data.status, by number. */
enum {
  PH_POSITION1D_STATUS_LIMIT_MIN = 0,
  PH_POSITION1D_STATUS_LIMIT_CEN = 1,
  PH_POSITION1D_STATUS_LIMIT_MAX = 2,
  PH_POSITION1D_STATUS_OC = 3,
  PH_POSITION1D_STATUS_TRAJ_COMPLETE = 4,
  PH_POSITION1D_STATUS_ENABLED = 5,
};

/** Position of the actuator. (player_position1d_data_t) */
typedef struct ph_position1d_data {
  /** From its zero (in m or rad). */
  float pos;
  /** In m/s or rad/s. */
  float vel;
  /** 1 if it is blocked by an obstacle. */
  uint8_t stall;
  /** Limits, current, motion and power, one bit each. */
  uint8_t status;
} ph_position1d_data;
PH_CODEC(ph_position1d_data)

/** Commanded velocity. (player_position1d_cmd_vel_t) */
typedef struct ph_position1d_cmd_vel {
  /** In m/s or rad/s. */
  float vel;
  /** 1: motor on, 0: off. */
  uint8_t state;
} ph_position1d_cmd_vel;
PH_CODEC(ph_position1d_cmd_vel)

/** Commanded position. (player_position1d_cmd_pos_t) */
typedef struct ph_position1d_cmd_pos {
  /** From its zero (in m or rad). */
  float pos;
  /** Velocity on the way; zero: chosen by the driver (in m/s or rad/s). */
  float vel;
  /** 1: motor on, 0: off. */
  uint8_t state;
} ph_position1d_cmd_pos;
PH_CODEC(ph_position1d_cmd_pos)

/** Size and pose. (player_position1d_geom_t) */
typedef struct ph_position1d_geom {
  /** Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the actuator (in m, m, m). */
  ph_common_bbox3d size;
} ph_position1d_geom;
PH_CODEC(ph_position1d_geom)

/** The motor's switch. (player_position1d_power_config_t) */
typedef struct ph_position1d_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_position1d_power_config;
PH_CODEC(ph_position1d_power_config)

/** A velocity controller. (player_position1d_velocity_mode_config_t) */
typedef struct ph_position1d_velocity_mode_config {
  /** Driver-specific. */
  uint32_t value;
} ph_position1d_velocity_mode_config;
PH_CODEC(ph_position1d_velocity_mode_config)

/** Request to set the current position to zero. (player_position1d_reset_odom_config_t) */
typedef struct ph_position1d_reset_odom_config {
  /** Without meaning. */
  uint32_t value;
} ph_position1d_reset_odom_config;
PH_CODEC(ph_position1d_reset_odom_config)

/** A control mode. (player_position1d_position_mode_req_t) */
typedef struct ph_position1d_position_mode_req {
  /** 0: velocity, 1: position. */
  uint32_t state;
} ph_position1d_position_mode_req;
PH_CODEC(ph_position1d_position_mode_req)

/** New value of the current position. (player_position1d_set_odom_req_t) */
typedef struct ph_position1d_set_odom_req {
  /** New value of the current position (in m or rad). */
  float pos;
} ph_position1d_set_odom_req;
PH_CODEC(ph_position1d_set_odom_req)

/** Gains of velocity control. (player_position1d_speed_pid_req_t) */
typedef struct ph_position1d_speed_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position1d_speed_pid_req;
PH_CODEC(ph_position1d_speed_pid_req)

/** Gains of position control. (player_position1d_position_pid_req_t) */
typedef struct ph_position1d_position_pid_req {
  /** Proportional. */
  float kp;
  /** Integral. */
  float ki;
  /** Derivative. */
  float kd;
} ph_position1d_position_pid_req;
PH_CODEC(ph_position1d_position_pid_req)

/** Limits of position control. (player_position1d_speed_prof_req_t) */
typedef struct ph_position1d_speed_prof_req {
  /** Maximum speed (in m/s or rad/s). */
  float speed;
  /** Maximum acceleration (in m/s^2 or rad/s^2). */
  float acc;
} ph_position1d_speed_prof_req;
PH_CODEC(ph_position1d_speed_prof_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_position1d_messages[13];
/** Position of the actuator. */
#define PH_POSITION1D_DATA_STATE (&ph_position1d_messages[0])
/** Size and pose, sent on change. */
#define PH_POSITION1D_DATA_GEOM (&ph_position1d_messages[1])
/** Commanded velocity. */
#define PH_POSITION1D_CMD_VEL (&ph_position1d_messages[2])
/** Commanded position. */
#define PH_POSITION1D_CMD_POS (&ph_position1d_messages[3])
/** Requests size and pose. */
#define PH_POSITION1D_REQ_GET_GEOM (&ph_position1d_messages[4])
/** Switches the motor on or off. */
#define PH_POSITION1D_REQ_MOTOR_POWER (&ph_position1d_messages[5])
/** Selects the driver's velocity controller. */
#define PH_POSITION1D_REQ_VELOCITY_MODE (&ph_position1d_messages[6])
/** Selects between velocity and position control. */
#define PH_POSITION1D_REQ_POSITION_MODE (&ph_position1d_messages[7])
/** Sets the reference of the position. */
#define PH_POSITION1D_REQ_SET_ODOM (&ph_position1d_messages[8])
/** Sets the current position to zero. */
#define PH_POSITION1D_REQ_RESET_ODOM (&ph_position1d_messages[9])
/** Sets the gains of velocity control. */
#define PH_POSITION1D_REQ_SPEED_PID (&ph_position1d_messages[10])
/** Sets the gains of position control. */
#define PH_POSITION1D_REQ_POSITION_PID (&ph_position1d_messages[11])
/** Sets the speed and acceleration limits of position control. */
#define PH_POSITION1D_REQ_SPEED_PROF (&ph_position1d_messages[12])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_POSITION1D_H */
