// Generated from interfaces/052_position1d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A single prismatic or revolute actuator.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::position1d {

inline constexpr std::uint16_t kCode = 52;

// Subtypes of messages.
/// Position of the actuator.
inline constexpr std::uint8_t kDataState = 1;
/// Size and pose, sent on change.
inline constexpr std::uint8_t kDataGeom = 2;
/// Commanded velocity.
inline constexpr std::uint8_t kCmdVel = 1;
/// Commanded position.
inline constexpr std::uint8_t kCmdPos = 2;
/// Requests size and pose.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Switches the motor on or off.
inline constexpr std::uint8_t kReqMotorPower = 2;
/// Selects the driver's velocity controller.
inline constexpr std::uint8_t kReqVelocityMode = 3;
/// Selects between velocity and position control.
inline constexpr std::uint8_t kReqPositionMode = 4;
/// Sets the reference of the position.
inline constexpr std::uint8_t kReqSetOdom = 5;
/// Sets the current position to zero.
inline constexpr std::uint8_t kReqResetOdom = 6;
/// Sets the gains of velocity control.
inline constexpr std::uint8_t kReqSpeedPid = 7;
/// Sets the gains of position control.
inline constexpr std::uint8_t kReqPositionPid = 8;
/// Sets the speed and acceleration limits of position control.
inline constexpr std::uint8_t kReqSpeedProf = 9;

/// Bits of Data.status, by number.
inline constexpr std::int32_t kStatusLimitMin = 0;
inline constexpr std::int32_t kStatusLimitCen = 1;
inline constexpr std::int32_t kStatusLimitMax = 2;
inline constexpr std::int32_t kStatusOc = 3;
inline constexpr std::int32_t kStatusTrajComplete = 4;
inline constexpr std::int32_t kStatusEnabled = 5;

/// Position of the actuator.
struct Data {
  /// From its zero. [m or rad]
  float pos = 0;
  /// [m/s or rad/s]
  float vel = 0;
  /// 1 if it is blocked by an obstacle.
  std::uint8_t stall = 0;
  /// Limits, current, motion and power, one bit each.
  std::uint8_t status = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded velocity.
struct CmdVel {
  /// [m/s or rad/s]
  float vel = 0;
  /// 1: motor on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const CmdVel&, const CmdVel&) = default;
};

/// Commanded position.
struct CmdPos {
  /// From its zero. [m or rad]
  float pos = 0;
  /// Velocity on the way; zero: chosen by the driver. [m/s or rad/s]
  float vel = 0;
  /// 1: motor on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const CmdPos&, const CmdPos&) = default;
};

/// Size and pose.
struct Geom {
  /// Pose of the actuator on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Bounding box of the actuator. [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// The motor's switch.
struct PowerConfig {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// A velocity controller.
struct VelocityModeConfig {
  /// Driver-specific.
  std::uint32_t value = 0;

  friend bool operator==(const VelocityModeConfig&, const VelocityModeConfig&) = default;
};

/// Request to set the current position to zero.
struct ResetOdomConfig {
  /// Without meaning.
  std::uint32_t value = 0;

  friend bool operator==(const ResetOdomConfig&, const ResetOdomConfig&) = default;
};

/// A control mode.
struct PositionModeReq {
  /// 0: velocity, 1: position.
  std::uint32_t state = 0;

  friend bool operator==(const PositionModeReq&, const PositionModeReq&) = default;
};

/// New value of the current position.
struct SetOdomReq {
  /// New value of the current position. [m or rad]
  float pos = 0;

  friend bool operator==(const SetOdomReq&, const SetOdomReq&) = default;
};

/// Gains of velocity control.
struct SpeedPidReq {
  /// Proportional. [1]
  float kp = 0;
  /// Integral. [1]
  float ki = 0;
  /// Derivative. [1]
  float kd = 0;

  friend bool operator==(const SpeedPidReq&, const SpeedPidReq&) = default;
};

/// Gains of position control.
struct PositionPidReq {
  /// Proportional. [1]
  float kp = 0;
  /// Integral. [1]
  float ki = 0;
  /// Derivative. [1]
  float kd = 0;

  friend bool operator==(const PositionPidReq&, const PositionPidReq&) = default;
};

/// Limits of position control.
struct SpeedProfReq {
  /// Maximum speed. [m/s or rad/s]
  float speed = 0;
  /// Maximum acceleration. [m/s^2 or rad/s^2]
  float acc = 0;

  friend bool operator==(const SpeedProfReq&, const SpeedProfReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, CmdVel& m);
void write(Writer& out, const CmdVel& m);
void to_json(std::string& out, const CmdVel& m);
void read(Reader& in, CmdPos& m);
void write(Writer& out, const CmdPos& m);
void to_json(std::string& out, const CmdPos& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, VelocityModeConfig& m);
void write(Writer& out, const VelocityModeConfig& m);
void to_json(std::string& out, const VelocityModeConfig& m);
void read(Reader& in, ResetOdomConfig& m);
void write(Writer& out, const ResetOdomConfig& m);
void to_json(std::string& out, const ResetOdomConfig& m);
void read(Reader& in, PositionModeReq& m);
void write(Writer& out, const PositionModeReq& m);
void to_json(std::string& out, const PositionModeReq& m);
void read(Reader& in, SetOdomReq& m);
void write(Writer& out, const SetOdomReq& m);
void to_json(std::string& out, const SetOdomReq& m);
void read(Reader& in, SpeedPidReq& m);
void write(Writer& out, const SpeedPidReq& m);
void to_json(std::string& out, const SpeedPidReq& m);
void read(Reader& in, PositionPidReq& m);
void write(Writer& out, const PositionPidReq& m);
void to_json(std::string& out, const PositionPidReq& m);
void read(Reader& in, SpeedProfReq& m);
void write(Writer& out, const SpeedProfReq& m);
void to_json(std::string& out, const SpeedProfReq& m);

}  // namespace playhouse::wire::position1d
