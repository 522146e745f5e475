#include "playhouse/drivers/grid_map/map_reader.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

using Body = std::optional<std::vector<std::byte>>;
using Cells = std::vector<std::int8_t>;

constexpr std::uint32_t kTile = 512;                          // cells along a side of a tile
constexpr std::uint64_t kMostCells = std::uint64_t{1} << 26;  // of a map

/// The cells of a tile; empty if they are not `count`. Servers without zlib send them as they are.
Cells unpacked(const Cells& data, std::size_t count) {
  Cells cells(count);
  uLongf size = count;
  const int result = uncompress(reinterpret_cast<Bytef*>(cells.data()), &size,
                                reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (result == Z_OK && size == count) return cells;
  return data.size() == count ? data : Cells();
}

std::int8_t occupancy(std::int8_t value, std::int8_t range) {
  const int twice = 2 * value, limit = std::max<int>(range, 1);
  return twice > limit ? std::int8_t{1} : twice < -limit ? std::int8_t{-1} : std::int8_t{0};
}

/// Error text; empty if the map can be read.
std::string fault_of(const wire::map::Info& info) {
  if (!(info.scale > 0 && std::isfinite(info.scale)))
    return fmt::format("its cell size of {} m is invalid: a finite number above 0 is valid", info.scale);
  if (!std::isfinite(info.origin.px) || !std::isfinite(info.origin.py) || !std::isfinite(info.origin.pa))
    return "its origin is not finite";
  if (info.width == 0 || info.height == 0) return "it has no cells";
  if (std::uint64_t{info.width} * info.height > kMostCells)
    return fmt::format("it has {} x {} cells; at most {} are possible", info.width, info.height, kMostCells);
  return {};
}

/// Keeps itself alive through the request that it waits for.
class Reading : public std::enable_shared_from_this<Reading> {
 public:
  Reading(device::DeviceClient& client, std::size_t device, std::function<void(Result<GridMap>)> read)
      : client_(client), device_(device), read_(std::move(read)) {}

  void begin() {
    client_.ask(device_, wire::map::kReqGetInfo, {},
                [self = shared_from_this()](const Body& body) { self->take_info(body); });
  }

 private:
  void take_info(const Body& body) {
    if (!body) return fail("it does not tell its size");
    const Result<wire::map::Info> info = wire::decode<wire::map::Info>(*body);
    if (!info) return fail("its size cannot be decoded");
    if (const std::string fault = fault_of(*info); !fault.empty()) return fail(fault);
    map_.info = *info;
    map_.cells.resize(std::size_t{info->width} * info->height);
    ask_for_tile();
  }

  void ask_for_tile() {
    asked_.width = std::min(kTile, map_.info.width - asked_.col);
    asked_.height = std::min(kTile, map_.info.height - asked_.row);
    client_.ask(device_, wire::map::kReqGetData, wire::encode(asked_),
                [self = shared_from_this()](const Body& body) { self->take_tile(body); });
  }

  void take_tile(const Body& body) {
    if (!body) return fail("it refuses a tile");
    const Result<wire::map::Data> tile = wire::decode<wire::map::Data>(*body);
    if (!tile) return fail("a tile cannot be decoded");
    const Cells cells = unpacked(tile->data, std::size_t{asked_.width} * asked_.height);
    if (cells.empty()) return fail("a tile has another size than asked for");
    for (std::uint32_t row = 0; row < asked_.height; ++row)
      for (std::uint32_t col = 0; col < asked_.width; ++col)
        map_.cells[std::size_t{asked_.row + row} * map_.info.width + asked_.col + col] =
            occupancy(cells[std::size_t{row} * asked_.width + col], tile->data_range);
    next();
  }

  void next() {
    asked_.col += asked_.width;
    if (asked_.col == map_.info.width) {
      asked_.col = 0;
      asked_.row += asked_.height;
    }
    if (asked_.row == map_.info.height) return read_(std::move(map_));
    ask_for_tile();
  }

  void fail(std::string why) { read_(Error{"", std::move(why)}); }

  device::DeviceClient& client_;
  const std::size_t device_;
  const std::function<void(Result<GridMap>)> read_;
  GridMap map_;
  wire::map::Data asked_;  // the tile in question
};

}  // namespace

void read_map(device::DeviceClient& client, std::size_t device, std::function<void(Result<GridMap>)> read) {
  std::make_shared<Reading>(client, device, std::move(read))->begin();
}

}  // namespace playhouse::drivers
