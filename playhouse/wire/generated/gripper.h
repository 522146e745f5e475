// Generated from interfaces/003_gripper.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::gripper {

inline constexpr std::uint16_t kCode = 3;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdOpen = 1;
inline constexpr std::uint8_t kCmdClose = 2;
inline constexpr std::uint8_t kCmdStop = 3;
inline constexpr std::uint8_t kCmdStore = 4;
inline constexpr std::uint8_t kCmdRetrieve = 5;
inline constexpr std::uint8_t kReqGetGeom = 1;

inline constexpr std::int32_t kStateOpen = 1;
inline constexpr std::int32_t kStateClosed = 2;
inline constexpr std::int32_t kStateMoving = 3;
inline constexpr std::int32_t kStateError = 4;

struct Data {
  std::uint8_t state = 0;
  std::uint32_t beams = 0;
  std::uint8_t stored = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Geom {
  /// [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [m, m, m]
  Bbox3d outer_size{};
  /// [m, m, m]
  Bbox3d inner_size{};
  std::uint8_t num_beams = 0;
  std::uint8_t capacity = 0;

  friend bool operator==(const Geom&, const Geom&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);

}  // namespace playhouse::wire::gripper
