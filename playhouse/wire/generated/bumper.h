// Generated from interfaces/014_bumper.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Contact switches.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::bumper {

inline constexpr std::uint16_t kCode = 14;

// Subtypes of messages.
/// Which bumpers are pressed.
inline constexpr std::uint8_t kDataState = 1;
/// Poses of the bumpers, sent on change.
inline constexpr std::uint8_t kDataGeom = 2;
/// Requests the poses of the bumpers.
inline constexpr std::uint8_t kReqGetGeom = 1;

/// Which bumpers are pressed.
struct Data {
  /// One per bumper: 0 free, else pressed.
  std::vector<std::uint8_t> bumpers{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// One bumper.
struct Define {
  /// Of the bumper's centre. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [m]
  float length = 0;
  /// Radius of curvature; 0 if it is straight. [m]
  float radius = 0;

  friend bool operator==(const Define&, const Define&) = default;
};

/// Poses of the bumpers.
struct Geom {
  std::vector<Define> bumper_def{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Define& m);
void write(Writer& out, const Define& m);
void to_json(std::string& out, const Define& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);

}  // namespace playhouse::wire::bumper
