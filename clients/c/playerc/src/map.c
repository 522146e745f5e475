#include <string.h>

#include "inside.h"
#include "tile.h"

enum { MOST_CELLS = 1 << 26 };

static void release(playerc_map_t *device) {
  free(device->cells);
  free(device->segments);
}

PLAYERC_PROXY(map, PLAYER_MAP_CODE, NULL, release)

static int get_info(playerc_map_t *device) {
  player_map_info_t *info = NULL;
  const int result = playerc_ask(&device->info, PLAYER_MAP_REQ_GET_INFO, NULL, &info);
  if (result != 0) return result;
  const uint64_t count = (uint64_t)info->width * info->height;
  if (count <= MOST_CELLS) {
    device->resolution = (double)info->scale;
    device->width = (int)info->width;
    device->height = (int)info->height;
    device->origin[0] = info->origin.px;
    device->origin[1] = info->origin.py;
  }
  player_map_info_t_free(info);
  return count <= MOST_CELLS ? 0
                             : playerc_fail("a map of %llu cells is over the limit of %d",
                                            (unsigned long long)count, MOST_CELLS);
}

/** Fills the cells of a tile by way of `bytes`, which have room for one more than it has cells. */
static int fill_tile(playerc_map_t *device, const player_map_data_t *asked, uint8_t *bytes) {
  player_map_data_t *tile = NULL;
  const int result = playerc_ask(&device->info, PLAYER_MAP_REQ_GET_DATA, asked, &tile);
  if (result != 0) return result;
  const size_t count = (size_t)asked->width * asked->height;
  const size_t size = ph_tile_uncompress(tile->data, tile->data_count, bytes, count);
  device->data_range = tile->data_range;
  player_map_data_t_free(tile);
  if (size != count) return playerc_fail("a tile of %u x %u cells is damaged", asked->width, asked->height);
  for (uint32_t row = 0; row < asked->height; ++row) {
    char *to = device->cells + (size_t)(asked->row + row) * (size_t)device->width + asked->col;
    memcpy(to, bytes + (size_t)row * asked->width, asked->width);
  }
  return 0;
}

static int fill(playerc_map_t *device, uint8_t *bytes) {
  const uint32_t width = (uint32_t)device->width, height = (uint32_t)device->height;
  for (uint32_t row = 0; row < height; row += PH_TILE) {
    for (uint32_t column = 0; column < width; column += PH_TILE) {
      const player_map_data_t asked = {.col = column,
                                       .row = row,
                                       .width = ph_tile_part(width, column),
                                       .height = ph_tile_part(height, row)};
      const int result = fill_tile(device, &asked, bytes);
      if (result != 0) return result;
    }
  }
  return 0;
}

int playerc_map_get_map(playerc_map_t *device) {
  const int known = get_info(device);
  if (known != 0) return known;
  uint8_t *bytes = malloc(PH_TILE * PH_TILE + 1);
  const size_t count = (size_t)device->width * (size_t)device->height;
  int result = -1;
  if (bytes != NULL && playerc_room(&device->cells, count, 1)) {
    memset(device->cells, 0, count);
    result = fill(device, bytes);
  } else {
    playerc_fail_no_memory();
  }
  free(bytes);
  return result;
}

int playerc_map_get_vector(playerc_map_t *device) {
  player_map_data_vector_t *map = NULL;
  int result = playerc_ask(&device->info, PLAYER_MAP_REQ_GET_VECTOR, NULL, &map);
  if (result != 0) return result;
  if (playerc_keep(&device->segments, map->segments, map->segments_count, sizeof *map->segments)) {
    device->num_segments = (int)map->segments_count;
    device->vminx = (double)map->minx;
    device->vminy = (double)map->miny;
    device->vmaxx = (double)map->maxx;
    device->vmaxy = (double)map->maxy;
  } else {
    result = playerc_fail_no_memory();
  }
  player_map_data_vector_t_free(map);
  return result;
}
