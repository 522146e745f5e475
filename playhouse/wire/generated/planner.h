// Generated from interfaces/044_planner.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Plans and follows a path to a goal.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::planner {

inline constexpr std::uint16_t kCode = 44;

// Subtypes of messages.
/// Progress of the robot along its path.
inline constexpr std::uint8_t kDataState = 1;
/// Sets the goal.
inline constexpr std::uint8_t kCmdGoal = 1;
/// Sets the goal and starts to move.
inline constexpr std::uint8_t kCmdStart = 2;
/// Requests the planned path.
inline constexpr std::uint8_t kReqGetWaypoints = 1;
/// Enables or stops the robot.
inline constexpr std::uint8_t kReqEnable = 2;

/// Progress of the robot along its path.
struct Data {
  /// 1 if there is a path to the goal.
  std::uint8_t valid = 0;
  /// 1 if the goal is reached.
  std::uint8_t done = 0;
  /// The robot. [frame X_MR, m, m, rad]
  Pose2d pos{};
  /// The goal. [frame X_MG, m, m, rad]
  Pose2d goal{};
  /// Current waypoint of the robot. [frame X_MP, m, m, rad]
  Pose2d waypoint{};
  /// Index of that waypoint in the path; -1 if there is none.
  std::int32_t waypoint_idx = 0;
  /// Number of waypoints of the path.
  std::uint32_t waypoints_count = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// A goal.
struct Cmd {
  /// Goal pose. [frame X_MG, m, m, rad]
  Pose2d goal{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

/// The planned path.
struct WaypointsReq {
  /// Length of the path. [m]
  double waypoints_distance = 0;
  /// From the robot to the goal. [frame X_MP, m, m, rad]
  std::vector<Pose2d> waypoints{};

  friend bool operator==(const WaypointsReq&, const WaypointsReq&) = default;
};

/// The planner's switch.
struct EnableReq {
  /// 1: may move, 0: stop.
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
