/** Interface limb, code 54. An arm controlled by the pose of its end effector. Generated from
 * interfaces/054_limb.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_LIMB_H
#define PLAYHOUSE_C_GENERATED_LIMB_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_LIMB_CODE 54

/** Values of Data.state. */
enum {
  PH_LIMB_STATE_IDLE = 1,
  PH_LIMB_STATE_BRAKED = 2,
  PH_LIMB_STATE_MOVING = 3,
  PH_LIMB_STATE_OOR = 4,
  PH_LIMB_STATE_COLL = 5,
};

/** Pose of the end effector. (player_limb_data_t) */
typedef struct ph_limb_data {
  /** In m, frame p_BE. */
  ph_common_point3d position;
  /** Approach direction, a unit vector (frame n_B). */
  ph_common_point3d approach;
  /** Unit vector across the end effector (frame n_B). */
  ph_common_point3d orientation;
  /** Idle, braked, moving, out of reach or in contact. */
  uint8_t state;
} ph_limb_data;
PH_CODEC(ph_limb_data)

/** Commanded pose of the end effector. (player_limb_setpose_cmd_t) */
typedef struct ph_limb_setpose_cmd {
  /** In m, frame p_BE. */
  ph_common_point3d position;
  /** Commanded approach direction, a unit vector (frame n_B). */
  ph_common_point3d approach;
  /** Unit vector across the end effector (frame n_B). */
  ph_common_point3d orientation;
} ph_limb_setpose_cmd;
PH_CODEC(ph_limb_setpose_cmd)

/** Commanded position of the end effector. (player_limb_setposition_cmd_t) */
typedef struct ph_limb_setposition_cmd {
  /** In m, frame p_BE. */
  ph_common_point3d position;
} ph_limb_setposition_cmd;
PH_CODEC(ph_limb_setposition_cmd)

/** A straight motion of the end effector. (player_limb_vecmove_cmd_t) */
typedef struct ph_limb_vecmove_cmd {
  /** Unit vector of the motion (frame n_B). */
  ph_common_point3d direction;
  /** Distance (in m). */
  float length;
} ph_limb_vecmove_cmd;
PH_CODEC(ph_limb_vecmove_cmd)

/** The motors' switch. (player_limb_power_req_t) */
typedef struct ph_limb_power_req {
  /** 1: on, 0: off. */
  uint8_t value;
} ph_limb_power_req;
PH_CODEC(ph_limb_power_req)

/** The brakes' switch. (player_limb_brakes_req_t) */
typedef struct ph_limb_brakes_req {
  /** 1: braked, 0: released. */
  uint8_t value;
} ph_limb_brakes_req;
PH_CODEC(ph_limb_brakes_req)

/** Pose of the arm's base. (player_limb_geom_req_t) */
typedef struct ph_limb_geom_req {
  /** Of the arm's base on the robot (in m, frame p_RB). */
  ph_common_point3d basePos;
} ph_limb_geom_req;
PH_CODEC(ph_limb_geom_req)

/** Speed of the end effector. (player_limb_speed_req_t) */
typedef struct ph_limb_speed_req {
  /** Maximum speed of the end effector (in m/s). */
  float speed;
} ph_limb_speed_req;
PH_CODEC(ph_limb_speed_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_limb_messages[10];
/** Pose of the end effector. */
#define PH_LIMB_DATA_STATE (&ph_limb_messages[0])
/** Moves the arm to its home position. */
#define PH_LIMB_CMD_HOME (&ph_limb_messages[1])
/** Stops the arm at its current position. */
#define PH_LIMB_CMD_STOP (&ph_limb_messages[2])
/** Moves the end effector to a pose. */
#define PH_LIMB_CMD_SETPOSE (&ph_limb_messages[3])
/** Moves the end effector to a position, in any orientation. */
#define PH_LIMB_CMD_SETPOSITION (&ph_limb_messages[4])
/** Moves the end effector along a line from its current position. */
#define PH_LIMB_CMD_VECMOVE (&ph_limb_messages[5])
/** Switches the motors on or off. */
#define PH_LIMB_REQ_POWER (&ph_limb_messages[6])
/** Sets or releases the brakes. */
#define PH_LIMB_REQ_BRAKES (&ph_limb_messages[7])
/** Requests the pose of the arm's base on the robot. */
#define PH_LIMB_REQ_GEOM (&ph_limb_messages[8])
/** Sets the speed of the end effector. */
#define PH_LIMB_REQ_SPEED (&ph_limb_messages[9])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_LIMB_H */
