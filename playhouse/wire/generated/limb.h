// Generated from interfaces/054_limb.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// An arm controlled by the pose of its end effector.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::limb {

inline constexpr std::uint16_t kCode = 54;

// Subtypes of messages.
/// Pose of the end effector.
inline constexpr std::uint8_t kDataState = 1;
/// Moves the arm to its home position.
inline constexpr std::uint8_t kCmdHome = 1;
/// Stops the arm at its current position.
inline constexpr std::uint8_t kCmdStop = 2;
/// Moves the end effector to a pose.
inline constexpr std::uint8_t kCmdSetpose = 3;
/// Moves the end effector to a position, in any orientation.
inline constexpr std::uint8_t kCmdSetposition = 4;
/// Moves the end effector along a line from its current position.
inline constexpr std::uint8_t kCmdVecmove = 5;
/// Switches the motors on or off.
inline constexpr std::uint8_t kReqPower = 1;
/// Sets or releases the brakes.
inline constexpr std::uint8_t kReqBrakes = 2;
/// Requests the pose of the arm's base on the robot.
inline constexpr std::uint8_t kReqGeom = 3;
/// Sets the speed of the end effector.
inline constexpr std::uint8_t kReqSpeed = 4;

/// Values of Data.state.
inline constexpr std::int32_t kStateIdle = 1;
inline constexpr std::int32_t kStateBraked = 2;
inline constexpr std::int32_t kStateMoving = 3;
inline constexpr std::int32_t kStateOor = 4;
inline constexpr std::int32_t kStateColl = 5;

/// Pose of the end effector.
struct Data {
  /// [frame p_BE, m]
  Point3d position{};
  /// Approach direction, a unit vector. [frame n_B, 1]
  Point3d approach{};
  /// Unit vector across the end effector. [frame n_B, 1]
  Point3d orientation{};
  /// Idle, braked, moving, out of reach or in contact.
  std::uint8_t state = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded pose of the end effector.
struct SetposeCmd {
  /// [frame p_BE, m]
  Point3d position{};
  /// Commanded approach direction, a unit vector. [frame n_B, 1]
  Point3d approach{};
  /// Unit vector across the end effector. [frame n_B, 1]
  Point3d orientation{};

  friend bool operator==(const SetposeCmd&, const SetposeCmd&) = default;
};

/// Commanded position of the end effector.
struct SetpositionCmd {
  /// [frame p_BE, m]
  Point3d position{};

  friend bool operator==(const SetpositionCmd&, const SetpositionCmd&) = default;
};

/// A straight motion of the end effector.
struct VecmoveCmd {
  /// Unit vector of the motion. [frame n_B, 1]
  Point3d direction{};
  /// Distance. [m]
  float length = 0;

  friend bool operator==(const VecmoveCmd&, const VecmoveCmd&) = default;
};

/// The motors' switch.
struct PowerReq {
  /// 1: on, 0: off.
  std::uint8_t value = 0;

  friend bool operator==(const PowerReq&, const PowerReq&) = default;
};

/// The brakes' switch.
struct BrakesReq {
  /// 1: braked, 0: released.
  std::uint8_t value = 0;

  friend bool operator==(const BrakesReq&, const BrakesReq&) = default;
};

/// Pose of the arm's base.
struct GeomReq {
  /// Of the arm's base on the robot. [frame p_RB, m]
  Point3d basePos{};

  friend bool operator==(const GeomReq&, const GeomReq&) = default;
};

/// Speed of the end effector.
struct SpeedReq {
  /// Maximum speed of the end effector. [m/s]
  float speed = 0;

  friend bool operator==(const SpeedReq&, const SpeedReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, SetposeCmd& m);
void write(Writer& out, const SetposeCmd& m);
void to_json(std::string& out, const SetposeCmd& m);
void read(Reader& in, SetpositionCmd& m);
void write(Writer& out, const SetpositionCmd& m);
void to_json(std::string& out, const SetpositionCmd& m);
void read(Reader& in, VecmoveCmd& m);
void write(Writer& out, const VecmoveCmd& m);
void to_json(std::string& out, const VecmoveCmd& m);
void read(Reader& in, PowerReq& m);
void write(Writer& out, const PowerReq& m);
void to_json(std::string& out, const PowerReq& m);
void read(Reader& in, BrakesReq& m);
void write(Writer& out, const BrakesReq& m);
void to_json(std::string& out, const BrakesReq& m);
void read(Reader& in, GeomReq& m);
void write(Writer& out, const GeomReq& m);
void to_json(std::string& out, const GeomReq& m);
void read(Reader& in, SpeedReq& m);
void write(Writer& out, const SpeedReq& m);
void to_json(std::string& out, const SpeedReq& m);

}  // namespace playhouse::wire::limb
