#include "playhouse/mesh/image_file.h"

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include <cstring>
#include <memory>

#include "playhouse/base/mesh_limits.h"

namespace playhouse::mesh {
namespace {

Result<void> check_size(std::uint64_t width, std::uint64_t height, std::size_t most_pixels) {
  const std::uint64_t most = limits::kMeshImageSide;
  if (width == 0 || height == 0) return Error{{}, "has no pixels"};
  if (width > most || height > most || width * height > most_pixels)
    return Error{{}, fmt::format("has {} x {} pixels, which is too many", width, height)};
  return {};
}

Result<Image> decode_png(std::string_view bytes, std::size_t most_pixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> owner(&png, png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
    return Error{{}, std::string("is not a valid PNG: ") + png.message};
  if (const auto size = check_size(png.width, png.height, most_pixels); !size) return size.error();
  png.format = PNG_FORMAT_RGBA;
  Image image{png.width, png.height, {}};
  image.rgba.resize(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0)
    return Error{{}, std::string("is not a valid PNG: ") + png.message};
  return image;
}

Result<Image> decode_jpeg(std::string_view bytes, std::size_t most_pixels) {
  const std::unique_ptr<void, int (*)(tjhandle)> library(tjInitDecompress(), tjDestroy);
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, sampling = 0, colors = 0;
  if (!library ||
      tjDecompressHeader3(library.get(), data, bytes.size(), &width, &height, &sampling, &colors) != 0)
    return Error{{}, std::string("is not a valid JPEG: ") + tjGetErrorStr2(library.get())};
  const auto size =
      check_size(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), most_pixels);
  if (!size) return size.error();
  Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  image.rgba.resize(std::size_t{4} * image.width * image.height);
  if (tjDecompress2(library.get(), data, bytes.size(), image.rgba.data(), width, 0, height, TJPF_RGBA,
                    TJFLAG_ACCURATEDCT) != 0 &&
      tjGetErrorCode(library.get()) == TJERR_FATAL)
    return Error{{}, std::string("is not a valid JPEG: ") + tjGetErrorStr2(library.get())};
  return image;
}

}  // namespace

Result<Image> decode_image(std::string_view bytes, std::size_t most_pixels) {
  if (bytes.starts_with("\x89PNG")) return decode_png(bytes, most_pixels);
  if (bytes.starts_with("\xFF\xD8")) return decode_jpeg(bytes, most_pixels);
  return Error{{}, "is neither a PNG nor a JPEG"};
}

std::string png_of(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGBA;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::string file;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  file.resize(size);
  if (png_image_write_to_memory(&png, file.data(), &size, 0, image.rgba.data(), 0, nullptr) == 0) return {};
  file.resize(size);
  return file;
}

}  // namespace playhouse::mesh
