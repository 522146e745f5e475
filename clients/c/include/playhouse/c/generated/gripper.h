/** Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a
 * store for objects. Generated from interfaces/003_gripper.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_GRIPPER_H
#define PLAYHOUSE_C_GENERATED_GRIPPER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_GRIPPER_CODE 3

/** Values of Data.state. */
enum {
  PH_GRIPPER_STATE_OPEN = 1,
  PH_GRIPPER_STATE_CLOSED = 2,
  PH_GRIPPER_STATE_MOVING = 3,
  PH_GRIPPER_STATE_ERROR = 4,
};

/** State of the fingers and of the break beams. (player_gripper_data_t) */
typedef struct ph_gripper_data {
  /** Open, closed, moving or faulty. */
  uint8_t state;
  /** One bit per break beam, set if it is interrupted. */
  uint32_t beams;
  /** Number of stored objects. */
  uint8_t stored;
} ph_gripper_data;
PH_CODEC(ph_gripper_data)

/** The gripper's size and pose. (player_gripper_geom_t) */
typedef struct ph_gripper_geom {
  /** Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** Around the fingers (in m, m, m). */
  ph_common_bbox3d outer_size;
  /** Of the gap between the open fingers (in m, m, m). */
  ph_common_bbox3d inner_size;
  /** Number of break beams. */
  uint8_t num_beams;
  /** Capacity of the store, in objects. */
  uint8_t capacity;
} ph_gripper_geom;
PH_CODEC(ph_gripper_geom)

/** The messages, each under its name below. */
extern const ph_message_type ph_gripper_messages[7];
/** State of the fingers and of the break beams. */
#define PH_GRIPPER_DATA_STATE (&ph_gripper_messages[0])
/** Opens the fingers. */
#define PH_GRIPPER_CMD_OPEN (&ph_gripper_messages[1])
/** Closes the fingers. */
#define PH_GRIPPER_CMD_CLOSE (&ph_gripper_messages[2])
/** Stops the fingers at their current position. */
#define PH_GRIPPER_CMD_STOP (&ph_gripper_messages[3])
/** Moves the held object into the store. */
#define PH_GRIPPER_CMD_STORE (&ph_gripper_messages[4])
/** Moves the object stored last between the fingers. */
#define PH_GRIPPER_CMD_RETRIEVE (&ph_gripper_messages[5])
/** Requests the gripper's size and pose. */
#define PH_GRIPPER_REQ_GET_GEOM (&ph_gripper_messages[6])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_GRIPPER_H */
