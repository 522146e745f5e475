#include "playhouse_client/blobfinder.h"

#include <utility>

namespace playhouse::client {

namespace bf = wire::blobfinder;

namespace {

Blob blob_of(const bf::Blob& one) {
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(one.color >> shift & 0xFF); };
  return {one.id,     {byte(16), byte(8), byte(0)},
          one.area,   one.x,
          one.y,      one.left,
          one.right,  one.top,
          one.bottom, one.range};
}

}  // namespace

Result<Blobfinder> Blobfinder::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, bf::kCode, index, access);
  if (!device) return device.error();
  return Blobfinder(std::move(*device));
}

std::vector<Blob> Blobfinder::blobs() const {
  std::vector<Blob> blobs;
  const auto data = device_.latest<bf::Data>(bf::kDataBlobs);
  if (!data) return blobs;
  for (const bf::Blob& one : data->blobs) blobs.push_back(blob_of(one));
  return blobs;
}

std::optional<ImageSize> Blobfinder::image_size() const {
  const auto data = device_.latest<bf::Data>(bf::kDataBlobs);
  if (!data) return std::nullopt;
  return ImageSize{data->width, data->height};
}

}  // namespace playhouse::client
