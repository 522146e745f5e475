/** Interface planner, code 44. Plans and follows a path to a goal. Generated from
 * interfaces/044_planner.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_PLANNER_H
#define PLAYHOUSE_C_GENERATED_PLANNER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_PLANNER_CODE 44

/** Progress of the robot along its path. (player_planner_data_t) */
typedef struct ph_planner_data {
  /** 1 if there is a path to the goal. */
  uint8_t valid;
  /** 1 if the goal is reached. */
  uint8_t done;
  /** The robot (in m, m, rad, frame X_MR). */
  ph_common_pose2d pos;
  /** The goal (in m, m, rad, frame X_MG). */
  ph_common_pose2d goal;
  /** Current waypoint of the robot (in m, m, rad, frame X_MP). */
  ph_common_pose2d waypoint;
  /** Index of that waypoint in the path; -1 if there is none. */
  int32_t waypoint_idx;
  /** Number of waypoints of the path. */
  uint32_t waypoints_count;
} ph_planner_data;
PH_CODEC(ph_planner_data)

/** A goal. (player_planner_cmd_t) */
typedef struct ph_planner_cmd {
  /** Goal pose (in m, m, rad, frame X_MG). */
  ph_common_pose2d goal;
} ph_planner_cmd;
PH_CODEC(ph_planner_cmd)

/** The planned path. (player_planner_waypoints_req_t) */
typedef struct ph_planner_waypoints_req {
  /** Length of the path (in m). */
  double waypoints_distance;
  /** From the robot to the goal (in m, m, rad, frame X_MP). */
  const ph_common_pose2d *waypoints;
  uint32_t waypoints_count;
} ph_planner_waypoints_req;
PH_CODEC(ph_planner_waypoints_req)

/** The planner's switch. (player_planner_enable_req_t) */
typedef struct ph_planner_enable_req {
  /** 1: may move, 0: stop. */
  uint8_t state;
} ph_planner_enable_req;
PH_CODEC(ph_planner_enable_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_planner_messages[5];
/** Progress of the robot along its path. */
#define PH_PLANNER_DATA_STATE (&ph_planner_messages[0])
/** Sets the goal. */
#define PH_PLANNER_CMD_GOAL (&ph_planner_messages[1])
/** Sets the goal and starts to move. */
#define PH_PLANNER_CMD_START (&ph_planner_messages[2])
/** Requests the planned path. */
#define PH_PLANNER_REQ_GET_WAYPOINTS (&ph_planner_messages[3])
/** Enables or stops the robot. */
#define PH_PLANNER_REQ_ENABLE (&ph_planner_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_PLANNER_H */
