#include "playhouse/bridge/interfaces/vision/image.h"

#include <turbojpeg.h>

#include <memory>

#include "playhouse/world/camera.h"

namespace playhouse::drivers {
namespace {

namespace cam = wire::camera;
using scene::ImageKind;

/// Compresses to JPEG; empty if the library is out of memory.
std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes, int width, int height,
                                     bool in_color, int quality) {
  const std::unique_ptr<void, int (*)(tjhandle)> library(tjInitCompress(), tjDestroy);
  unsigned char* file = nullptr;
  unsigned long size = 0;
  if (!library || tjCompress2(library.get(), bytes.data(), width, 0, height, in_color ? TJPF_RGB : TJPF_GRAY,
                              &file, &size, in_color ? TJSAMP_444 : TJSAMP_GRAY, quality, 0) != 0)
    return {};
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(file, tjFree);
  return {file, file + size};
}

}  // namespace

cam::Data image_of(const scene::CameraDesc& camera, std::span<const world::Pixel> pixels) {
  cam::Data data;
  data.width = static_cast<std::uint32_t>(camera.width);
  data.height = static_cast<std::uint32_t>(camera.height);
  const bool in_color = camera.image == ImageKind::kColor, in_gray = camera.image == ImageKind::kGray;
  const std::size_t size = world::bytes_per_pixel(camera.image);
  data.bpp = static_cast<std::uint32_t>(8 * size);
  data.format = size == 3 ? cam::kFormatRgb888 : size == 2 ? cam::kFormatMono16 : cam::kFormatMono8;
  data.fdiv = 1;
  data.compression = cam::kCompressRaw;
  data.image = world::image_bytes(camera.image, pixels);
  if (!(in_color || in_gray) || camera.compression == scene::ImageCompression::kRaw) return data;
  data.image = compressed(data.image, static_cast<int>(data.width), static_cast<int>(data.height), in_color,
                          static_cast<int>(camera.quality));
  data.compression = cam::kCompressJpeg;
  return data;
}

}  // namespace playhouse::drivers
