// Generated from interfaces/040_camera.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::camera {

inline constexpr std::uint16_t kCode = 40;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kReqGetSource = 1;
inline constexpr std::uint8_t kReqSetSource = 2;
inline constexpr std::uint8_t kReqGetImage = 3;

inline constexpr std::int32_t kFormatMono8 = 1;
inline constexpr std::int32_t kFormatMono16 = 2;
inline constexpr std::int32_t kFormatRgb565 = 4;
inline constexpr std::int32_t kFormatRgb888 = 5;
inline constexpr std::int32_t kCompressRaw = 0;
inline constexpr std::int32_t kCompressJpeg = 1;

struct Data {
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  std::uint32_t bpp = 0;
  std::uint32_t format = 0;
  std::uint32_t fdiv = 0;
  std::uint32_t compression = 0;
  std::vector<std::uint8_t> image{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Source {
  std::string norm{};
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
