// Generated from interfaces/005_sonar.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::sonar {

inline constexpr std::uint16_t kCode = 5;

// Subtypes of messages.
inline constexpr std::uint8_t kDataRanges = 1;
inline constexpr std::uint8_t kDataGeom = 2;
inline constexpr std::uint8_t kReqGetGeom = 1;
inline constexpr std::uint8_t kReqPower = 2;

struct Data {
  /// [m]
  std::vector<float> ranges{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Geom {
  /// [frame X_RS, m, m, m, rad, rad, rad]
  std::vector<Pose3d> poses{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct PowerConfig {
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
