/** Interface graphics2d, code 55. Draws 2D shapes for display. Generated from
 * interfaces/055_graphics2d.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_GRAPHICS2D_H
#define PLAYHOUSE_C_GENERATED_GRAPHICS2D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_GRAPHICS2D_CODE 55

/** Points. (player_graphics2d_cmd_points_t) */
typedef struct ph_graphics2d_cmd_points {
  /** In m, frame p_SP. */
  const ph_common_point2d *points;
  uint32_t points_count;
  ph_common_color color;
} ph_graphics2d_cmd_points;
PH_CODEC(ph_graphics2d_cmd_points)

/** A line through points. (player_graphics2d_cmd_polyline_t) */
typedef struct ph_graphics2d_cmd_polyline {
  /** In m, frame p_SP. */
  const ph_common_point2d *points;
  uint32_t points_count;
  ph_common_color color;
} ph_graphics2d_cmd_polyline;
PH_CODEC(ph_graphics2d_cmd_polyline)

/** A polygon. (player_graphics2d_cmd_polygon_t) */
typedef struct ph_graphics2d_cmd_polygon {
  /** Vertices (in m, frame p_SP). */
  const ph_common_point2d *points;
  uint32_t points_count;
  /** Outline color. */
  ph_common_color color;
  /** Fill color. */
  ph_common_color fill_color;
  /** 1: filled. */
  uint8_t filled;
} ph_graphics2d_cmd_polygon;
PH_CODEC(ph_graphics2d_cmd_polygon)

/** Lines, each between two points. (player_graphics2d_cmd_multiline_t) */
typedef struct ph_graphics2d_cmd_multiline {
  /** Start and end of each line, alternating (in m, frame p_SP). */
  const ph_common_point2d *points;
  uint32_t points_count;
  ph_common_color color;
} ph_graphics2d_cmd_multiline;
PH_CODEC(ph_graphics2d_cmd_multiline)

/** The messages, each under its name below. */
extern const ph_message_type ph_graphics2d_messages[5];
/** Removes all drawn shapes. */
#define PH_GRAPHICS2D_CMD_CLEAR (&ph_graphics2d_messages[0])
/** Draws points. */
#define PH_GRAPHICS2D_CMD_POINTS (&ph_graphics2d_messages[1])
/** Draws a line through points. */
#define PH_GRAPHICS2D_CMD_POLYLINE (&ph_graphics2d_messages[2])
/** Draws a polygon. */
#define PH_GRAPHICS2D_CMD_POLYGON (&ph_graphics2d_messages[3])
/** Draws a line for each pair of points. */
#define PH_GRAPHICS2D_CMD_MULTILINE (&ph_graphics2d_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_GRAPHICS2D_H */
