// Generated from interfaces/053_actarray.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A chain of prismatic or revolute joints, such as an arm.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::actarray {

inline constexpr std::uint16_t kCode = 53;

// Subtypes of messages.
/// State of each joint.
inline constexpr std::uint8_t kDataState = 1;
/// Commanded position of one joint.
inline constexpr std::uint8_t kCmdPos = 1;
/// Commanded positions of all joints.
inline constexpr std::uint8_t kCmdMultiPos = 2;
/// Commanded speed of one joint.
inline constexpr std::uint8_t kCmdSpeed = 3;
/// Commanded speeds of all joints.
inline constexpr std::uint8_t kCmdMultiSpeed = 4;
/// Moves one joint, or all, to the home position.
inline constexpr std::uint8_t kCmdHome = 5;
/// Commanded current of one joint.
inline constexpr std::uint8_t kCmdCurrent = 6;
/// Commanded currents of all joints.
inline constexpr std::uint8_t kCmdMultiCurrent = 7;
/// Switches the motors on or off.
inline constexpr std::uint8_t kReqPower = 1;
/// Sets or releases the brakes.
inline constexpr std::uint8_t kReqBrakes = 2;
/// Requests the joints and the base pose of the chain.
inline constexpr std::uint8_t kReqGetGeom = 3;
/// Sets a joint's speed in position control.
inline constexpr std::uint8_t kReqSpeed = 4;
/// Sets a joint's acceleration in position control.
inline constexpr std::uint8_t kReqAccel = 5;

/// Values of Actuator.state.
inline constexpr std::int32_t kActstateIdle = 1;
inline constexpr std::int32_t kActstateMoving = 2;
inline constexpr std::int32_t kActstateBraked = 4;
inline constexpr std::int32_t kActstateStalled = 8;

/// Values of Actuatorgeom.type.
inline constexpr std::int32_t kTypeLinear = 1;
inline constexpr std::int32_t kTypeRotary = 2;

/// State of one joint.
struct Actuator {
  /// [m or rad]
  float position = 0;
  /// [m/s or rad/s]
  float speed = 0;
  /// [m/s^2 or rad/s^2]
  float acceleration = 0;
  /// Of its motor; -1 if unknown. [A]
  float current = 0;
  /// Idle, moving, braked or stalled.
  std::uint8_t state = 0;

  friend bool operator==(const Actuator&, const Actuator&) = default;
};

/// State of each joint.
struct Data {
  std::vector<Actuator> actuators{};
  /// 1: motors on, 0: off.
  std::uint8_t motor_state = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Description of a joint.
struct Actuatorgeom {
  /// Prismatic or revolute.
  std::uint8_t type = 0;
  /// To the next joint. [m]
  float length = 0;
  /// Orientation of the joint at rest, relative to the previous joint. [frame R_BJ, rad, rad, rad]
  Orientation3d orientation{};
  /// Unit vector of the axis of translation or rotation. [frame n_J, 1]
  Point3d axis{};
  /// Lowest position. [m or rad]
  float min = 0;
  /// Centre position. [m or rad]
  float centre = 0;
  /// Highest position. [m or rad]
  float max = 0;
  /// Position after CMD HOME. [m or rad]
  float home = 0;
  /// Speed in position control. [m/s or rad/s]
  float config_speed = 0;
  /// 1 if it has brakes.
  std::uint8_t hasbrakes = 0;

  friend bool operator==(const Actuatorgeom&, const Actuatorgeom&) = default;
};

/// Joints and base pose of the chain.
struct Geom {
  std::vector<Actuatorgeom> actuators{};
  /// Position of the base of the chain on the robot. [frame p_RB, m]
  Point3d base_pos{};
  /// Orientation of the base of the chain on the robot. [frame R_RB, rad]
  Orientation3d base_orientation{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// Commanded position of one joint.
struct PositionCmd {
  /// Index of the joint, from 0.
  std::int32_t joint = 0;
  /// [m or rad]
  float position = 0;

  friend bool operator==(const PositionCmd&, const PositionCmd&) = default;
};

/// Commanded positions of all joints.
struct MultiPositionCmd {
  /// [m or rad]
  std::vector<float> positions{};

  friend bool operator==(const MultiPositionCmd&, const MultiPositionCmd&) = default;
};

/// Commanded speed of one joint.
struct SpeedCmd {
  /// Index of the joint, from 0.
  std::int32_t joint = 0;
  /// [m/s or rad/s]
  float speed = 0;

  friend bool operator==(const SpeedCmd&, const SpeedCmd&) = default;
};

/// Commanded speeds of all joints.
struct MultiSpeedCmd {
  /// [m/s or rad/s]
  std::vector<float> speeds{};

  friend bool operator==(const MultiSpeedCmd&, const MultiSpeedCmd&) = default;
};

/// A joint to move to its home position.
struct HomeCmd {
  /// Index of the joint; -1: all.
  std::int32_t joint = 0;

  friend bool operator==(const HomeCmd&, const HomeCmd&) = default;
};

/// Commanded current of one joint.
struct CurrentCmd {
  /// Index of the joint, from 0.
  std::int32_t joint = 0;
  /// [A]
  float current = 0;

  friend bool operator==(const CurrentCmd&, const CurrentCmd&) = default;
};

/// Commanded currents of all joints.
struct MultiCurrentCmd {
  /// [A]
  std::vector<float> currents{};

  friend bool operator==(const MultiCurrentCmd&, const MultiCurrentCmd&) = default;
};

/// The motors' switch.
struct PowerConfig {
  /// 1: on, 0: off.
  std::uint8_t value = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// The brakes' switch.
struct BrakesConfig {
  /// 1: braked, 0: released.
  std::uint8_t value = 0;

  friend bool operator==(const BrakesConfig&, const BrakesConfig&) = default;
};

/// Speed of one joint.
struct SpeedConfig {
  /// Index of the joint; -1: all.
  std::int32_t joint = 0;
  /// [m/s or rad/s]
  float speed = 0;

  friend bool operator==(const SpeedConfig&, const SpeedConfig&) = default;
};

/// Acceleration of one joint.
struct AccelConfig {
  /// Index of the joint; -1: all.
  std::int32_t joint = 0;
  /// [m/s^2 or rad/s^2]
  float accel = 0;

  friend bool operator==(const AccelConfig&, const AccelConfig&) = default;
};

void read(Reader& in, Actuator& m);
void write(Writer& out, const Actuator& m);
void to_json(std::string& out, const Actuator& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Actuatorgeom& m);
void write(Writer& out, const Actuatorgeom& m);
void to_json(std::string& out, const Actuatorgeom& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, PositionCmd& m);
void write(Writer& out, const PositionCmd& m);
void to_json(std::string& out, const PositionCmd& m);
void read(Reader& in, MultiPositionCmd& m);
void write(Writer& out, const MultiPositionCmd& m);
void to_json(std::string& out, const MultiPositionCmd& m);
void read(Reader& in, SpeedCmd& m);
void write(Writer& out, const SpeedCmd& m);
void to_json(std::string& out, const SpeedCmd& m);
void read(Reader& in, MultiSpeedCmd& m);
void write(Writer& out, const MultiSpeedCmd& m);
void to_json(std::string& out, const MultiSpeedCmd& m);
void read(Reader& in, HomeCmd& m);
void write(Writer& out, const HomeCmd& m);
void to_json(std::string& out, const HomeCmd& m);
void read(Reader& in, CurrentCmd& m);
void write(Writer& out, const CurrentCmd& m);
void to_json(std::string& out, const CurrentCmd& m);
void read(Reader& in, MultiCurrentCmd& m);
void write(Writer& out, const MultiCurrentCmd& m);
void to_json(std::string& out, const MultiCurrentCmd& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, BrakesConfig& m);
void write(Writer& out, const BrakesConfig& m);
void to_json(std::string& out, const BrakesConfig& m);
void read(Reader& in, SpeedConfig& m);
void write(Writer& out, const SpeedConfig& m);
void to_json(std::string& out, const SpeedConfig& m);
void read(Reader& in, AccelConfig& m);
void write(Writer& out, const AccelConfig& m);
void to_json(std::string& out, const AccelConfig& m);

}  // namespace playhouse::wire::actarray
