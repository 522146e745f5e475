#ifndef PLAYHOUSE_C_BUMPER_H
#define PLAYHOUSE_C_BUMPER_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Contact switches. */
PH_PROXY(bumper)

/** The face of a bumper switch: pose of its centre on the robot (yaw: outward direction) and its length.
 * `radius` is its radius of curvature, 0 if it is straight. In m. */
typedef struct ph_face {
  ph_pose3d pose;
  double length;
  double radius;
} ph_face;

/** One per switch, in the order of ph_bumper_faces(): 0 if it is not pressed. */
ph_status ph_bumper_pressed(ph_bumper *bumper, const uint8_t **pressed, size_t *count, ph_error *error);
/** Faces of the switches on the robot. Valid until the next call for this device. */
ph_status ph_bumper_faces(ph_bumper *bumper, const ph_face **faces, size_t *count, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_BUMPER_H */
