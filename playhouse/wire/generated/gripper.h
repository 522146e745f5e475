// Generated from interfaces/003_gripper.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A two-finger gripper, with light beams between the fingers and perhaps a place to store things.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::gripper {

inline constexpr std::uint16_t kCode = 3;

// Subtypes of messages.
/// What the fingers do and hold.
inline constexpr std::uint8_t kDataState = 1;
/// Opens the fingers.
inline constexpr std::uint8_t kCmdOpen = 1;
/// Closes the fingers.
inline constexpr std::uint8_t kCmdClose = 2;
/// Stops the fingers where they are.
inline constexpr std::uint8_t kCmdStop = 3;
/// Puts what the fingers hold into the store.
inline constexpr std::uint8_t kCmdStore = 4;
/// Takes the last stored thing between the fingers.
inline constexpr std::uint8_t kCmdRetrieve = 5;
/// Asks for the gripper's size and place.
inline constexpr std::uint8_t kReqGetGeom = 1;

/// Values of Data.state.
inline constexpr std::int32_t kStateOpen = 1;
inline constexpr std::int32_t kStateClosed = 2;
inline constexpr std::int32_t kStateMoving = 3;
inline constexpr std::int32_t kStateError = 4;

/// What the fingers do and hold.
struct Data {
  /// Open, closed, moving or faulty.
  std::uint8_t state = 0;
  /// One bit per light beam, set where something breaks the beam.
  std::uint32_t beams = 0;
  /// How many things are stored.
  std::uint8_t stored = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// The gripper's size and place.
struct Geom {
  /// Where the gripper is on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Around the fingers. [m, m, m]
  Bbox3d outer_size{};
  /// Of the gap between the open fingers. [m, m, m]
  Bbox3d inner_size{};
  /// How many light beams there are.
  std::uint8_t num_beams = 0;
  /// How many things the store can take.
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
