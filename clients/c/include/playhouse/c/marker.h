#ifndef PLAYHOUSE_C_MARKER_H
#define PLAYHOUSE_C_MARKER_H

#include "playhouse/c/values.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A marker in view: its id, and its pose in the sensor's frame. */
typedef struct ph_marker {
  int32_t id;
  ph_pose3d pose;
} ph_marker;

/** In m, and in rad, counter-clockwise from the sensor's x axis. */
double ph_marker_distance(const ph_marker *marker);
double ph_marker_bearing(const ph_marker *marker);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_MARKER_H */
