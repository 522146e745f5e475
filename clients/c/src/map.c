#include "playhouse/c/map.h"

#include <math.h>
#include <stdlib.h>

#include "playhouse/c/generated/map.h"
#include "proxy.h"
#include "tile.h"

enum { MOST_CELLS = 1 << 26 };  // of a map

struct ph_map {
  ph_device device;
  void *cells;
};

static void release(ph_device *device) {
  free(((ph_map *)device)->cells);
}

const ph_class ph_map_class = {.interface_name = "map", .size = sizeof(ph_map), .release = release};
PH_DEFINE_PROXY(map)

bool ph_grid_cell_of(const ph_grid *grid, ph_point point, ph_cell *cell) {
  const double dx = point.x - grid->origin.x, dy = point.y - grid->origin.y;
  const double c = cos(grid->origin.a), s = sin(grid->origin.a);
  const double column = (c * dx + s * dy) / grid->cell_size, row = (c * dy - s * dx) / grid->cell_size;
  if (!(column >= 0.0 && column < grid->width && row >= 0.0 && row < grid->height)) return false;
  *cell = (ph_cell){(uint32_t)column, (uint32_t)row};
  return true;
}

ph_status ph_map_grid(ph_map *map, ph_grid *grid, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&map->device, PH_MAP_REQ_GET_INFO, NULL, &answer, error));
  const ph_map_info *info = answer->data;
  const ph_grid told = {(double)info->scale, info->width, info->height, ph_pose_of(info->origin)};
  ph_value_free(answer);
  const ph_pose *at = &told.origin;
  if (told.cell_size > 0.0 && isfinite(told.cell_size) && isfinite(at->x) && isfinite(at->y) &&
      isfinite(at->a)) {
    *grid = told;
    return PH_OK;
  }
  char size[PH_NUMBER_BYTES], x[PH_NUMBER_BYTES], y[PH_NUMBER_BYTES], a[PH_NUMBER_BYTES];
  return ph_fail(error, PH_WIRE_ERROR, "%s: invalid map: cells of %s m from (%s, %s, %s) on",
                 map->device.name, ph_number_text(told.cell_size, size), ph_number_text(at->x, x),
                 ph_number_text(at->y, y), ph_number_text(at->a, a));
}

/** What a byte of a map says: 1 and -1 beyond half of the range of values, else 0. */
static int8_t occupancy(uint8_t byte, int range) {
  const int limit = range > 1 ? range : 1, twice = 2 * (int8_t)byte;
  return (int8_t)((twice > limit) - (twice < -limit));
}

/** Fills the cells of a tile from `bytes`, which have room for one more than it has cells. */
static ph_status fill_tile(ph_map *map, const ph_grid *grid, const ph_map_data *asked, uint8_t *bytes,
                           ph_error *error) {
  const size_t count = (size_t)asked->width * asked->height;
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&map->device, PH_MAP_REQ_GET_DATA, asked, &answer, error));
  const ph_map_data *tile = answer->data;
  const int range = tile->data_range;
  const size_t size = ph_tile_uncompress(tile->data, tile->data_count, bytes, count);
  ph_value_free(answer);
  if (size != count) {
    return ph_fail(error, PH_WIRE_ERROR, "%s: a tile of %lu x %lu cells is damaged", map->device.name,
                   (unsigned long)asked->width, (unsigned long)asked->height);
  }
  int8_t *cells = map->cells;
  for (size_t i = 0; i < count; ++i) {
    const size_t row = asked->row + i / asked->width, column = asked->col + i % asked->width;
    cells[row * grid->width + column] = occupancy(bytes[i], range);
  }
  return PH_OK;
}

static ph_status fill(ph_map *map, const ph_grid *grid, uint8_t *bytes, ph_error *error) {
  for (uint32_t row = 0; row < grid->height; row += PH_TILE) {
    for (uint32_t column = 0; column < grid->width; column += PH_TILE) {
      const ph_map_data asked = {.col = column,
                                 .row = row,
                                 .width = ph_tile_part(grid->width, column),
                                 .height = ph_tile_part(grid->height, row)};
      PH_TRY(fill_tile(map, grid, &asked, bytes, error));
    }
  }
  return PH_OK;
}

ph_status ph_map_cells(ph_map *map, ph_cells *cells, ph_error *error) {
  ph_grid grid;
  PH_TRY(ph_map_grid(map, &grid, error));
  const uint64_t count = (uint64_t)grid.width * grid.height;
  if (count > MOST_CELLS) {
    return ph_fail(error, PH_WIRE_ERROR, "%s: %lu x %lu cells are over the limit of %d", map->device.name,
                   (unsigned long)grid.width, (unsigned long)grid.height, (int)MOST_CELLS);
  }
  uint8_t *bytes = malloc(PH_TILE * PH_TILE + 1);
  ph_status status =
      bytes != NULL && ph_list_new(&map->cells, count, 1) != NULL ? PH_OK : ph_fail_no_memory(error);
  if (status == PH_OK && count > 0) status = fill(map, &grid, bytes, error);
  free(bytes);
  if (status == PH_OK) *cells = (ph_cells){grid, map->cells};
  return status;
}
