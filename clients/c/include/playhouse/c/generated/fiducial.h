/** Interface fiducial, code 10. Detects markers and reports their ids and poses. Generated from
 * interfaces/010_fiducial.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_FIDUCIAL_H
#define PLAYHOUSE_C_GENERATED_FIDUCIAL_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_FIDUCIAL_CODE 10

/** One marker in view. (player_fiducial_item_t) */
typedef struct ph_fiducial_item {
  /** Id of the marker; -1 if it cannot be identified, from simulated finders 0. */
  int32_t id;
  /** Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST). */
  ph_common_pose3d pose;
  /** Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad, frame
   * X_ST). */
  ph_common_pose3d upose;
} ph_fiducial_item;
PH_CODEC(ph_fiducial_item)

/** The markers in view. (player_fiducial_data_t) */
typedef struct ph_fiducial_data {
  const ph_fiducial_item *fiducials;
  uint32_t fiducials_count;
} ph_fiducial_data;
PH_CODEC(ph_fiducial_data)

/** Size and pose. (player_fiducial_geom_t) */
typedef struct ph_fiducial_geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the device (in m, m, m). */
  ph_common_bbox3d size;
  /** Of the markers; 0 if unknown (in m, m). */
  ph_common_bbox2d fiducial_size;
} ph_fiducial_geom;
PH_CODEC(ph_fiducial_geom)

/** Range and field of view. (player_fiducial_fov_t) */
typedef struct ph_fiducial_fov {
  /** In m. */
  float min_range;
  /** In m. */
  float max_range;
  /** From the first to the last direction (in rad). */
  float view_angle;
} ph_fiducial_fov;
PH_CODEC(ph_fiducial_fov)

/** A marker id. (player_fiducial_id_t) */
typedef struct ph_fiducial_id {
  uint32_t id;
} ph_fiducial_id;
PH_CODEC(ph_fiducial_id)

/** The messages, each under its name below. */
extern const ph_message_type ph_fiducial_messages[6];
/** The markers in view. */
#define PH_FIDUCIAL_DATA_SCAN (&ph_fiducial_messages[0])
/** Requests the device's size and pose and the markers' size. */
#define PH_FIDUCIAL_REQ_GET_GEOM (&ph_fiducial_messages[1])
/** Requests the range and the field of view. */
#define PH_FIDUCIAL_REQ_GET_FOV (&ph_fiducial_messages[2])
/** Sets the range and the field of view; the answer has the values in effect. */
#define PH_FIDUCIAL_REQ_SET_FOV (&ph_fiducial_messages[3])
/** Requests the robot's own marker id. */
#define PH_FIDUCIAL_REQ_GET_ID (&ph_fiducial_messages[4])
/** Sets the robot's own marker id. */
#define PH_FIDUCIAL_REQ_SET_ID (&ph_fiducial_messages[5])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_FIDUCIAL_H */
