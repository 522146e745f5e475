/** Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
 *      navigate [HOST:PORT [INDEX [SECONDS]]]
 *
 * Planner INDEX (0), for at most SECONDS (0: until it is done). */
#include <stdio.h>

#include "program.h"

static const ph_pose kPlaces[] = {{6.0, 4.0, 1.5}, {-5.8, 5.0, 3.0}};  // m, m, rad

/** Returns when the robot is at a place, or the time is up. */
static ph_status go(ph_planner *planner, ph_pose place, const program *self, ph_error *error) {
  ph_status status = ph_planner_go_to(planner, place, error);
  while (status == PH_OK && next_data(ph_planner_device(planner), self, &status, error)) {
    if (!ph_planner_arrived(planner)) continue;
    ph_planning state;
    status = ph_planner_state(planner, &state, error);
    if (status == PH_OK) printf("arrived at (%.2f, %.2f) m\n", state.pose.x, state.pose.y);
    fflush(stdout);
    break;
  }
  return status;
}

static ph_status navigate(ph_client *client, const program *self, ph_error *error) {
  ph_planner *planner = ph_planner_open(client, self->index, PH_ACCESS_ALL, error);
  if (planner == NULL) return error->status;
  ph_status status = PH_OK;
  for (size_t i = 0; i < sizeof kPlaces / sizeof *kPlaces && status == PH_OK && !is_up(self); ++i) {
    status = go(planner, kPlaces[i], self, error);
  }
  return status;
}

int main(int argc, char **argv) {
  return run(argc, argv, navigate, "navigate [HOST:PORT [INDEX [SECONDS]]]");
}
