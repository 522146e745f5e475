/** Drawing into the simulation's picture: graphics2d, graphics3d. */
#include "inside.h"

// --- graphics2d

PLAYERC_PROXY(graphics2d, PLAYER_GRAPHICS2D_CODE, NULL, PLAYERC_NO_LISTS)

int playerc_graphics2d_setcolor(playerc_graphics2d_t *device, player_color_t col) {
  device->color = col;
  return 0;
}

int playerc_graphics2d_draw_points(playerc_graphics2d_t *device, player_point_2d_t pts[], int count) {
  const player_graphics2d_cmd_points_t command = {(uint32_t)count, pts, device->color};
  return playerc_command(&device->info, PLAYER_GRAPHICS2D_CMD_POINTS, &command);
}

int playerc_graphics2d_draw_polyline(playerc_graphics2d_t *device, player_point_2d_t pts[], int count) {
  const player_graphics2d_cmd_polyline_t command = {(uint32_t)count, pts, device->color};
  return playerc_command(&device->info, PLAYER_GRAPHICS2D_CMD_POLYLINE, &command);
}

int playerc_graphics2d_draw_multiline(playerc_graphics2d_t *device, player_point_2d_t pts[], int count) {
  const player_graphics2d_cmd_multiline_t command = {(uint32_t)count, pts, device->color};
  return playerc_command(&device->info, PLAYER_GRAPHICS2D_CMD_MULTILINE, &command);
}

int playerc_graphics2d_draw_polygon(playerc_graphics2d_t *device, player_point_2d_t pts[], int count,
                                    int filled, player_color_t fill_color) {
  const player_graphics2d_cmd_polygon_t command = {(uint32_t)count, pts, device->color, fill_color,
                                                   (uint8_t)(filled != 0)};
  return playerc_command(&device->info, PLAYER_GRAPHICS2D_CMD_POLYGON, &command);
}

int playerc_graphics2d_clear(playerc_graphics2d_t *device) {
  return playerc_command(&device->info, PLAYER_GRAPHICS2D_CMD_CLEAR, NULL);
}

// --- graphics3d

PLAYERC_PROXY(graphics3d, PLAYER_GRAPHICS3D_CODE, NULL, PLAYERC_NO_LISTS)

int playerc_graphics3d_setcolor(playerc_graphics3d_t *device, player_color_t col) {
  device->color = col;
  return 0;
}

int playerc_graphics3d_draw(playerc_graphics3d_t *device, player_graphics3d_draw_mode_t mode,
                            player_point_3d_t pts[], int count) {
  const player_graphics3d_cmd_draw_t command = {mode, (uint32_t)count, pts, device->color};
  return playerc_command(&device->info, PLAYER_GRAPHICS3D_CMD_DRAW, &command);
}

int playerc_graphics3d_clear(playerc_graphics3d_t *device) {
  return playerc_command(&device->info, PLAYER_GRAPHICS3D_CMD_CLEAR, NULL);
}

int playerc_graphics3d_translate(playerc_graphics3d_t *device, double x, double y, double z) {
  const player_graphics3d_cmd_translate_t command = {x, y, z};
  return playerc_command(&device->info, PLAYER_GRAPHICS3D_CMD_TRANSLATE, &command);
}

int playerc_graphics3d_rotate(playerc_graphics3d_t *device, double a, double x, double y, double z) {
  const player_graphics3d_cmd_rotate_t command = {a, x, y, z};
  return playerc_command(&device->info, PLAYER_GRAPHICS3D_CMD_ROTATE, &command);
}
