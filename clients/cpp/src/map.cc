#include "playhouse_client/map.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include "convert.h"
#include "inflate.h"

namespace playhouse::client {

namespace map = wire::map;

namespace {

constexpr std::uint32_t kTile = 512;  // cells along a side of a tile, so that any map fits into messages
constexpr std::uint64_t kMostCells = std::uint64_t{1} << 26;  // of a map

std::string size_of(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + " x " + std::to_string(height) + " cells";
}

/// What a value of the wire says: 1 and -1 beyond half of `range`, else 0.
std::int8_t occupancy(std::int8_t value, std::int8_t range) {
  const int twice = 2 * value, limit = std::max<int>(range, 1);
  return twice > limit ? std::int8_t{1} : twice < -limit ? std::int8_t{-1} : std::int8_t{0};
}

/// The bytes of a tile; those that came if they are not a zlib stream, as of a server without it.
std::vector<std::int8_t> uncompressed(std::vector<std::int8_t> data, std::size_t count) {
  auto bytes = inflate(std::as_bytes(std::span(data)), count);
  if (!bytes) return data;
  std::vector<std::int8_t> values;
  for (const std::byte byte : *bytes) values.push_back(static_cast<std::int8_t>(byte));
  return values;
}

}  // namespace

std::optional<Cell> Grid::cell_of(const Point& point) const {
  const double dx = point.x - origin.x, dy = point.y - origin.y;
  const double c = std::cos(origin.a), s = std::sin(origin.a);
  const double column = (c * dx + s * dy) / cell_size, row = (c * dy - s * dx) / cell_size;
  if (!(0 <= column && column < width && 0 <= row && row < height)) return std::nullopt;
  return Cell{static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)};
}

Result<Map> Map::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, map::kCode, index, access);
  if (!device) return device.error();
  return Map(std::move(*device));
}

Result<Grid> Map::grid() {
  const auto answer = device_.request<map::Info>(map::kReqGetInfo);
  if (!answer) return answer.error();
  const Grid grid{answer->scale, answer->width, answer->height, pose(answer->origin)};
  const double numbers[] = {grid.cell_size, grid.origin.x, grid.origin.y, grid.origin.a};
  if (grid.cell_size > 0 && std::ranges::all_of(numbers, [](double each) { return std::isfinite(each); }))
    return grid;
  return Error{"", device_.name() + ": size and origin of its cells are those of no map"};
}

Result<Map::Rows> Map::cells() {
  const auto size = grid();
  if (!size) return size.error();
  const std::uint32_t width = size->width, height = size->height;
  if (std::uint64_t{width} * height > kMostCells)
    return Error{"", device_.name() + ": " + size_of(width, height) + " are over the limit of " +
                         std::to_string(kMostCells)};
  Rows rows;
  for (std::uint32_t row = 0; width > 0 && row < height; row += kTile) {
    auto some = band(row, width, std::min(kTile, height - row));
    if (!some) return some.error();
    std::ranges::move(*some, std::back_inserter(rows));
  }
  return rows;
}

Result<Map::Rows> Map::band(std::uint32_t row, std::uint32_t width, std::uint32_t height) {
  Rows rows(height);
  for (std::uint32_t column = 0; column < width; column += kTile) {
    const std::uint32_t part = std::min(kTile, width - column);
    const auto cells = tile({column, row, part, height, 0, {}});
    if (!cells) return cells.error();
    for (std::uint32_t i = 0; i < height; ++i) {
      const auto first = cells->begin() + std::ptrdiff_t{i} * part;
      rows[i].insert(rows[i].end(), first, first + part);
    }
  }
  return rows;
}

Result<std::vector<std::int8_t>> Map::tile(const map::Data& asked) {
  auto answer = device_.request<map::Data>(map::kReqGetData, asked);
  if (!answer) return answer.error();
  const std::size_t count = std::size_t{asked.width} * asked.height;
  std::vector<std::int8_t> cells = uncompressed(std::move(answer->data), count);
  if (cells.size() != count)
    return Error{"", device_.name() + ": a tile of " + size_of(asked.width, asked.height) + " is damaged"};
  for (std::int8_t& cell : cells) cell = occupancy(cell, answer->data_range);
  return cells;
}

}  // namespace playhouse::client
