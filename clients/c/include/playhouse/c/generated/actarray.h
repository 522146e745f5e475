/** Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm. Generated from
 * interfaces/053_actarray.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_ACTARRAY_H
#define PLAYHOUSE_C_GENERATED_ACTARRAY_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_ACTARRAY_CODE 53

/** Values of Actuator.state. */
enum {
  PH_ACTARRAY_ACTSTATE_IDLE = 1,
  PH_ACTARRAY_ACTSTATE_MOVING = 2,
  PH_ACTARRAY_ACTSTATE_BRAKED = 4,
  PH_ACTARRAY_ACTSTATE_STALLED = 8,
};

/** Values of Actuatorgeom.type. */
enum {
  PH_ACTARRAY_TYPE_LINEAR = 1,
  PH_ACTARRAY_TYPE_ROTARY = 2,
};

/** State of one joint. (player_actarray_actuator_t) */
typedef struct ph_actarray_actuator {
  /** In m or rad. */
  float position;
  /** In m/s or rad/s. */
  float speed;
  /** In m/s^2 or rad/s^2. */
  float acceleration;
  /** Of its motor; -1 if unknown (in A). */
  float current;
  /** Idle, moving, braked or stalled. */
  uint8_t state;
} ph_actarray_actuator;
PH_CODEC(ph_actarray_actuator)

/** State of each joint. (player_actarray_data_t) */
typedef struct ph_actarray_data {
  const ph_actarray_actuator *actuators;
  uint32_t actuators_count;
  /** 1: motors on, 0: off. */
  uint8_t motor_state;
} ph_actarray_data;
PH_CODEC(ph_actarray_data)

/** Description of a joint. (player_actarray_actuatorgeom_t) */
typedef struct ph_actarray_actuatorgeom {
  /** Prismatic or revolute. */
  uint8_t type;
  /** To the next joint (in m). */
  float length;
  /** Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad, frame R_BJ). */
  ph_common_orientation3d orientation;
  /** Unit vector of the axis of translation or rotation (frame n_J). */
  ph_common_point3d axis;
  /** Lowest position (in m or rad). */
  float min;
  /** Centre position (in m or rad). */
  float centre;
  /** Highest position (in m or rad). */
  float max;
  /** Position after CMD HOME (in m or rad). */
  float home;
  /** Speed in position control (in m/s or rad/s). */
  float config_speed;
  /** 1 if it has brakes. */
  uint8_t hasbrakes;
} ph_actarray_actuatorgeom;
PH_CODEC(ph_actarray_actuatorgeom)

/** Joints and base pose of the chain. (player_actarray_geom_t) */
typedef struct ph_actarray_geom {
  const ph_actarray_actuatorgeom *actuators;
  uint32_t actuators_count;
  /** Position of the base of the chain on the robot (in m, frame p_RB). */
  ph_common_point3d base_pos;
  /** Orientation of the base of the chain on the robot (in rad, frame R_RB). */
  ph_common_orientation3d base_orientation;
} ph_actarray_geom;
PH_CODEC(ph_actarray_geom)

/** Commanded position of one joint. (player_actarray_position_cmd_t) */
typedef struct ph_actarray_position_cmd {
  /** Index of the joint, from 0. */
  int32_t joint;
  /** In m or rad. */
  float position;
} ph_actarray_position_cmd;
PH_CODEC(ph_actarray_position_cmd)

/** Commanded positions of all joints. (player_actarray_multi_position_cmd_t) */
typedef struct ph_actarray_multi_position_cmd {
  /** In m or rad. */
  const float *positions;
  uint32_t positions_count;
} ph_actarray_multi_position_cmd;
PH_CODEC(ph_actarray_multi_position_cmd)

/** Commanded speed of one joint. (player_actarray_speed_cmd_t) */
typedef struct ph_actarray_speed_cmd {
  /** Index of the joint, from 0. */
  int32_t joint;
  /** In m/s or rad/s. */
  float speed;
} ph_actarray_speed_cmd;
PH_CODEC(ph_actarray_speed_cmd)

/** Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t) */
typedef struct ph_actarray_multi_speed_cmd {
  /** In m/s or rad/s. */
  const float *speeds;
  uint32_t speeds_count;
} ph_actarray_multi_speed_cmd;
PH_CODEC(ph_actarray_multi_speed_cmd)

/** A joint to move to its home position. (player_actarray_home_cmd_t) */
typedef struct ph_actarray_home_cmd {
  /** Index of the joint; -1: all. */
  int32_t joint;
} ph_actarray_home_cmd;
PH_CODEC(ph_actarray_home_cmd)

/** Commanded current of one joint. (player_actarray_current_cmd_t) */
typedef struct ph_actarray_current_cmd {
  /** Index of the joint, from 0. */
  int32_t joint;
  /** In A. */
  float current;
} ph_actarray_current_cmd;
PH_CODEC(ph_actarray_current_cmd)

/** Commanded currents of all joints. (player_actarray_multi_current_cmd_t) */
typedef struct ph_actarray_multi_current_cmd {
  /** In A. */
  const float *currents;
  uint32_t currents_count;
} ph_actarray_multi_current_cmd;
PH_CODEC(ph_actarray_multi_current_cmd)

/** The motors' switch. (player_actarray_power_config_t) */
typedef struct ph_actarray_power_config {
  /** 1: on, 0: off. */
  uint8_t value;
} ph_actarray_power_config;
PH_CODEC(ph_actarray_power_config)

/** The brakes' switch. (player_actarray_brakes_config_t) */
typedef struct ph_actarray_brakes_config {
  /** 1: braked, 0: released. */
  uint8_t value;
} ph_actarray_brakes_config;
PH_CODEC(ph_actarray_brakes_config)

/** Speed of one joint. (player_actarray_speed_config_t) */
typedef struct ph_actarray_speed_config {
  /** Index of the joint; -1: all. */
  int32_t joint;
  /** In m/s or rad/s. */
  float speed;
} ph_actarray_speed_config;
PH_CODEC(ph_actarray_speed_config)

/** Acceleration of one joint. (player_actarray_accel_config_t) */
typedef struct ph_actarray_accel_config {
  /** Index of the joint; -1: all. */
  int32_t joint;
  /** In m/s^2 or rad/s^2. */
  float accel;
} ph_actarray_accel_config;
PH_CODEC(ph_actarray_accel_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_actarray_messages[13];
/** State of each joint. */
#define PH_ACTARRAY_DATA_STATE (&ph_actarray_messages[0])
/** Commanded position of one joint. */
#define PH_ACTARRAY_CMD_POS (&ph_actarray_messages[1])
/** Commanded positions of all joints. */
#define PH_ACTARRAY_CMD_MULTI_POS (&ph_actarray_messages[2])
/** Commanded speed of one joint. */
#define PH_ACTARRAY_CMD_SPEED (&ph_actarray_messages[3])
/** Commanded speeds of all joints. */
#define PH_ACTARRAY_CMD_MULTI_SPEED (&ph_actarray_messages[4])
/** Moves one joint, or all, to the home position. */
#define PH_ACTARRAY_CMD_HOME (&ph_actarray_messages[5])
/** Commanded current of one joint. */
#define PH_ACTARRAY_CMD_CURRENT (&ph_actarray_messages[6])
/** Commanded currents of all joints. */
#define PH_ACTARRAY_CMD_MULTI_CURRENT (&ph_actarray_messages[7])
/** Switches the motors on or off. */
#define PH_ACTARRAY_REQ_POWER (&ph_actarray_messages[8])
/** Sets or releases the brakes. */
#define PH_ACTARRAY_REQ_BRAKES (&ph_actarray_messages[9])
/** Requests the joints and the base pose of the chain. */
#define PH_ACTARRAY_REQ_GET_GEOM (&ph_actarray_messages[10])
/** Sets a joint's speed in position control. */
#define PH_ACTARRAY_REQ_SPEED (&ph_actarray_messages[11])
/** Sets a joint's acceleration in position control. */
#define PH_ACTARRAY_REQ_ACCEL (&ph_actarray_messages[12])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_ACTARRAY_H */
