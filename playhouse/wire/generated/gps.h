// Generated from interfaces/013_gps.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::gps {

inline constexpr std::uint16_t kCode = 13;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;

struct Data {
  /// [s]
  std::uint32_t time_sec = 0;
  /// [us]
  std::uint32_t time_usec = 0;
  /// [1e-7 deg]
  std::int32_t latitude = 0;
  /// [1e-7 deg]
  std::int32_t longitude = 0;
  /// [mm]
  std::int32_t altitude = 0;
  /// [m/s]
  double speed = 0;
  /// [rad]
  double course = 0;
  /// [m]
  double utm_e = 0;
  /// [m]
  double utm_n = 0;
  std::uint32_t quality = 0;
  std::uint32_t num_sats = 0;
  /// [0.1]
  std::uint32_t hdop = 0;
  /// [0.1]
  std::uint32_t vdop = 0;
  /// [m]
  double err_horz = 0;
  /// [m]
  double err_vert = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::gps
