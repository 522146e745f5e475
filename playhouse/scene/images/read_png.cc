#include "playhouse/scene/images/read_png.h"

#include <png.h>

#include <string>

namespace playhouse::scene {

Result<RgbImage> read_rgb(std::string_view png, std::size_t most_pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0)
    return Error{{}, std::string("is not a valid PNG: ") + image.message};
  image.format = PNG_FORMAT_RGB;
  if (std::size_t{image.width} * image.height > most_pixels) {
    png_image_free(&image);
    return Error{{}, "has more than " + std::to_string(most_pixels) + " pixels"};
  }
  RgbImage read{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  read.rgb.resize(PNG_IMAGE_SIZE(image));
  constexpr png_color kBlack{0, 0, 0};
  if (png_image_finish_read(&image, &kBlack, read.rgb.data(), 0, nullptr) == 0)
    return Error{{}, std::string("is not a valid PNG: ") + image.message};
  return read;
}

}  // namespace playhouse::scene
