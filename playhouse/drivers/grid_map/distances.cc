#include "playhouse/drivers/grid_map/distances.h"

#include <algorithm>
#include <cstddef>

namespace playhouse::drivers {
namespace {

constexpr std::uint32_t kFarSide = 65535;  // cells; distances along one axis are cut there

/// Along each column: the distance of the nearest obstacle in it.
std::vector<std::uint32_t> along_columns(std::size_t width, std::size_t height,
                                         const std::vector<std::uint8_t>& obstacles) {
  std::vector<std::uint32_t> distances(obstacles.size(), kFarSide);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (obstacles[i] != 0) {
      distances[i] = 0;
    } else if (i >= width) {
      distances[i] = std::min(distances[i - width] + 1, kFarSide);
    }
  }
  for (std::size_t i = width * (height - 1); i-- > 0;)
    distances[i] = std::min(distances[i], distances[i + width] + 1);
  return distances;
}

/// A parabola of the lower envelope of a row: that of column `apex` is the lowest from column `from` on.
struct Piece {
  std::int64_t apex = 0, from = 0;
};

/// Replaces a row of distances along columns by squared distances.
void along_row(std::uint32_t* row, std::int64_t width, std::vector<Piece>& pieces,
               std::vector<std::int64_t>& height) {
  for (std::int64_t x = 0; x < width; ++x)
    height[static_cast<std::size_t>(x)] = static_cast<std::int64_t>(row[x]) * row[x];
  const auto at = [&](std::int64_t x, std::int64_t apex) {
    return (x - apex) * (x - apex) + height[static_cast<std::size_t>(apex)];
  };
  pieces.clear();
  for (std::int64_t x = 0; x < width; ++x) {
    while (!pieces.empty() && at(pieces.back().from, pieces.back().apex) > at(pieces.back().from, x))
      pieces.pop_back();
    if (pieces.empty()) {
      pieces.push_back({x, 0});
      continue;
    }
    // The first column where the parabola of x is the lower one.
    const std::int64_t apex = pieces.back().apex;
    const std::int64_t numerator =
        x * x - apex * apex + height[static_cast<std::size_t>(x)] - height[static_cast<std::size_t>(apex)];
    const std::int64_t from = numerator / (2 * (x - apex)) + 1;
    if (from < width) pieces.push_back({x, from});
  }
  for (std::int64_t x = width; x-- > 0;) {
    while (pieces.back().from > x) pieces.pop_back();
    row[x] = static_cast<std::uint32_t>(std::min<std::int64_t>(at(x, pieces.back().apex), kFarAway));
  }
}

}  // namespace

std::vector<std::uint32_t> squared_distances(int width, int height,
                                             const std::vector<std::uint8_t>& obstacles) {
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  std::vector<std::uint32_t> distances = along_columns(columns, rows, obstacles);
  std::vector<Piece> pieces;
  std::vector<std::int64_t> scratch(columns);
  for (std::size_t row = 0; row < rows; ++row)
    along_row(distances.data() + row * columns, width, pieces, scratch);
  return distances;
}

}  // namespace playhouse::drivers
