// Generated from interfaces/065_stereo.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A pair of cameras, their disparity and the points in space.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::stereo {

inline constexpr std::uint16_t kCode = 65;

// Subtypes of messages.
/// A pair of images, and the results computed from it.
inline constexpr std::uint8_t kDataState = 1;

/// One point.
struct Pointcloud3dStereoElement {
  /// [frame p_SP, m]
  float px = 0;
  /// [frame p_SP, m]
  float py = 0;
  /// [frame p_SP, m]
  float pz = 0;
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Pointcloud3dStereoElement&, const Pointcloud3dStereoElement&) = default;
};

/// A pair of images, and the results computed from it.
struct Data {
  /// Image of the left camera.
  camera::Data left_channel{};
  /// Image of the right camera.
  camera::Data right_channel{};
  /// Disparity, as an image.
  camera::Data disparity{};
  /// Points in space.
  std::vector<Pointcloud3dStereoElement> points{};
  /// Driver-specific.
  std::uint32_t mode = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Pointcloud3dStereoElement& m);
void write(Writer& out, const Pointcloud3dStereoElement& m);
void to_json(std::string& out, const Pointcloud3dStereoElement& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::stereo
