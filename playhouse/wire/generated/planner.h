// Generated from interfaces/044_planner.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::planner {

inline constexpr std::uint16_t kCode = 44;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdGoal = 1;
inline constexpr std::uint8_t kCmdStart = 2;
inline constexpr std::uint8_t kReqGetWaypoints = 1;
inline constexpr std::uint8_t kReqEnable = 2;

struct Data {
  std::uint8_t valid = 0;
  std::uint8_t done = 0;
  /// [frame X_RS, m, m, rad]
  Pose2d pos{};
  /// [frame X_RS, m, m, rad]
  Pose2d goal{};
  /// [frame X_RS, m, m, rad]
  Pose2d waypoint{};
  std::int32_t waypoint_idx = 0;
  std::uint32_t waypoints_count = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  /// [frame X_RS, m, m, rad]
  Pose2d goal{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

struct WaypointsReq {
  /// [m]
  double waypoints_distance = 0;
  /// [frame X_RS, m, m, rad]
  std::vector<Pose2d> waypoints{};

  friend bool operator==(const WaypointsReq&, const WaypointsReq&) = default;
};

struct EnableReq {
  std::uint8_t state = 0;

  friend bool operator==(const EnableReq&, const EnableReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, WaypointsReq& m);
void write(Writer& out, const WaypointsReq& m);
void to_json(std::string& out, const WaypointsReq& m);
void read(Reader& in, EnableReq& m);
void write(Writer& out, const EnableReq& m);
void to_json(std::string& out, const EnableReq& m);

}  // namespace playhouse::wire::planner
