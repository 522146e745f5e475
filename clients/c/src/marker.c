#include "playhouse/c/marker.h"

#include <math.h>

double ph_marker_distance(const ph_marker *marker) {
  return hypot(marker->pose.x, marker->pose.y);
}
double ph_marker_bearing(const ph_marker *marker) {
  return atan2(marker->pose.y, marker->pose.x);
}
