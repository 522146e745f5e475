/** Wanders about by laser and runs into nothing.
 *      wander [HOST:PORT [INDEX [SECONDS]]]
 *
 * Robot and laser INDEX (0), for SECONDS (0: until Ctrl-C). */
#include <math.h>

#include "program.h"

static const double kSpeed = 0.4;  // m/s
static const double kTurn = 0.8;   // rad/s
static const double kFront = 0.5;  // rad to either side that the robot needs to pass
static const double kNear = 0.6;   // m

/** One control step; `turning` is kept from step to step. */
static ph_status step(ph_position2d *robot, const ph_scan *scan, double *turning, ph_error *error) {
  const double ahead = ph_scan_nearest(scan, -kFront, kFront);
  const double left = ph_scan_nearest(scan, kFront, 1.5), right = ph_scan_nearest(scan, -1.5, -kFront);
  if (ahead < kNear) {
    if (*turning == 0.0) *turning = left > right ? kTurn : -kTurn;  // latched until the way ahead is clear
    return ph_position2d_drive(robot, 0.0, *turning, 0.0, error);
  }
  *turning = 0.0;
  const double sway = fmin(left, right) < kNear ? 0.5 * (left - right) : 0.0;
  return ph_position2d_drive(robot, fmin(kSpeed, ahead - kNear + 0.1), clamp(sway, -kTurn, kTurn), 0.0,
                             error);
}

static ph_status wander(ph_client *client, const program *self, ph_error *error) {
  ph_position2d *robot = ph_position2d_open(client, self->index, PH_ACCESS_ALL, error);
  if (robot == NULL) return error->status;
  ph_laser *laser = ph_laser_open(client, self->index, PH_ACCESS_ALL, error);
  if (laser == NULL) return error->status;
  double turning = 0.0;
  ph_status status = PH_OK;
  while (status == PH_OK && next_data(ph_laser_device(laser), self, &status, error)) {
    ph_scan scan;
    status = ph_laser_scan(laser, &scan, error);
    if (status == PH_OK) status = step(robot, &scan, &turning, error);
  }
  return status;
}

int main(int argc, char **argv) {
  return run(argc, argv, wander, "wander [HOST:PORT [INDEX [SECONDS]]]");
}
