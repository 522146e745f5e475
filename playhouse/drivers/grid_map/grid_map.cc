#include "playhouse/drivers/grid_map/grid_map.h"

#if !defined(PLAYHOUSE_WITHOUT_ZLIB)
#include <zlib.h>
#endif

#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

#if defined(PLAYHOUSE_WITHOUT_ZLIB)
/// Clients expect zlib's format.
std::optional<std::vector<std::int8_t>> compressed(const std::vector<std::int8_t>&) {
  return std::nullopt;
}
#else
std::optional<std::vector<std::int8_t>> compressed(const std::vector<std::int8_t>& cells) {
  uLongf size = compressBound(cells.size());
  std::vector<std::int8_t> out(size);
  const int result = compress(reinterpret_cast<Bytef*>(out.data()), &size,
                              reinterpret_cast<const Bytef*>(cells.data()), cells.size());
  out.resize(result == Z_OK ? size : 0);
  return out;
}
#endif

}  // namespace

std::optional<wire::map::Data> map_tile(const GridMap& map, const wire::map::Data& request) {
  const std::uint64_t count = std::uint64_t{request.width} * request.height;
  if (count > limits::kBodyBytes) return std::nullopt;
  const std::uint32_t width = map.info.width, height = map.info.height;
  std::vector<std::int8_t> tile;
  tile.reserve(count);
  for (std::uint64_t row = request.row; row < std::uint64_t{request.row} + request.height; ++row)
    for (std::uint64_t col = request.col; col < std::uint64_t{request.col} + request.width; ++col)
      tile.push_back(row < height && col < width ? map.cells[row * width + col] : std::int8_t{0});
  std::optional<std::vector<std::int8_t>> bytes = compressed(tile);
  if (!bytes) return std::nullopt;
  return wire::map::Data{request.col, request.row, request.width, request.height, 1, std::move(*bytes)};
}

std::optional<wire::map::DataVector> map_lines(const GridMap& map) {
  constexpr std::size_t kSegmentBytes = 32, kHeadBytes = 24;  // on the wire
  constexpr std::size_t kMost = (limits::kBodyBytes - kHeadBytes) / kSegmentBytes;
  const auto scale = static_cast<double>(map.info.scale);
  const int width = map.width(), height = map.height();
  const auto is_occupied = [&](int col, int row) {
    return col >= 0 && col < width && row >= 0 && row < height &&
           map.cells[static_cast<std::size_t>(row) * map.info.width + static_cast<std::size_t>(col)] > 0;
  };
  wire::map::DataVector lines{
      0, static_cast<float>(width * scale), 0, static_cast<float>(height * scale), {}};
  // Straight runs of edges on one grid line; a run ends where the occupied side changes.
  const auto add_runs = [&](int count, const auto& side_at, const auto& line) {
    for (int from = 0; from < count && lines.segments.size() <= kMost;) {
      const int side = side_at(from);
      int to = from + 1;
      while (to < count && side_at(to) == side) ++to;
      if (side != 0) lines.segments.push_back(line(from * scale, to * scale));
      from = to;
    }
  };
  for (int row = 0; row <= height; ++row)
    add_runs(
        width, [&](int col) { return int{is_occupied(col, row)} - int{is_occupied(col, row - 1)}; },
        [&](double from, double to) {
          return wire::Segment{from, row * scale, to, row * scale};
        });
  for (int col = 0; col <= width; ++col)
    add_runs(
        height, [&](int row) { return int{is_occupied(col, row)} - int{is_occupied(col - 1, row)}; },
        [&](double from, double to) {
          return wire::Segment{col * scale, from, col * scale, to};
        });
  if (lines.segments.size() > kMost) return std::nullopt;
  return lines;
}

bool is_map_request(std::uint8_t type, std::uint8_t subtype) {
  return type == static_cast<std::uint8_t>(wire::MessageType::kReq) &&
         (subtype == wire::map::kReqGetInfo || subtype == wire::map::kReqGetData);
}

void answer_map_request(const GridMap& map, const device::Message& message, device::Replier replier) {
  if (!is_map_request(message.type, message.subtype)) return;
  if (message.subtype == wire::map::kReqGetInfo) return replier.ack(wire::encode(map.info));
  const Result<wire::map::Data> asked = wire::decode<wire::map::Data>(message.body);
  if (!asked) return;
  if (const auto tile = map_tile(map, *asked)) replier.ack(wire::encode(*tile));
}

}  // namespace playhouse::drivers
