// Generated from interfaces/003_gripper.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A two-finger gripper, with break beams between the fingers and optionally a store for objects.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::gripper {

inline constexpr std::uint16_t kCode = 3;

// Subtypes of messages.
/// State of the fingers and of the break beams.
inline constexpr std::uint8_t kDataState = 1;
/// Opens the fingers.
inline constexpr std::uint8_t kCmdOpen = 1;
/// Closes the fingers.
inline constexpr std::uint8_t kCmdClose = 2;
/// Stops the fingers at their current position.
inline constexpr std::uint8_t kCmdStop = 3;
/// Moves the held object into the store.
inline constexpr std::uint8_t kCmdStore = 4;
/// Moves the object stored last between the fingers.
inline constexpr std::uint8_t kCmdRetrieve = 5;
/// Requests the gripper's size and pose.
inline constexpr std::uint8_t kReqGetGeom = 1;

/// Values of Data.state.
inline constexpr std::int32_t kStateOpen = 1;
inline constexpr std::int32_t kStateClosed = 2;
inline constexpr std::int32_t kStateMoving = 3;
inline constexpr std::int32_t kStateError = 4;

/// State of the fingers and of the break beams.
struct Data {
  /// Open, closed, moving or faulty.
  std::uint8_t state = 0;
  /// One bit per break beam, set if it is interrupted.
  std::uint32_t beams = 0;
  /// Number of stored objects.
  std::uint8_t stored = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// The gripper's size and pose.
struct Geom {
  /// Pose of the gripper on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Around the fingers. [m, m, m]
  Bbox3d outer_size{};
  /// Of the gap between the open fingers. [m, m, m]
  Bbox3d inner_size{};
  /// Number of break beams.
  std::uint8_t num_beams = 0;
  /// Capacity of the store, in objects.
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
