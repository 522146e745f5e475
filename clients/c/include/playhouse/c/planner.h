#ifndef PLAYHOUSE_C_PLANNER_H
#define PLAYHOUSE_C_PLANNER_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront
 * cancels the goal when the last one closes it. */
PH_PROXY(planner)

/** The data of a planner, poses on the map: whether there is a path to the goal (`valid`), whether the goal
 * is reached
 * (`done`), the robot's pose, the goal, the waypoint that the robot drives to, its index in the path (-1 if
 * there is none) and the number of waypoints of the path. `time` is the server's, in s. */
typedef struct ph_planning {
  bool valid, done;
  ph_pose pose, goal, waypoint;
  int32_t index;
  uint32_t count;
  double time;
} ph_planning;

/** A planned path: its waypoints on the map, from the robot to the goal, and its length in m. */
typedef struct ph_path {
  const ph_pose *waypoints;
  size_t count;
  double length;
} ph_path;

ph_status ph_planner_state(ph_planner *planner, ph_planning *state, ph_error *error);
/** Whether the last data say that the goal of the last ph_planner_go_to() is reached; data of another goal do
 * not count. */
bool ph_planner_arrived(const ph_planner *planner);
/** Plans a path to a pose on the map and drives there; after ph_planner_stop(), once ph_planner_resume() is
 * called. */
ph_status ph_planner_go_to(ph_planner *planner, ph_pose pose, ph_error *error);
/** Stops the robot until ph_planner_resume(); the planner keeps its goal. */
ph_status ph_planner_stop(ph_planner *planner, ph_error *error);
ph_status ph_planner_resume(ph_planner *planner, ph_error *error);
/** The path as it was planned last; without waypoints if there is none. Valid until the next call for this
 * device. */
ph_status ph_planner_path(ph_planner *planner, ph_path *path, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_PLANNER_H */
