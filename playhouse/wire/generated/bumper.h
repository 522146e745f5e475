// Generated from interfaces/014_bumper.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::bumper {

inline constexpr std::uint16_t kCode = 14;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kDataGeom = 2;
inline constexpr std::uint8_t kReqGetGeom = 1;

struct Data {
  std::vector<std::uint8_t> bumpers{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Define {
  /// [frame X_RS]
  Pose3d pose{};
  /// [m]
  float length = 0;
  /// [m]
  float radius = 0;

  friend bool operator==(const Define&, const Define&) = default;
};

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
