/** Interface bumper, code 14. Contact switches. Generated from interfaces/014_bumper.toml by codegen; do
 * not edit. */
#ifndef PLAYHOUSE_C_GENERATED_BUMPER_H
#define PLAYHOUSE_C_GENERATED_BUMPER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_BUMPER_CODE 14

/** Which bumpers are pressed. (player_bumper_data_t) */
typedef struct ph_bumper_data {
  /** One per bumper: 0 free, else pressed. */
  const uint8_t *bumpers;
  uint32_t bumpers_count;
} ph_bumper_data;
PH_CODEC(ph_bumper_data)

/** One bumper. (player_bumper_define_t) */
typedef struct ph_bumper_define {
  /** Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** In m. */
  float length;
  /** Radius of curvature; 0 if it is straight (in m). */
  float radius;
} ph_bumper_define;
PH_CODEC(ph_bumper_define)

/** Poses of the bumpers. (player_bumper_geom_t) */
typedef struct ph_bumper_geom {
  const ph_bumper_define *bumper_def;
  uint32_t bumper_def_count;
} ph_bumper_geom;
PH_CODEC(ph_bumper_geom)

/** The messages, each under its name below. */
extern const ph_message_type ph_bumper_messages[3];
/** Which bumpers are pressed. */
#define PH_BUMPER_DATA_STATE (&ph_bumper_messages[0])
/** Poses of the bumpers, sent on change. */
#define PH_BUMPER_DATA_GEOM (&ph_bumper_messages[1])
/** Requests the poses of the bumpers. */
#define PH_BUMPER_REQ_GET_GEOM (&ph_bumper_messages[2])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_BUMPER_H */
