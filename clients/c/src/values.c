#include "playhouse/c/values.h"

#include <math.h>

double ph_scan_nearest(const ph_scan *scan, double low, double high) {
  double nearest = scan->max_range;
  bool any = false;
  for (size_t i = 0; i < scan->count; ++i) {
    if (scan->angles[i] < low || scan->angles[i] > high) continue;
    if (!any || scan->ranges[i] < nearest) nearest = scan->ranges[i];
    any = true;
  }
  return nearest;
}

ph_point ph_scan_point(const ph_scan *scan, size_t beam) {
  const double range = scan->ranges[beam], angle = scan->angles[beam];
  return (ph_point){range * cos(angle), range * sin(angle)};
}
