#include "playhouse/c/planner.h"

#include <math.h>
#include <stdlib.h>

#include "playhouse/c/generated/planner.h"
#include "proxy.h"

static const double kTurn = 6.283185307179586;
static const double kSameHeading = 1e-6;  // rad

struct ph_planner {
  ph_device device;
  bool has_goal;
  ph_pose goal; /**< of the last ph_planner_go_to() */
  void *waypoints;
};

static void release(ph_device *device) {
  free(((ph_planner *)device)->waypoints);
}

const ph_class ph_planner_class = {
    .interface_name = "planner", .size = sizeof(ph_planner), .release = release};
PH_DEFINE_PROXY(planner)

ph_status ph_planner_state(ph_planner *planner, ph_planning *state, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&planner->device, PH_PLANNER_DATA_STATE, &value, error));
  const ph_planner_data *data = value->data;
  *state = (ph_planning){
      .valid = data->valid != 0,
      .done = data->done != 0,
      .pose = ph_pose_of(data->pos),
      .goal = ph_pose_of(data->goal),
      .waypoint = ph_pose_of(data->waypoint),
      .index = data->waypoint_idx,
      .count = data->waypoints_count,
      .time = value->timestamp,
  };
  return PH_OK;
}

/** Whether two poses are the same, whole turns aside, which drivers drop. */
static bool same(ph_pose one, ph_pose other) {
  return one.x == other.x && one.y == other.y && fabs(remainder(one.a - other.a, kTurn)) < kSameHeading;
}

bool ph_planner_arrived(const ph_planner *planner) {
  const ph_value *value = ph_device_latest(&planner->device, PH_PLANNER_DATA_STATE);
  if (value == NULL || !planner->has_goal) return false;
  const ph_planner_data *data = value->data;
  return data->done != 0 && same(ph_pose_of(data->goal), planner->goal);
}

ph_status ph_planner_go_to(ph_planner *planner, ph_pose pose, ph_error *error) {
  PH_TRY(ph_insist_on_pose(&planner->device, pose, error));
  planner->has_goal = true;
  planner->goal = pose;
  const ph_planner_cmd command = {ph_wire_pose(pose)};
  return ph_device_command(&planner->device, PH_PLANNER_CMD_GOAL, &command, error);
}

static ph_status enable(ph_planner *planner, uint8_t state, ph_error *error) {
  const ph_planner_enable_req body = {state};
  return ph_device_tell(&planner->device, PH_PLANNER_REQ_ENABLE, &body, error);
}

ph_status ph_planner_stop(ph_planner *planner, ph_error *error) {
  return enable(planner, 0, error);
}
ph_status ph_planner_resume(ph_planner *planner, ph_error *error) {
  return enable(planner, 1, error);
}

ph_status ph_planner_path(ph_planner *planner, ph_path *path, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&planner->device, PH_PLANNER_REQ_GET_WAYPOINTS, NULL, &answer, error));
  const ph_planner_waypoints_req *told = answer->data;
  ph_pose *made = ph_list_new(&planner->waypoints, told->waypoints_count, sizeof *made);
  for (uint32_t i = 0; made != NULL && i < told->waypoints_count; ++i)
    made[i] = ph_pose_of(told->waypoints[i]);
  if (made != NULL) *path = (ph_path){made, told->waypoints_count, told->waypoints_distance};
  ph_value_free(answer);
  return made != NULL ? PH_OK : ph_fail_no_memory(error);
}
