// Generated from interfaces/007_blobfinder.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blobfinder {

inline constexpr std::uint16_t kCode = 7;

// Subtypes of messages.
inline constexpr std::uint8_t kDataBlobs = 1;
inline constexpr std::uint8_t kReqSetColor = 1;
inline constexpr std::uint8_t kReqSetImagerParams = 2;
inline constexpr std::uint8_t kReqGetColor = 3;

struct Blob {
  std::uint32_t id = 0;
  std::uint32_t color = 0;
  /// [px]
  std::uint32_t area = 0;
  /// [px]
  std::uint32_t x = 0;
  /// [px]
  std::uint32_t y = 0;
  /// [px]
  std::uint32_t left = 0;
  /// [px]
  std::uint32_t right = 0;
  /// [px]
  std::uint32_t top = 0;
  /// [px]
  std::uint32_t bottom = 0;
  /// [m]
  float range = 0;

  friend bool operator==(const Blob&, const Blob&) = default;
};

struct Data {
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  std::vector<Blob> blobs{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct ColorConfig {
  std::uint32_t channel = 0;
  std::uint32_t rmin = 0;
  std::uint32_t rmax = 0;
  std::uint32_t gmin = 0;
  std::uint32_t gmax = 0;
  std::uint32_t bmin = 0;
  std::uint32_t bmax = 0;

  friend bool operator==(const ColorConfig&, const ColorConfig&) = default;
};

struct ImagerConfig {
  std::int32_t brightness = 0;
  std::int32_t contrast = 0;
  std::int32_t colormode = 0;
  std::int32_t autogain = 0;

  friend bool operator==(const ImagerConfig&, const ImagerConfig&) = default;
};

void read(Reader& in, Blob& m);
void write(Writer& out, const Blob& m);
void to_json(std::string& out, const Blob& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, ColorConfig& m);
void write(Writer& out, const ColorConfig& m);
void to_json(std::string& out, const ColorConfig& m);
void read(Reader& in, ImagerConfig& m);
void write(Writer& out, const ImagerConfig& m);
void to_json(std::string& out, const ImagerConfig& m);

}  // namespace playhouse::wire::blobfinder
