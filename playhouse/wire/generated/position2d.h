// Generated from interfaces/004_position2d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A robot that moves in a plane: wheels, odometry, velocity and position control.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::position2d {

inline constexpr std::uint16_t kCode = 4;

// Subtypes of messages.
/// Odometry.
inline constexpr std::uint8_t kDataState = 1;
/// The robot's size, sent when it changes.
inline constexpr std::uint8_t kDataGeom = 2;
/// Wanted velocity.
inline constexpr std::uint8_t kCmdVel = 1;
/// Wanted pose in the odometry frame.
inline constexpr std::uint8_t kCmdPos = 2;
/// Wanted speed and steering angle of a car.
inline constexpr std::uint8_t kCmdCar = 3;
/// Wanted speed and heading.
inline constexpr std::uint8_t kCmdVelHead = 4;
/// Asks for the robot's size and centre of turning.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Switches the motors on or off.
inline constexpr std::uint8_t kReqMotorPower = 2;
/// Chooses how the driver controls velocity.
inline constexpr std::uint8_t kReqVelocityMode = 3;
/// Chooses between velocity and position control.
inline constexpr std::uint8_t kReqPositionMode = 4;
/// Sets the odometric pose.
inline constexpr std::uint8_t kReqSetOdom = 5;
/// Sets the odometric pose to zero.
inline constexpr std::uint8_t kReqResetOdom = 6;
/// Sets the gains of velocity control.
inline constexpr std::uint8_t kReqSpeedPid = 7;
/// Sets the gains of position control.
inline constexpr std::uint8_t kReqPositionPid = 8;
/// Sets the speed and acceleration that position control uses.
inline constexpr std::uint8_t kReqSpeedProf = 9;

/// Odometry.
struct Data {
  /// Pose from odometry. [frame X_OR, m, m, rad]
  Pose2d pos{};
  /// Velocity: forward, to the left, turning left. [frame v_OR_R, m/s, m/s, rad/s]
  Pose2d vel{};
  /// 1 if the robot is pushing against something that does not give way.
  std::uint8_t stall = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Wanted velocity.
struct CmdVel {
  /// Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad.
  /// [frame v_OR_R, m/s, m/s, rad/s]
  Pose2d vel{};
  /// 1 motors on, 0 off, if the driver cares; simulated robots do not: MOTOR_POWER is their switch.
  std::uint8_t state = 0;

  friend bool operator==(const CmdVel&, const CmdVel&) = default;
};

/// Wanted pose and the velocity to get there with.
struct CmdPos {
  /// Goal. [frame X_OG, m, m, rad]
  Pose2d pos{};
  /// Velocity on the way; zero leaves it to the driver, as simulated robots always do. [frame v_OR_R, m/s,
  /// m/s, rad/s]
  Pose2d vel{};
  /// 1 motors on, 0 off, if the driver cares; simulated robots do not: MOTOR_POWER is their switch.
  std::uint8_t state = 0;

  friend bool operator==(const CmdPos&, const CmdPos&) = default;
};

/// Wanted motion of a car.
struct CmdCar {
  /// Forward. [m/s]
  double velocity = 0;
  /// Of the front wheels, positive steers left; a simulated robot without them takes it as its turning rate
  /// in rad/s. [rad]
  double angle = 0;

  friend bool operator==(const CmdCar&, const CmdCar&) = default;
};

/// Wanted speed and heading.
struct CmdVelHead {
  /// Forward. [m/s]
  double velocity = 0;
  /// Heading in the odometry frame. [rad]
  double angle = 0;

  friend bool operator==(const CmdVelHead&, const CmdVelHead&) = default;
};

/// The robot's size and where its centre of turning is.
struct Geom {
  /// Of the box's middle from the centre of turning. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Of a box around the robot. [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// The motors' switch.
struct PowerConfig {
  /// 1 on, 0 off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// A mode of velocity control.
struct VelocityModeConfig {
  /// Meaning given by the driver.
  std::uint32_t value = 0;

  friend bool operator==(const VelocityModeConfig&, const VelocityModeConfig&) = default;
};

/// A mode of control.
struct PositionModeReq {
  /// 0 velocity, 1 position.
  std::uint32_t state = 0;

  friend bool operator==(const PositionModeReq&, const PositionModeReq&) = default;
};

/// A new odometric pose.
struct SetOdomReq {
  /// What odometry shall say now. [frame X_OR, m, m, rad]
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

/// Motion that position control may use.
struct SpeedProfReq {
  /// Largest speed. [m/s]
  float speed = 0;
  /// Largest acceleration. [m/s^2]
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
