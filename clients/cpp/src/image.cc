#include "playhouse_client/image.h"

#include <string>

#include "playhouse/wire/generated/camera.h"

namespace playhouse::client {

namespace camera = wire::camera;

namespace {

/// Pixel layout: values per pixel and bytes per value. None for formats that pixel() does not
/// support.
struct Layout {
  std::size_t values = 0;
  std::size_t bytes = 0;
};

Layout layout_of(const Image& image) {
  if (image.is_jpeg) return {};
  if (image.format == camera::kFormatMono8) return {1, 1};
  if (image.format == camera::kFormatMono16) return {1, 2};
  if (image.format == camera::kFormatRgb888) return {3, 1};
  return {};
}

}  // namespace

Result<std::vector<std::uint16_t>> Image::pixel(std::uint32_t column, std::uint32_t row) const {
  const Layout layout = layout_of(*this);
  if (layout.values == 0) return Error{"", "pixels can be told of raw MONO8, MONO16 and RGB888 alone"};
  if (column >= width || row >= height)
    return Error{"", "pixel " + std::to_string(column) + ", " + std::to_string(row) + " is outside the " +
                         std::to_string(width) + " x " + std::to_string(height) + " picture"};
  const std::uint64_t size = layout.values * layout.bytes;
  const std::uint64_t first = (std::uint64_t{row} * width + column) * size;
  if (data.size() < size || first > data.size() - size)
    return Error{"", "the picture has fewer bytes than pixels: " + std::to_string(data.size())};
  std::vector<std::uint16_t> values;
  for (std::size_t i = 0; i < layout.values; ++i) {
    const std::uint8_t* at = &data[first + i * layout.bytes];
    values.push_back(static_cast<std::uint16_t>(layout.bytes == 2 ? at[0] | at[1] << 8 : at[0]));
  }
  return values;
}

}  // namespace playhouse::client
