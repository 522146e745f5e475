#include "playhouse/scene/images/image_file.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_ONLY_BMP
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace playhouse::scene {
namespace {

constexpr std::uint8_t kClearUpTo = 127;  // alpha

/// Fails on an empty image and beyond `most` pixels.
Result<void> check_size(std::uint64_t width, std::uint64_t height, std::size_t most) {
  if (width > 0 && height > 0 && width <= most && height <= most / width) return {};
  return Error{{},
               "has " + std::to_string(width) + " x " + std::to_string(height) + " pixels; up to " +
                   std::to_string(most) + " are possible"};
}

/// Allocates an image; `samples` per pixel: 1 (grey),
/// 2 (with alpha), 3 (RGB) or 4 (with alpha).
void begin(FirstChannel& image, std::size_t pixels, std::size_t) {
  image.level.assign(pixels, 0);
}
void begin(Shades& image, std::size_t pixels, std::size_t samples) {
  image.color.assign(pixels, 0);
  if (samples % 2 == 0) image.alpha.assign(pixels, 0);
}

/// Stores a pixel from its samples.
void put(FirstChannel& image, std::size_t pixel, std::span<const std::uint8_t> samples) {
  const bool is_clear = samples.size() % 2 == 0 && samples.back() <= kClearUpTo;
  image.level[pixel] = is_clear ? 255 : samples[0];
}
void put(Shades& image, std::size_t pixel, std::span<const std::uint8_t> samples) {
  const int sum = samples.size() < 3 ? 3 * samples[0] : samples[0] + samples[1] + samples[2];
  image.color[pixel] = static_cast<std::uint16_t>(sum);
  if (!image.alpha.empty()) image.alpha[pixel] = samples.back();
}

/// Context of libpng's callbacks.
struct PngReading {
  std::string_view bytes;
  std::size_t most_pixels = 0;
  std::size_t at = 0;
  std::string failure;
  std::vector<std::uint8_t> row;
};

void png_failed(png_structp png, png_const_charp text) {
  static_cast<PngReading*>(png_get_error_ptr(png))->failure = text;
  png_longjmp(png, 1);
}

void png_warned(png_structp, png_const_charp) {}

void png_read_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto& reading = *static_cast<PngReading*>(png_get_io_ptr(png));
  if (count > reading.bytes.size() - reading.at) png_error(png, "the file ends too early");
  std::memcpy(out, reading.bytes.data() + reading.at, count);
  reading.at += count;
}

/// Rows as 8-bit channels, red or grey first; palettes and low bit depths are expanded.
template <typename Image>
void png_read_rows(png_structp png, png_infop about, PngReading& reading, Image& image) {
  png_read_info(png, about);
  const png_uint_32 width = png_get_image_width(png, about);
  const png_uint_32 height = png_get_image_height(png, about);
  if (const auto size = check_size(width, height, reading.most_pixels); !size) {
    reading.failure = size.error().text;
    return;
  }
  png_set_expand(png);
  png_set_strip_16(png);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, about);
  const std::size_t row_bytes = png_get_rowbytes(png, about);
  const std::size_t channels = png_get_channels(png, about);
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  begin(image, std::size_t{width} * height, channels);
  // Interlaced images come in passes over the rows, each based on the previous one.
  reading.row.assign(passes == 1 ? row_bytes : row_bytes * height, 0);
  for (int pass = 0; pass < passes; ++pass) {
    for (png_uint_32 y = 0; y < height; ++y) {
      std::uint8_t* row = reading.row.data() + (passes == 1 ? 0 : y * row_bytes);
      png_read_row(png, row, nullptr);
      for (png_uint_32 x = 0; x < width; ++x)
        put(image, std::size_t{y} * width + x, {row + x * channels, channels});
    }
  }
}

template <typename Image>
Result<Image> read_png(std::string_view bytes, std::size_t most_pixels) {
  // libpng reports errors by longjmp: objects with destructors have to live outside the frame.
  const auto reading = std::make_unique<PngReading>();
  const auto image = std::make_unique<Image>();
  reading->bytes = bytes;
  reading->most_pixels = most_pixels;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, reading.get(), png_failed, png_warned);
  png_infop about = png ? png_create_info_struct(png) : nullptr;
  if (!about) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    return Error{{}, "cannot be decoded: out of memory"};
  }
  if (setjmp(png_jmpbuf(png)) == 0) {
    png_set_read_fn(png, reading.get(), png_read_bytes);
    png_set_user_limits(png, 0x7FFFFFFF, 0x7FFFFFFF);
    // Texts and profiles are skipped unread: libpng allocates their length before it knows that it lies.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_rows(png, about, *reading, *image);
  }
  png_destroy_read_struct(&png, &about, nullptr);
  if (!reading->failure.empty()) return Error{{}, "is not a valid PNG: " + reading->failure};
  return std::move(*image);
}

/// Tokens of a PNM header and of ASCII pixels; "#" starts a comment.
class PnmText {
 public:
  PnmText(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::optional<std::uint32_t> number() {
    skip_blanks();
    std::uint64_t value = 0;
    const std::size_t start = at_;
    while (at_ < bytes_.size() && is_digit(bytes_[at_])) {
      value =
          std::min<std::uint64_t>(10 * value + static_cast<std::uint64_t>(bytes_[at_++] - '0'), 0xFFFFFFFFu);
    }
    if (at_ == start) return std::nullopt;
    return static_cast<std::uint32_t>(value);
  }
  /// One pixel of an ASCII PBM; white space between digits is optional.
  std::optional<std::uint32_t> digit() {
    skip_blanks();
    if (at_ >= bytes_.size() || !is_digit(bytes_[at_])) return std::nullopt;
    return static_cast<std::uint32_t>(bytes_[at_++] - '0');
  }
  std::size_t at() const { return at_; }

 private:
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  void skip_blanks() {
    while (at_ < bytes_.size()) {
      const char c = bytes_[at_];
      if (c == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (c == ' ' || (c >= '\t' && c <= '\r')) {
        ++at_;
      } else {
        return;
      }
    }
  }
  std::string_view bytes_;
  std::size_t at_;
};

/// One of the six PNM formats: "P1" to "P3" are bitmap,
/// grey and colour in ASCII, "P4" to "P6" in binary.
struct PnmKind {
  bool ascii, bits;
  std::size_t channels;
};

PnmKind kind_of_pnm(char digit) {
  return {digit <= '3', digit == '1' || digit == '4', digit == '3' || digit == '6' ? 3u : 1u};
}

/// Reads the pixels of an ASCII PNM; false if truncated or above `top`.
template <typename Image>
bool read_ascii_pixels(PnmText& text, PnmKind kind, std::uint32_t top, std::size_t pixels, Image& image) {
  std::uint8_t samples[3] = {};
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t k = 0; k < kind.channels; ++k) {
      const auto value = kind.bits ? text.digit() : text.number();
      if (!value || *value > top) return false;
      samples[k] =
          static_cast<std::uint8_t>(kind.bits ? (*value ? 0 : 255) : *value * std::uint64_t{255} / top);
    }
    put(image, i, {samples, kind.channels});
  }
  return true;
}

/// Reads the pixels of a binary PNM; false if truncated or above `top`.
template <typename Image>
bool read_binary_pixels(std::string_view bytes, PnmKind kind, std::uint32_t top, std::size_t pixels,
                        Image& image) {
  const std::size_t width = static_cast<std::size_t>(image.width),
                    height = static_cast<std::size_t>(image.height);
  const std::size_t depth = top > 255 ? 2 : 1;
  const std::size_t row_bytes = kind.bits ? (width + 7) / 8 : width * kind.channels * depth;
  if (bytes.size() < row_bytes * height) return false;
  const auto byte = [bytes](std::size_t at) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at]));
  };
  std::uint8_t samples[3] = {};
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::size_t x = i % width, row = i / width * row_bytes;
    for (std::size_t k = 0; k < kind.channels; ++k) {
      const std::size_t at = row + (x * kind.channels + k) * depth;
      const std::uint32_t value = kind.bits    ? ~(byte(row + x / 8) >> (7 - x % 8)) & 1u
                                  : depth == 2 ? byte(at) << 8 | byte(at + 1)
                                               : byte(at);
      if (value > top) return false;
      samples[k] = static_cast<std::uint8_t>(value * 255 / top);
    }
    put(image, i, {samples, kind.channels});
  }
  return true;
}

template <typename Image>
Result<Image> read_pnm(std::string_view bytes, std::size_t most_pixels) {
  const Error bad{{}, "is not a valid PNM: the header is wrong or the pixels end too early"};
  const PnmKind kind = kind_of_pnm(bytes[1]);
  PnmText text(bytes, 2);
  const auto width = text.number(), height = text.number();
  const auto top = kind.bits ? std::optional<std::uint32_t>(1) : text.number();
  if (!width || !height || !top || *top == 0 || *top > 65535) return bad;
  if (const auto size = check_size(*width, *height, most_pixels); !size) return size.error();
  const std::size_t pixels = std::size_t{*width} * *height;
  if (text.at() >= bytes.size() || (!(kind.bits && !kind.ascii) && pixels > bytes.size())) return bad;
  Image image;
  image.width = static_cast<int>(*width);
  image.height = static_cast<int>(*height);
  begin(image, pixels, kind.channels);
  const bool whole = kind.ascii ? read_ascii_pixels(text, kind, *top, pixels, image)
                                : read_binary_pixels(bytes.substr(text.at() + 1), kind, *top, pixels, image);
  return whole ? Result<Image>(std::move(image)) : bad;
}

/// Input of stb_image, which silently reads zeros past the end: this records
/// it. Skipped bytes, such as the pad after the last row, may be missing.
struct BmpReading {
  std::string_view bytes;
  std::size_t at = 0;
  bool ended_early = false;

  static int read(void* user, char* out, int count) {
    auto& self = *static_cast<BmpReading*>(user);
    const std::size_t taken = std::min(static_cast<std::size_t>(count), self.bytes.size() - self.at);
    std::memcpy(out, self.bytes.data() + self.at, taken);
    self.at += taken;
    self.ended_early |= taken == 0;
    return static_cast<int>(taken);
  }
  static void skip(void* user, int count) {
    auto& self = *static_cast<BmpReading*>(user);
    self.at = std::min(self.at + static_cast<std::size_t>(std::max(0, count)), self.bytes.size());
  }
  static int is_at_end(void* user) {
    const auto& self = *static_cast<BmpReading*>(user);
    return self.at == self.bytes.size();
  }
};

/// Expected size of an uncompressed BMP: the header has the offset of pixels (byte 10)
/// and bits per pixel (byte 28); rows are padded to four bytes, except the last one.
std::uint64_t bmp_bytes(std::string_view bytes, std::uint64_t width, std::uint64_t height) {
  const auto number = [bytes](std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < count && at + k < bytes.size(); ++k)
      value |= std::uint64_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
    return value;
  };
  if (width == 0 || height == 0) return 0;
  const bool has_core_head = number(14, 4) == 12;  // the oldest header
  const std::uint64_t bits = width * number(has_core_head ? 24 : 28, 2);
  return number(10, 4) + (bits + 31) / 32 * 4 * (height - 1) + (bits + 7) / 8;
}

Error bmp_ends_early() {
  return {{}, "is not a valid BMP: the file ends too early"};
}

template <typename Image>
Result<Image> read_bmp(std::string_view bytes, std::size_t most_pixels) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) {
    return Error{{}, "is not a PNG, JPEG, PNM (.pgm, .ppm, .pbm) or BMP image"};
  }
  // Negative heights mean rows from top to bottom.
  const auto pixels_of = [](int side) { return static_cast<std::uint64_t>(std::llabs(side)); };
  if (const auto fits = check_size(pixels_of(width), pixels_of(height), most_pixels); !fits)
    return fits.error();
  // Checked before allocating. A wrong pixel offset in the header is detected later.
  if (bmp_bytes(bytes, pixels_of(width), pixels_of(height)) > bytes.size()) return bmp_ends_early();
  BmpReading reading{bytes};
  constexpr stbi_io_callbacks kCallbacks{BmpReading::read, BmpReading::skip, BmpReading::is_at_end};
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_callbacks(&kCallbacks, &reading, &width, &height, &channels, channels), stbi_image_free);
  if (reading.ended_early) return bmp_ends_early();
  if (!pixels) return Error{{}, std::string("cannot be decoded: ") + stbi_failure_reason()};
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto samples = static_cast<std::size_t>(channels);
  Image image;
  image.width = width;
  image.height = height;
  begin(image, count, samples);
  for (std::size_t i = 0; i < count; ++i) put(image, i, {pixels.get() + i * samples, samples});
  return image;
}

Error no_jpeg(std::string_view why) {
  return {{}, "is not a valid JPEG: " + std::string(why)};
}

/// The library fills what is missing at the end with gray, and reports other faults with readable images.
bool has_all_pixels(tjhandle library) {
  const std::string_view fault = tjGetErrorStr2(library);
  return tjGetErrorCode(library) != TJERR_FATAL && !fault.starts_with("Premature end");
}

template <typename Image>
Result<Image> read_jpeg(std::string_view bytes, std::size_t most_pixels) {
  const std::unique_ptr<void, int (*)(tjhandle)> library(tjInitDecompress(), tjDestroy);
  if (!library) return no_jpeg(tjGetErrorStr2(nullptr));
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, sampling = 0, colors = 0;
  if (tjDecompressHeader3(library.get(), data, bytes.size(), &width, &height, &sampling, &colors) != 0)
    return no_jpeg(tjGetErrorStr2(library.get()));
  const auto fits =
      check_size(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), most_pixels);
  if (!fits) return fits.error();
  constexpr std::size_t kSamples = 3, kMostPixels = 8 * 64;  // of a byte: a block of 64 takes a bit or more
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels / kMostPixels > bytes.size()) return no_jpeg("the file ends too early");
  std::vector<std::uint8_t> samples(kSamples * pixels);
  if (tjDecompress2(library.get(), data, bytes.size(), samples.data(), width, 0, height, TJPF_RGB,
                    TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0 &&
      !has_all_pixels(library.get()))
    return no_jpeg(tjGetErrorStr2(library.get()));
  Image image;
  image.width = width;
  image.height = height;
  begin(image, pixels, kSamples);
  for (std::size_t i = 0; i < pixels; ++i) put(image, i, {samples.data() + kSamples * i, kSamples});
  return image;
}

template <typename Image>
Result<Image> read_image(std::string_view bytes, std::size_t most_pixels) {
  if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return read_png<Image>(bytes, most_pixels);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6')
    return read_pnm<Image>(bytes, most_pixels);
  if (bytes.starts_with("\xFF\xD8\xFF")) return read_jpeg<Image>(bytes, most_pixels);
  return read_bmp<Image>(bytes, most_pixels);
}

}  // namespace

Result<FirstChannel> read_first_channel(std::string_view bytes, std::size_t most_pixels) {
  return read_image<FirstChannel>(bytes, most_pixels);
}

Result<Shades> read_shades(std::string_view bytes, std::size_t most_pixels) {
  return read_image<Shades>(bytes, most_pixels);
}

}  // namespace playhouse::scene
