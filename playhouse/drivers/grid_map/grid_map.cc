#include "playhouse/drivers/grid_map/grid_map.h"

#include <zlib.h>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

std::vector<std::int8_t> compressed(const std::vector<std::int8_t>& cells) {
  uLongf size = compressBound(cells.size());
  std::vector<std::int8_t> out(size);
  const int result = compress(reinterpret_cast<Bytef*>(out.data()), &size,
                              reinterpret_cast<const Bytef*>(cells.data()), cells.size());
  out.resize(result == Z_OK ? size : 0);
  return out;
}

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
  return wire::map::Data{request.col, request.row, request.width, request.height, 1, compressed(tile)};
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
