// Generated from interfaces/013_gps.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A satellite receiver.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::gps {

inline constexpr std::uint16_t kCode = 13;

// Subtypes of messages.
/// The newest fix.
inline constexpr std::uint8_t kDataState = 1;

/// A fix.
struct Data {
  /// Time of the fix since 1970: whole seconds. [s]
  std::uint32_t time_sec = 0;
  /// Time of the fix: microseconds of the second. [us]
  std::uint32_t time_usec = 0;
  /// Positive north, WGS84. [1e-7 deg]
  std::int32_t latitude = 0;
  /// Positive east, WGS84. [1e-7 deg]
  std::int32_t longitude = 0;
  /// Above the ellipsoid. [mm]
  std::int32_t altitude = 0;
  /// Over ground. [m/s]
  double speed = 0;
  /// Direction of travel, clockwise from north. [rad]
  double course = 0;
  /// UTM easting. [m]
  double utm_e = 0;
  /// UTM northing. [m]
  double utm_n = 0;
  /// 0: no fix, 1: plain, 2: differential.
  std::uint32_t quality = 0;
  /// Satellites used.
  std::uint32_t num_sats = 0;
  /// Horizontal dilution of precision. [0.1]
  std::uint32_t hdop = 0;
  /// Vertical dilution of precision. [0.1]
  std::uint32_t vdop = 0;
  /// Expected horizontal error. [m]
  double err_horz = 0;
  /// Expected vertical error. [m]
  double err_vert = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::gps
