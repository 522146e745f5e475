/** Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
 *      square [HOST:PORT [INDEX [SECONDS]]]
 *
 * Robot INDEX (0), for at most SECONDS (0: until it is done). */
#include <math.h>
#include <stdio.h>

#include "program.h"

static const double kReached = 0.03;  // m
static const double kAligned = 0.02;  // rad
static const double kSpeed = 0.4;  // m/s
static const double kTurn = 1.0;  // rad/s
/** In m. */
static const ph_point kCorners[] = {{1.5, 0.0}, {1.5, 1.5}, {0.0, 1.5}, {0.0, 0.0}};

enum { CORNERS = sizeof kCorners / sizeof *kCorners };

static double normalized(double angle) {
  return atan2(sin(angle), cos(angle));
}

static double turn_for(double aside) {
  return clamp(2.0 * aside, -kTurn, kTurn);
}

/** The same place in the frame of `origin`. */
static ph_pose seen_from(const ph_pose *origin, const ph_pose *pose) {
  const double dx = pose->x - origin->x, dy = pose->y - origin->y;
  const double c = cos(origin->a), s = sin(origin->a);
  return (ph_pose){c * dx + s * dy, c * dy - s * dx, normalized(pose->a - origin->a)};
}

/** The pose after the next data. False when the time is up, then `status` is PH_OK, or on an error. */
static bool next_pose(ph_position2d *robot, const program *self, ph_pose *pose, ph_status *status,
                      ph_error *error) {
  ph_state state;
  if (!next_data(ph_position2d_device(robot), self, status, error)) return false;
  *status = ph_position2d_state(robot, &state, error);
  if (*status == PH_OK) *pose = state.pose;
  return *status == PH_OK;
}

/** One control step towards a corner. */
static ph_status approach(ph_position2d *robot, const ph_pose *here, ph_point corner, bool *reached,
                          ph_error *error) {
  const double ahead = corner.x - here->x, left = corner.y - here->y;
  const double distance = hypot(ahead, left);
  *reached = distance < kReached;
  if (*reached) return ph_position2d_stop(robot, error);
  const double aside = normalized(atan2(left, ahead) - here->a);
  const double speed = fabs(aside) > 0.15 ? 0.0 : clamp(distance, 0.05, kSpeed);
  return ph_position2d_drive(robot, speed, turn_for(aside), 0.0, error);
}

static ph_status align(ph_position2d *robot, double heading, const program *self, ph_error *error) {
  ph_status status = PH_OK;
  ph_pose pose;
  while (status == PH_OK && next_pose(robot, self, &pose, &status, error)) {
    const double aside = normalized(heading - pose.a);
    if (fabs(aside) < kAligned) break;
    status = ph_position2d_drive(robot, 0.0, turn_for(aside), 0.0, error);
  }
  return status;
}

static ph_status square(ph_client *client, const program *self, ph_error *error) {
  ph_position2d *robot = ph_position2d_open(client, self->index, PH_ACCESS_ALL, error);
  if (robot == NULL) return error->status;
  ph_status status = PH_OK;
  ph_pose start, pose;
  if (!next_pose(robot, self, &start, &status, error)) return status;
  for (size_t i = 0; i < CORNERS && status == PH_OK;) {
    if (!next_pose(robot, self, &pose, &status, error)) return status;
    const ph_pose here = seen_from(&start, &pose);
    bool reached = false;
    status = approach(robot, &here, kCorners[i], &reached, error);
    if (reached) printf("corner %zu at (%.2f, %.2f) m\n", ++i, here.x, here.y);
  }
  return status == PH_OK ? align(robot, start.a, self, error) : status;
}

int main(int argc, char **argv) {
  return run(argc, argv, square, "square [HOST:PORT [INDEX [SECONDS]]]");
}
