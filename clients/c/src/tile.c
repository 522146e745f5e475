#include "tile.h"

#include <string.h>
#include <zlib.h>

uint32_t ph_tile_part(uint32_t whole, uint32_t from) {
  return whole - from < PH_TILE ? whole - from : PH_TILE;
}

size_t ph_tile_uncompress(const void *data, size_t data_count, uint8_t *bytes, size_t count) {
  z_stream stream = {.next_in = (Bytef *)(uintptr_t)data,
                     .avail_in = (uInt)data_count,
                     .next_out = bytes,
                     .avail_out = (uInt)(count + 1)};
  if (inflateInit(&stream) != Z_OK) return 0;
  const int result = inflate(&stream, Z_SYNC_FLUSH);
  const size_t size = stream.total_out;
  inflateEnd(&stream);
  if (result != Z_DATA_ERROR && result != Z_NEED_DICT) return size;
  const size_t raw = data_count <= count ? data_count : count + 1;
  if (raw > 0) memcpy(bytes, data, raw);
  return raw;
}
