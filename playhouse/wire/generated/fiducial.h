// Generated from interfaces/010_fiducial.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Sees marked things and tells which and where they are.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::fiducial {

inline constexpr std::uint16_t kCode = 10;

// Subtypes of messages.
/// The markers in view.
inline constexpr std::uint8_t kDataScan = 1;
/// Asks for the device's size and place and the markers' size.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Asks how far and how wide the device sees.
inline constexpr std::uint8_t kReqGetFov = 2;
/// Sets how far and how wide the device sees; the answer tells what was taken.
inline constexpr std::uint8_t kReqSetFov = 3;
/// Asks for the number that the robot itself shows to others.
inline constexpr std::uint8_t kReqGetId = 7;
/// Sets the number that the robot itself shows to others.
inline constexpr std::uint8_t kReqSetId = 8;

/// One marker in view.
struct Item {
  /// Number of the marker; if it cannot be told -1, from simulated finders 0.
  std::int32_t id = 0;
  /// Where the marker is. [frame X_ST, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Standard deviation of each part of the pose; 0 if unknown. [frame X_ST, m, m, m, rad, rad, rad]
  Pose3d upose{};

  friend bool operator==(const Item&, const Item&) = default;
};

/// The markers in view.
struct Data {
  std::vector<Item> fiducials{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Size and place.
struct Geom {
  /// Where the device is on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Of a box around the device. [m, m, m]
  Bbox3d size{};
  /// Of the markers; 0 if unknown. [m, m]
  Bbox2d fiducial_size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// How far and how wide the device sees.
struct Fov {
  /// [m]
  float min_range = 0;
  /// [m]
  float max_range = 0;
  /// From the first to the last direction. [rad]
  float view_angle = 0;

  friend bool operator==(const Fov&, const Fov&) = default;
};

/// A marker's number.
struct Id {
  std::uint32_t id = 0;

  friend bool operator==(const Id&, const Id&) = default;
};

void read(Reader& in, Item& m);
void write(Writer& out, const Item& m);
void to_json(std::string& out, const Item& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, Fov& m);
void write(Writer& out, const Fov& m);
void to_json(std::string& out, const Fov& m);
void read(Reader& in, Id& m);
void write(Writer& out, const Id& m);
void to_json(std::string& out, const Id& m);

}  // namespace playhouse::wire::fiducial
