/** Interface pointcloud3d, code 61. Points in space with colors. Generated from
 * interfaces/061_pointcloud3d.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_POINTCLOUD3D_H
#define PLAYHOUSE_C_GENERATED_POINTCLOUD3D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_POINTCLOUD3D_CODE 61

/** One point. (player_pointcloud3d_element_t) */
typedef struct ph_pointcloud3d_element {
  /** In m, frame p_SP. */
  ph_common_point3d point;
  ph_common_color color;
} ph_pointcloud3d_element;
PH_CODEC(ph_pointcloud3d_element)

/** One cloud. (player_pointcloud3d_data_t) */
typedef struct ph_pointcloud3d_data {
  const ph_pointcloud3d_element *points;
  uint32_t points_count;
} ph_pointcloud3d_data;
PH_CODEC(ph_pointcloud3d_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_pointcloud3d_messages[1];
/** One cloud. */
#define PH_POINTCLOUD3D_DATA_STATE (&ph_pointcloud3d_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_POINTCLOUD3D_H */
