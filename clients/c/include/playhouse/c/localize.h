#ifndef PLAYHOUSE_C_LOCALIZE_H
#define PLAYHOUSE_C_LOCALIZE_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Localization of a robot on a map. */
PH_PROXY(localize)

/** Covariance of a pose in the plane, of x, y (m) and a (rad): xx, yy, aa are the variances. */
typedef struct ph_covariance {
  double xx, yy, aa, xy, ya, xa;
} ph_covariance;

/** That of independent errors with these standard deviations, in m, m and rad. */
ph_covariance ph_covariance_of_deviations(double x, double y, double a);

/** A hypothesis about where the robot is: the mean pose on the map, its covariance, and its weight; the
 * weights of all sum to 1. */
typedef struct ph_hypothesis {
  ph_pose pose;
  ph_covariance covariance;
  double weight;
} ph_hypothesis;

/** A particle of the localization's filter: a possible pose of the robot on the map, and its weight. */
typedef struct ph_particle {
  ph_pose pose;
  double weight;
} ph_particle;

/** Where the robot may be, the most likely first. */
ph_status ph_localize_hypotheses(ph_localize *place, const ph_hypothesis **hypotheses, size_t *count,
                                 ph_error *error);
/** The pose on the map of the most likely hypothesis. PH_NO_DATA also if there is none. */
ph_status ph_localize_pose(ph_localize *place, ph_pose *pose, ph_error *error);
/** Sets the estimate of the pose on the map; the robot does not move. PH_REQUEST_REFUSED if the driver takes
 * none of this covariance. */
ph_status ph_localize_set_estimate(ph_localize *place, ph_pose pose, ph_covariance covariance,
                                   ph_error *error);
/** All particles of the filter; none before its first step. Valid until the next call for this device. */
ph_status ph_localize_particles(ph_localize *place, const ph_particle **particles, size_t *count,
                                ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_LOCALIZE_H */
