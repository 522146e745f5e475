/** Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose. Generated
 * from interfaces/025_localize.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_LOCALIZE_H
#define PLAYHOUSE_C_GENERATED_LOCALIZE_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_LOCALIZE_CODE 25

/** A hypothesis. (player_localize_hypoth_t) */
typedef struct ph_localize_hypoth {
  /** Mean of the hypothesis (in m, m, rad, frame X_MR). */
  ph_common_pose2d mean;
  /** Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad). */
  double cov[6];
  /** Weight; the weights sum to 1. */
  double alpha;
} ph_localize_hypoth;
PH_CODEC(ph_localize_hypoth)

/** The hypotheses. (player_localize_data_t) */
typedef struct ph_localize_data {
  /** Number of queued sensor readings. */
  uint32_t pending_count;
  /** Time of the last processed reading (in s). */
  double pending_time;
  const ph_localize_hypoth *hypoths;
  uint32_t hypoths_count;
} ph_localize_data;
PH_CODEC(ph_localize_data)

/** Pose of the robot. (player_localize_set_pose_t) */
typedef struct ph_localize_set_pose {
  /** Mean of the hypothesis (in m, m, rad, frame X_MR). */
  ph_common_pose2d mean;
  /** Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad). */
  double cov[6];
} ph_localize_set_pose;
PH_CODEC(ph_localize_set_pose)

/** One particle. (player_localize_particle_t) */
typedef struct ph_localize_particle {
  /** The particle's estimate of the robot's pose (in m, m, rad, frame X_MR). */
  ph_common_pose2d pose;
  /** Weight. */
  double alpha;
} ph_localize_particle;
PH_CODEC(ph_localize_particle)

/** The particles of the filter. (player_localize_get_particles_t) */
typedef struct ph_localize_get_particles {
  /** Of the most likely hypothesis (in m, m, rad, frame X_MR). */
  ph_common_pose2d mean;
  /** Of the most likely hypothesis (in m^2). */
  double variance;
  const ph_localize_particle *particles;
  uint32_t particles_count;
} ph_localize_get_particles;
PH_CODEC(ph_localize_get_particles)

/** The messages, each under its name below. */
extern const ph_message_type ph_localize_messages[3];
/** The hypotheses, the most likely first. */
#define PH_LOCALIZE_DATA_HYPOTHS (&ph_localize_messages[0])
/** Sets the robot's pose estimate. */
#define PH_LOCALIZE_REQ_SET_POSE (&ph_localize_messages[1])
/** Requests the particles of the driver's filter. */
#define PH_LOCALIZE_REQ_GET_PARTICLES (&ph_localize_messages[2])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_LOCALIZE_H */
