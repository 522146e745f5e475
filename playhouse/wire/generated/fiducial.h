// Generated from interfaces/010_fiducial.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Detects markers and reports their ids and poses.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::fiducial {

inline constexpr std::uint16_t kCode = 10;

// Subtypes of messages.
/// The markers in view.
inline constexpr std::uint8_t kDataScan = 1;
/// Requests the device's size and pose and the markers' size.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Requests the range and the field of view.
inline constexpr std::uint8_t kReqGetFov = 2;
/// Sets the range and the field of view; the answer has the values in effect.
inline constexpr std::uint8_t kReqSetFov = 3;
/// Requests the robot's own marker id.
inline constexpr std::uint8_t kReqGetId = 7;
/// Sets the robot's own marker id.
inline constexpr std::uint8_t kReqSetId = 8;

/// One marker in view.
struct Item {
  /// Id of the marker; -1 if it cannot be identified, from simulated finders 0.
  std::int32_t id = 0;
  /// Pose of the marker. [frame X_ST, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Standard deviation of each component of the pose; 0 if unknown. [frame X_ST, m, m, m, rad, rad, rad]
  Pose3d upose{};

  friend bool operator==(const Item&, const Item&) = default;
};

/// The markers in view.
struct Data {
  std::vector<Item> fiducials{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Size and pose.
struct Geom {
  /// Pose of the device on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Bounding box of the device. [m, m, m]
  Bbox3d size{};
  /// Of the markers; 0 if unknown. [m, m]
  Bbox2d fiducial_size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// Range and field of view.
struct Fov {
  /// [m]
  float min_range = 0;
  /// [m]
  float max_range = 0;
  /// From the first to the last direction. [rad]
  float view_angle = 0;

  friend bool operator==(const Fov&, const Fov&) = default;
};

/// A marker id.
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
