#ifndef PLAYHOUSE_C_SONAR_H
#define PLAYHOUSE_C_SONAR_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A ring of sonars. */
PH_PROXY(sonar)

/** In m, one per sonar, in the order of ph_sonar_poses(). */
ph_status ph_sonar_ranges(ph_sonar *sonar, const float **ranges, size_t *count, ph_error *error);
/** Poses of the sonars on the robot. Valid until the next call for this device. */
ph_status ph_sonar_poses(ph_sonar *sonar, const ph_pose3d **poses, size_t *count, ph_error *error);
ph_status ph_sonar_set_power(ph_sonar *sonar, bool on, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_SONAR_H */
