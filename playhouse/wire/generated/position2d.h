// Generated from interfaces/004_position2d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A robot that moves in the plane: odometry, velocity and position control.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::position2d {

inline constexpr std::uint16_t kCode = 4;

// Subtypes of messages.
/// Odometry.
inline constexpr std::uint8_t kDataState = 1;
/// The robot's size, sent on change.
inline constexpr std::uint8_t kDataGeom = 2;
/// Commanded velocity.
inline constexpr std::uint8_t kCmdVel = 1;
/// Commanded pose in the odometry frame.
inline constexpr std::uint8_t kCmdPos = 2;
/// Commanded speed and steering angle of a car.
inline constexpr std::uint8_t kCmdCar = 3;
/// Commanded speed and heading.
inline constexpr std::uint8_t kCmdVelHead = 4;
/// Requests the robot's size and centre of rotation.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Switches the motors on or off.
inline constexpr std::uint8_t kReqMotorPower = 2;
/// Selects the driver's velocity controller.
inline constexpr std::uint8_t kReqVelocityMode = 3;
/// Selects between velocity and position control.
inline constexpr std::uint8_t kReqPositionMode = 4;
/// Sets the odometric pose.
inline constexpr std::uint8_t kReqSetOdom = 5;
/// Sets the odometric pose to zero.
inline constexpr std::uint8_t kReqResetOdom = 6;
/// Sets the gains of velocity control.
inline constexpr std::uint8_t kReqSpeedPid = 7;
/// Sets the gains of position control.
inline constexpr std::uint8_t kReqPositionPid = 8;
/// Sets the speed and acceleration limits of position control.
inline constexpr std::uint8_t kReqSpeedProf = 9;

/// Odometry.
struct Data {
  /// Pose from odometry. [frame X_OR, m, m, rad]
  Pose2d pos{};
  /// Velocity: forward, to the left, turning left. [frame v_OR_R, m/s, m/s, rad/s]
  Pose2d vel{};
  /// 1 if the robot is blocked by an obstacle.
  std::uint8_t stall = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded velocity.
struct CmdVel {
  /// Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad.
  /// [frame v_OR_R, m/s, m/s, rad/s]
  Pose2d vel{};
  /// 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
  std::uint8_t state = 0;

  friend bool operator==(const CmdVel&, const CmdVel&) = default;
};

/// Commanded pose, and the velocity on the way.
struct CmdPos {
  /// Goal. [frame X_OG, m, m, rad]
  Pose2d pos{};
  /// Velocity on the way; zero: chosen by the driver. Simulated robots ignore it. [frame v_OR_R, m/s, m/s,
  /// rad/s]
  Pose2d vel{};
  /// 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
  std::uint8_t state = 0;

  friend bool operator==(const CmdPos&, const CmdPos&) = default;
};

/// Commanded motion of a car.
struct CmdCar {
  /// Forward. [m/s]
  double velocity = 0;
  /// Steering angle of the front wheels, positive to the left; a simulated robot without them uses it as turn
  /// rate in rad/s. [rad]
  double angle = 0;

  friend bool operator==(const CmdCar&, const CmdCar&) = default;
};

/// Commanded speed and heading.
struct CmdVelHead {
  /// Forward. [m/s]
  double velocity = 0;
  /// Heading in the odometry frame. [rad]
  double angle = 0;

  friend bool operator==(const CmdVelHead&, const CmdVelHead&) = default;
};

/// The robot's size and centre of rotation.
struct Geom {
  /// Centre of the bounding box relative to the centre of rotation. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Bounding box of the robot. [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// The motors' switch.
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

/// A control mode.
struct PositionModeReq {
  /// 0: velocity, 1: position.
  std::uint32_t state = 0;

  friend bool operator==(const PositionModeReq&, const PositionModeReq&) = default;
};

/// A new odometric pose.
struct SetOdomReq {
  /// New odometric pose. [frame X_OR, m, m, rad]
  Pose2d pose{};

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
  /// Maximum speed. [m/s]
  float speed = 0;
  /// Maximum acceleration. [m/s^2]
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
void read(Reader& in, CmdCar& m);
void write(Writer& out, const CmdCar& m);
void to_json(std::string& out, const CmdCar& m);
void read(Reader& in, CmdVelHead& m);
void write(Writer& out, const CmdVelHead& m);
void to_json(std::string& out, const CmdVelHead& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, VelocityModeConfig& m);
void write(Writer& out, const VelocityModeConfig& m);
void to_json(std::string& out, const VelocityModeConfig& m);
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

}  // namespace playhouse::wire::position2d
