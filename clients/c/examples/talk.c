/** Tells the other robots by radio where it is, twice a second, and prints what it hears of them.
 *      talk [HOST:PORT [INDEX [SECONDS]]]
 *
 * Robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C). Start it once for each robot that is to
 * talk: it only looks at the robot, and whoever drives it goes on. */
#include <stdio.h>
#include <string.h>

#include "program.h"

static const double kPeriod = 0.5;  // s, simulated

static void print_messages(ph_opaque *radio, double time) {
  const uint8_t *bytes = NULL;
  size_t size = 0;
  while (ph_opaque_take_message(radio, &bytes, &size)) {
    printf("%.1f s: ", time);
    fwrite(bytes, 1, size, stdout);
    putchar('\n');
    fflush(stdout);
  }
}

static ph_status tell(ph_opaque *radio, int index, const ph_pose *pose, ph_error *error) {
  char text[100];
  snprintf(text, sizeof text, "robot %d is at %.2f %.2f", index, pose->x, pose->y);
  return ph_opaque_send(radio, text, strlen(text), error);
}

static ph_status talk(ph_client *client, const program *self, ph_error *error) {
  ph_position2d *robot = ph_position2d_open(client, self->index, PH_ACCESS_READ, error);
  if (robot == NULL) return error->status;
  ph_opaque *radio = ph_opaque_open(client, self->index, PH_ACCESS_ALL, error);
  if (radio == NULL) return error->status;
  double next_time = 0.0;
  ph_status status = PH_OK;
  while (status == PH_OK && next_data(ph_position2d_device(robot), self, &status, error)) {
    ph_state state;
    status = ph_position2d_state(robot, &state, error);
    if (status != PH_OK) break;
    print_messages(radio, state.time);
    if (state.time < next_time) continue;
    status = tell(radio, self->index, &state.pose, error);
    next_time = state.time + kPeriod;
  }
  return status;
}

int main(int argc, char **argv) {
  return run(argc, argv, talk, "talk [HOST:PORT [INDEX [SECONDS]]]");
}
