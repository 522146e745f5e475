/** Tiles of maps, in which they travel. */
#ifndef PLAYHOUSE_C_SRC_TILE_H
#define PLAYHOUSE_C_SRC_TILE_H

#include <stddef.h>
#include <stdint.h>

enum { PH_TILE = 512 }; /**< cells along a side, so that any map fits into messages */

/** The cells of a tile that begins at `from`, along one side of a map of `whole` cells. */
uint32_t ph_tile_part(uint32_t whole, uint32_t from);

/** The bytes of a tile, which are to be `count`, from its data: a stream of zlib, or the cells themselves as of a
 * server without it. `bytes` has room for one more. Returns how many there are, `count` + 1 if there are more. */
size_t ph_tile_uncompress(const void *data, size_t data_count, uint8_t *bytes, size_t count);

#endif /* PLAYHOUSE_C_SRC_TILE_H */
