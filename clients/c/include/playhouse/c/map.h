#ifndef PLAYHOUSE_C_MAP_H
#define PLAYHOUSE_C_MAP_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A grid map. */
PH_PROXY(map)

/** A cell of a map: its column from the left and its row from the bottom, from 0. */
typedef struct ph_cell {
  uint32_t column, row;
} ph_cell;

/** The grid of a map: length of a cell's side in m, width and height in cells, and the pose of the lower left
 * corner of cell (0, 0) in the world. */
typedef struct ph_grid {
  double cell_size;
  uint32_t width, height;
  ph_pose origin;
} ph_grid;

/** The cell with this point of the world (m); false beyond the map. */
bool ph_grid_cell_of(const ph_grid *grid, ph_point point, ph_cell *cell);

/** The cells of a map: cells[row * grid.width + column] is 1 if the cell is occupied, -1 if it is free, 0 if
 * that is unknown. */
typedef struct ph_cells {
  ph_grid grid;
  const int8_t *cells;
} ph_cells;

/** Size and place of the map, without its cells. PH_WIRE_ERROR if the numbers are those of no map. */
ph_status ph_map_grid(ph_map *map, ph_grid *grid, ph_error *error);
/** The whole map, row by row from the bottom. Valid until the next call for this device. PH_WIRE_ERROR for a
 * map of more than 2^26 cells, and for faulty answers. */
ph_status ph_map_cells(ph_map *map, ph_cells *cells, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_MAP_H */
