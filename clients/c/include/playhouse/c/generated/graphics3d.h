/** Interface graphics3d, code 58. Draws 3D shapes for display. Generated from
 * interfaces/058_graphics3d.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_GRAPHICS3D_H
#define PLAYHOUSE_C_GENERATED_GRAPHICS3D_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_GRAPHICS3D_CODE 58

/** Values of CmdDraw.draw_mode: primitives made from the points. */
enum {
  PH_GRAPHICS3D_DRAW_POINTS = 0,
  PH_GRAPHICS3D_DRAW_LINES = 1,
  PH_GRAPHICS3D_DRAW_LINE_STRIP = 2,
  PH_GRAPHICS3D_DRAW_LINE_LOOP = 3,
  PH_GRAPHICS3D_DRAW_TRIANGLES = 4,
  PH_GRAPHICS3D_DRAW_TRIANGLE_STRIP = 5,
  PH_GRAPHICS3D_DRAW_TRIANGLE_FAN = 6,
  PH_GRAPHICS3D_DRAW_QUADS = 7,
  PH_GRAPHICS3D_DRAW_QUAD_STRIP = 8,
  PH_GRAPHICS3D_DRAW_POLYGON = 9,
};

/** Points, lines or faces. (player_graphics3d_cmd_draw_t) */
typedef struct ph_graphics3d_cmd_draw {
  uint32_t draw_mode;
  /** In m, frame p_SP. */
  const ph_common_point3d *points;
  uint32_t points_count;
  ph_common_color color;
} ph_graphics3d_cmd_draw;
PH_CODEC(ph_graphics3d_cmd_draw)

/** A translation of the coordinate frame. (player_graphics3d_cmd_translate_t) */
typedef struct ph_graphics3d_cmd_translate {
  /** In m. */
  double x;
  /** In m. */
  double y;
  /** In m. */
  double z;
} ph_graphics3d_cmd_translate;
PH_CODEC(ph_graphics3d_cmd_translate)

/** A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t) */
typedef struct ph_graphics3d_cmd_rotate {
  /** Angle about the vector (x, y, z) (in rad). */
  double a;
  double x;
  double y;
  double z;
} ph_graphics3d_cmd_rotate;
PH_CODEC(ph_graphics3d_cmd_rotate)

/** The messages, each under its name below. */
extern const ph_message_type ph_graphics3d_messages[6];
/** Removes all drawn shapes. */
#define PH_GRAPHICS3D_CMD_CLEAR (&ph_graphics3d_messages[0])
/** Draws points, lines or faces. */
#define PH_GRAPHICS3D_CMD_DRAW (&ph_graphics3d_messages[1])
/** Translates the coordinate frame of subsequent drawing. */
#define PH_GRAPHICS3D_CMD_TRANSLATE (&ph_graphics3d_messages[2])
/** Rotates the coordinate frame of subsequent drawing. */
#define PH_GRAPHICS3D_CMD_ROTATE (&ph_graphics3d_messages[3])
/** Pushes the current coordinate frame. */
#define PH_GRAPHICS3D_CMD_PUSH (&ph_graphics3d_messages[4])
/** Pops the pushed coordinate frame. */
#define PH_GRAPHICS3D_CMD_POP (&ph_graphics3d_messages[5])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_GRAPHICS3D_H */
