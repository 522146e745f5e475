// Generated from interfaces/040_camera.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Images.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::camera {

inline constexpr std::uint16_t kCode = 40;

// Subtypes of messages.
/// One image.
inline constexpr std::uint8_t kDataState = 1;
/// Requests the camera's input and norm.
inline constexpr std::uint8_t kReqGetSource = 1;
/// Selects the input and norm.
inline constexpr std::uint8_t kReqSetSource = 2;
/// Requests one image now.
inline constexpr std::uint8_t kReqGetImage = 3;

/// Values of Data.format.
inline constexpr std::int32_t kFormatMono8 = 1;
inline constexpr std::int32_t kFormatMono16 = 2;
inline constexpr std::int32_t kFormatRgb565 = 4;
inline constexpr std::int32_t kFormatRgb888 = 5;

/// Values of Data.compression.
inline constexpr std::int32_t kCompressRaw = 0;
inline constexpr std::int32_t kCompressJpeg = 1;

/// One image.
struct Data {
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  /// Per pixel. [bit]
  std::uint32_t bpp = 0;
  /// Order and size of the colors.
  std::uint32_t format = 0;
  /// Divides the values of a disparity image; 1 otherwise.
  std::uint32_t fdiv = 0;
  /// Raw or JPEG.
  std::uint32_t compression = 0;
  /// Rows from the top, pixels from the left, or a JPEG file.
  std::vector<std::uint8_t> image{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// An input of the camera.
struct Source {
  /// Video norm, such as PAL or NTSC, NUL-terminated.
  std::string norm{};
  /// Index of the input.
  std::int32_t source = 0;

  friend bool operator==(const Source&, const Source&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Source& m);
void write(Writer& out, const Source& m);
void to_json(std::string& out, const Source& m);

}  // namespace playhouse::wire::camera
