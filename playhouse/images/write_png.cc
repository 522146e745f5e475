#include "playhouse/images/write_png.h"

#include <png.h>

#include "playhouse/base/assert.h"

namespace playhouse::images {

Result<std::string> png_of(int width, int height, int channels, std::span<const std::uint8_t> samples,
                           PngEffort effort) {
  PLAYHOUSE_ASSERT(channels == 3 || channels == 4);
  PLAYHOUSE_ASSERT(samples.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                         static_cast<std::size_t>(channels));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  if (effort == PngEffort::kFast) image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr) == 0)
    return Error{{}, std::string("cannot be written as PNG: ") + image.message};
  bytes.resize(size);
  return bytes;
}

}  // namespace playhouse::images
