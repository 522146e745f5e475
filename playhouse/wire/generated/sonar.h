// Generated from interfaces/005_sonar.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// An array of sonars. New drivers use the ranger interface.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::sonar {

inline constexpr std::uint16_t kCode = 5;

// Subtypes of messages.
/// One range per sonar.
inline constexpr std::uint8_t kDataRanges = 1;
/// Poses of the sonars, sent on change.
inline constexpr std::uint8_t kDataGeom = 2;
/// Requests the poses of the sonars.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Switches the sonars on or off.
inline constexpr std::uint8_t kReqPower = 2;

/// One range per sonar.
struct Data {
  /// Range of the nearest echo, in the order of the geometry. [m]
  std::vector<float> ranges{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Poses of the sonars.
struct Geom {
  /// One per sonar; x points along its beam. [frame X_RS, m, m, m, rad, rad, rad]
  std::vector<Pose3d> poses{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// The sonars' switch.
struct PowerConfig {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);

}  // namespace playhouse::wire::sonar
