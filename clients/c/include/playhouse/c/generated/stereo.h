/** Interface stereo, code 65. A pair of cameras, their disparity and the points in space. Generated from
 * interfaces/065_stereo.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_STEREO_H
#define PLAYHOUSE_C_GENERATED_STEREO_H

#include "playhouse/c/generated/camera.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_STEREO_CODE 65

/** One point. (player_pointcloud3d_stereo_element_t) */
typedef struct ph_stereo_pointcloud3d_stereo_element {
  /** In m, frame p_SP. */
  float px;
  /** In m, frame p_SP. */
  float py;
  /** In m, frame p_SP. */
  float pz;
  uint8_t red;
  uint8_t green;
  uint8_t blue;
} ph_stereo_pointcloud3d_stereo_element;
PH_CODEC(ph_stereo_pointcloud3d_stereo_element)

/** A pair of images, and the results computed from it. (player_stereo_data_t) */
typedef struct ph_stereo_data {
  /** Image of the left camera. */
  ph_camera_data left_channel;
  /** Image of the right camera. */
  ph_camera_data right_channel;
  /** Disparity, as an image. */
  ph_camera_data disparity;
  /** Points in space. */
  const ph_stereo_pointcloud3d_stereo_element *points;
  uint32_t points_count;
  /** Driver-specific. */
  uint32_t mode;
} ph_stereo_data;
PH_CODEC(ph_stereo_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_stereo_messages[1];
/** A pair of images, and the results computed from it. */
#define PH_STEREO_DATA_STATE (&ph_stereo_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_STEREO_H */
