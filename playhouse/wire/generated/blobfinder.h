// Generated from interfaces/007_blobfinder.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Finds regions of one color (blobs) in camera images.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blobfinder {

inline constexpr std::uint16_t kCode = 7;

// Subtypes of messages.
/// The blobs of one image.
inline constexpr std::uint8_t kDataBlobs = 1;
/// Sets the colors that a channel detects.
inline constexpr std::uint8_t kReqSetColor = 1;
/// Sets brightness, contrast and other settings of the camera.
inline constexpr std::uint8_t kReqSetImagerParams = 2;
/// Requests the colors that a channel detects.
inline constexpr std::uint8_t kReqGetColor = 3;

/// A blob. Pixel coordinates start at the top left corner of the image.
struct Blob {
  /// Channel that detected it.
  std::uint32_t id = 0;
  /// 0xRRGGBB, for display.
  std::uint32_t color = 0;
  /// Area in pixels. [px]
  std::uint32_t area = 0;
  /// Column of its centre. [px]
  std::uint32_t x = 0;
  /// Row of its centre. [px]
  std::uint32_t y = 0;
  /// First column. [px]
  std::uint32_t left = 0;
  /// Last column. [px]
  std::uint32_t right = 0;
  /// First row. [px]
  std::uint32_t top = 0;
  /// Last row. [px]
  std::uint32_t bottom = 0;
  /// Distance; 0 if unknown. [m]
  float range = 0;

  friend bool operator==(const Blob&, const Blob&) = default;
};

/// The blobs of one image.
struct Data {
  /// Of the image. [px]
  std::uint32_t width = 0;
  /// Of the image. [px]
  std::uint32_t height = 0;
  std::vector<Blob> blobs{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// The colors that a channel detects, as ranges of red, green and blue.
struct ColorConfig {
  /// Channel; -1 means all.
  std::int32_t channel = 0;
  std::uint32_t rmin = 0;
  std::uint32_t rmax = 0;
  std::uint32_t gmin = 0;
  std::uint32_t gmax = 0;
  std::uint32_t bmin = 0;
  std::uint32_t bmax = 0;

  friend bool operator==(const ColorConfig&, const ColorConfig&) = default;
};

/// Settings of the camera; -1 leaves a setting unchanged.
struct ImagerConfig {
  /// 0 to 255.
  std::int32_t brightness = 0;
  /// 0 to 255.
  std::int32_t contrast = 0;
  /// 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance.
  std::int32_t colormode = 0;
  /// 0 off, 1 on.
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
