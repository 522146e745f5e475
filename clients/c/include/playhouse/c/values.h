/** The values of the proxies. Poses are in m and rad; a frame is documented where a pose is returned. */
#ifndef PLAYHOUSE_C_VALUES_H
#define PLAYHOUSE_C_VALUES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A pose in the plane: x, y (m) and heading a (rad, counter-clockwise, 0 along the frame's x, in (-pi, pi]
 * as servers report it). */
typedef struct ph_pose {
  double x, y, a;
} ph_pose;

/** A pose in space: x, y, z (m), then rotations about z by yaw, then about the new y by pitch, then about the
 * new x by roll (rad). */
typedef struct ph_pose3d {
  double x, y, z, roll, pitch, yaw;
} ph_pose3d;

/** x and y in m/s, a in rad/s, in the robot's frame. */
typedef struct ph_velocity {
  double x, y, a;
} ph_velocity;

/** A point in the plane, in m. */
typedef struct ph_point {
  double x, y;
} ph_point;

/** Extents in m along x (length), y (width) and z (height). */
typedef struct ph_size {
  double x, y, z;
} ph_size;

/** Pose of a device on its robot (for a base: its own centre), and its size. */
typedef struct ph_geometry {
  ph_pose3d pose;
  ph_size size;
} ph_geometry;

/** Ranges in m and their directions in rad, pairwise, in the order of measurement. Directions are
 * counter-clockwise from the sensor's x axis. `time` is the server's, in s. The lists belong to the device:
 * see playhouse/c/proxy.h. */
typedef struct ph_scan {
  const double *ranges;
  const double *angles;
  size_t count;
  double max_range;
  double time;
} ph_scan;

/** The minimum range between two directions; max_range if no beam is there. */
double ph_scan_nearest(const ph_scan *scan, double low, double high);
/** The end point of a beam, from 0 to count - 1, in the sensor's frame. */
ph_point ph_scan_point(const ph_scan *scan, size_t beam);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_VALUES_H */
