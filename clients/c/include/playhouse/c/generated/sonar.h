/** Interface sonar, code 5. An array of sonars. New drivers use the ranger interface. Generated from
 * interfaces/005_sonar.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_SONAR_H
#define PLAYHOUSE_C_GENERATED_SONAR_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_SONAR_CODE 5

/** One range per sonar. (player_sonar_data_t) */
typedef struct ph_sonar_data {
  /** Range of the nearest echo, in the order of the geometry (in m). */
  const float *ranges;
  uint32_t ranges_count;
} ph_sonar_data;
PH_CODEC(ph_sonar_data)

/** Poses of the sonars. (player_sonar_geom_t) */
typedef struct ph_sonar_geom {
  /** One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS). */
  const ph_common_pose3d *poses;
  uint32_t poses_count;
} ph_sonar_geom;
PH_CODEC(ph_sonar_geom)

/** The sonars' switch. (player_sonar_power_config_t) */
typedef struct ph_sonar_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_sonar_power_config;
PH_CODEC(ph_sonar_power_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_sonar_messages[4];
/** One range per sonar. */
#define PH_SONAR_DATA_RANGES (&ph_sonar_messages[0])
/** Poses of the sonars, sent on change. */
#define PH_SONAR_DATA_GEOM (&ph_sonar_messages[1])
/** Requests the poses of the sonars. */
#define PH_SONAR_REQ_GET_GEOM (&ph_sonar_messages[2])
/** Switches the sonars on or off. */
#define PH_SONAR_REQ_POWER (&ph_sonar_messages[3])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_SONAR_H */
