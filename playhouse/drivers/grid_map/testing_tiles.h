#pragma once

/// Tiles of maps, for tests.

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

#include "playhouse/wire/generated/map.h"

namespace playhouse::drivers {

inline std::vector<std::int8_t> unpacked(const wire::map::Data& tile) {
  std::vector<std::int8_t> cells(tile.width * tile.height);
  uLongf size = cells.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(cells.data()), &size,
                       reinterpret_cast<const Bytef*>(tile.data.data()), tile.data.size()),
            Z_OK);
  EXPECT_EQ(size, cells.size());
  return cells;
}

}  // namespace playhouse::drivers
