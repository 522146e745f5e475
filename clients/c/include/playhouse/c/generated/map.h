/** Interface map, code 42. Grid and vector maps. Generated from interfaces/042_map.toml by codegen; do not
 * edit. */
#ifndef PLAYHOUSE_C_GENERATED_MAP_H
#define PLAYHOUSE_C_GENERATED_MAP_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_MAP_CODE 42

/** Size, scale and origin of the map. (player_map_info_t) */
typedef struct ph_map_info {
  /** Cell size (in m/pixel). */
  float scale;
  /** In px. */
  uint32_t width;
  /** In px. */
  uint32_t height;
  /** Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM). */
  ph_common_pose2d origin;
} ph_map_info;
PH_CODEC(ph_map_info)

/** A rectangle of cells. (player_map_data_t) */
typedef struct ph_map_data {
  /** First column, from the left (in px). */
  uint32_t col;
  /** First row, from the bottom (in px). */
  uint32_t row;
  /** In px. */
  uint32_t width;
  /** In px. */
  uint32_t height;
  /** Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown. */
  int8_t data_range;
  /** Rows, concatenated; compressed with zlib in an answer, empty in a request. */
  const int8_t *data;
  uint32_t data_count;
} ph_map_data;
PH_CODEC(ph_map_data)

/** The map as line segments, and its extent. (player_map_data_vector_t) */
typedef struct ph_map_data_vector {
  /** In m. */
  float minx;
  /** In m. */
  float maxx;
  /** In m. */
  float miny;
  /** In m. */
  float maxy;
  /** One per line (in m, frame p_MP). */
  const ph_common_segment *segments;
  uint32_t segments_count;
} ph_map_data_vector;
PH_CODEC(ph_map_data_vector)

/** The messages, each under its name below. */
extern const ph_message_type ph_map_messages[4];
/** Size and scale of the map, sent on change. */
#define PH_MAP_DATA_INFO (&ph_map_messages[0])
/** Requests the size and scale of the map. */
#define PH_MAP_REQ_GET_INFO (&ph_map_messages[1])
/** Requests a rectangle of cells; the answer's cells are compressed with zlib. */
#define PH_MAP_REQ_GET_DATA (&ph_map_messages[2])
/** Requests the map as lines. */
#define PH_MAP_REQ_GET_VECTOR (&ph_map_messages[3])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_MAP_H */
