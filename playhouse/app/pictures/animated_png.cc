#include "playhouse/app/pictures/animated_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/scene/images/write_png.h"

namespace playhouse::app {
namespace {

constexpr std::size_t kSignature = 8;  // bytes before the first chunk

void append(std::string& out, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(number >> shift & 0xFF);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) number = number << 8 | static_cast<unsigned char>(bytes[at + k]);
  return number;
}

/// CRC-32 of a chunk (PNG Specification, annex D; ISO 3309).
std::uint32_t crc_of(std::string_view type, std::string_view content) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t k = 0; k < made.size(); ++k) {
      made[k] = k;
      for (int bit = 0; bit < 8; ++bit) made[k] = (made[k] & 1 ? 0xEDB88320u : 0u) ^ (made[k] >> 1);
    }
    return made;
  }();
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::string_view bytes : {type, content})
    for (const char byte : bytes) crc = table[(crc ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (crc >> 8);
  return ~crc;
}

}  // namespace

void AnimatedPng::add_chunk(std::string_view type, std::string_view content) {
  append(file_, static_cast<std::uint32_t>(content.size()));
  file_ += type;
  file_ += content;
  append(file_, crc_of(type, content));
}

/// Frame control: the full image, replacing the previous one, for the period in milliseconds.
void AnimatedPng::add_frame(const scene::RgbImage& picture) {
  std::string content;
  append(content, sequence_++);
  for (const int number : {picture.width, picture.height, 0, 0})
    append(content, static_cast<std::uint32_t>(number));
  const auto thousandths = static_cast<std::uint32_t>(std::clamp(std::round(1000 * period_), 1.0, 65535.0));
  append(content, thousandths << 16 | 1000);
  content.append(2, '\0');  // dispose: none; blend: source
  add_chunk("fcTL", content);
}

Result<void> AnimatedPng::add(const scene::RgbImage& picture) {
  PLAYHOUSE_ASSERT(added_ < pictures_);
  const Result<std::string> png = scene::png_of(picture.width, picture.height, picture.rgb);
  if (!png) return png.error();
  const std::string_view bytes = *png;
  if (added_ == 0) file_ = bytes.substr(0, kSignature);
  bool framed = false;
  for (std::size_t at = kSignature; at < bytes.size();) {
    const std::size_t length = number_at(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4), content = bytes.substr(at + 8, length);
    at += length + 12;
    if (type == "IDAT") {
      if (!std::exchange(framed, true)) add_frame(picture);
      if (added_ == 0) {
        add_chunk(type, content);
        continue;
      }
      std::string further;
      append(further, sequence_++);
      add_chunk("fdAT", further.append(content));
    } else if (added_ == 0 && type != "IEND") {
      add_chunk(type, content);
      if (type != "IHDR") continue;
      std::string animation;
      append(animation, static_cast<std::uint32_t>(pictures_));
      append(animation, 0);  // loops: infinite
      add_chunk("acTL", animation);
    }
  }
  ++added_;
  if (file_.size() <= limits::kFilmBytes) return {};
  return Error{"", fmt::format("would be more than {} MiB: choose a smaller --width, --rate or --duration",
                               limits::kFilmBytes >> 20)};
}

std::string AnimatedPng::take() {
  PLAYHOUSE_ASSERT(added_ == pictures_);
  add_chunk("IEND", "");
  return std::move(file_);
}

}  // namespace playhouse::app
