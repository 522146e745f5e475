/** Follows a marker and keeps a metre away from it.
 *      follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]
 *
 * Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any
 * number), seen by the fiducial finder FINDER (INDEX). */
#include <math.h>

#include "program.h"

static const double kDistance = 1.0;  // m
static const double kSpeed = 0.5;     // m/s
static const double kTurn = 1.0;      // rad/s

/** The nearest marker of the wanted number; NULL if none is in view. */
static const ph_marker *choose(const ph_marker *markers, size_t count, const int *wanted) {
  const ph_marker *nearest = NULL;
  for (size_t i = 0; i < count; ++i) {
    if (wanted != NULL && markers[i].id != *wanted) continue;
    if (nearest == NULL || ph_marker_distance(&markers[i]) < ph_marker_distance(nearest))
      nearest = &markers[i];
  }
  return nearest;
}

/** One control step; `lost_to_the_left` is kept from step to step. */
static ph_status step(ph_position2d *robot, const ph_marker *marker, bool *lost_to_the_left,
                      ph_error *error) {
  if (marker == NULL) {
    // Marker lost: search, turning first to the side where it was last seen.
    return ph_position2d_drive(robot, 0.0, *lost_to_the_left ? kTurn / 2 : -kTurn / 2, 0.0, error);
  }
  const double bearing = ph_marker_bearing(marker);
  *lost_to_the_left = bearing > 0.0;
  const double speed = clamp(ph_marker_distance(marker) - kDistance, -kSpeed, kSpeed);
  return ph_position2d_drive(robot, fabs(bearing) < 1.0 ? speed : 0.0, clamp(2.0 * bearing, -kTurn, kTurn),
                             0.0, error);
}

static ph_status follow(ph_client *client, const program *self, ph_error *error) {
  const int *wanted = self->more_count > 0 ? &self->more[0] : NULL;
  const int eye = self->more_count > 1 ? self->more[1] : self->index;
  ph_position2d *robot = ph_position2d_open(client, self->index, PH_ACCESS_ALL, error);
  if (robot == NULL) return error->status;
  ph_fiducial *finder = ph_fiducial_open(client, eye, PH_ACCESS_ALL, error);
  if (finder == NULL) return error->status;
  bool lost_to_the_left = true;
  ph_status status = PH_OK;
  while (status == PH_OK && next_data(ph_fiducial_device(finder), self, &status, error)) {
    const ph_marker *markers = NULL;
    size_t count = 0;
    status = ph_fiducial_markers(finder, &markers, &count, error);
    if (status == PH_OK) status = step(robot, choose(markers, count, wanted), &lost_to_the_left, error);
  }
  return status;
}

int main(int argc, char **argv) {
  return run(argc, argv, follow, "follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]");
}
