// Generated from interfaces/053_actarray.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::actarray {

inline constexpr std::uint16_t kCode = 53;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdPos = 1;
inline constexpr std::uint8_t kCmdMultiPos = 2;
inline constexpr std::uint8_t kCmdSpeed = 3;
inline constexpr std::uint8_t kCmdMultiSpeed = 4;
inline constexpr std::uint8_t kCmdHome = 5;
inline constexpr std::uint8_t kCmdCurrent = 6;
inline constexpr std::uint8_t kCmdMultiCurrent = 7;
inline constexpr std::uint8_t kReqPower = 1;
inline constexpr std::uint8_t kReqBrakes = 2;
inline constexpr std::uint8_t kReqGetGeom = 3;
inline constexpr std::uint8_t kReqSpeed = 4;
inline constexpr std::uint8_t kReqAccel = 5;

inline constexpr std::int32_t kActstateIdle = 1;
inline constexpr std::int32_t kActstateMoving = 2;
inline constexpr std::int32_t kActstateBraked = 4;
inline constexpr std::int32_t kActstateStalled = 8;
inline constexpr std::int32_t kTypeLinear = 1;
inline constexpr std::int32_t kTypeRotary = 2;

struct Actuator {
  /// [m|rad]
  float position = 0;
  /// [m/s|rad/s]
  float speed = 0;
  /// [m/s^2|rad/s^2]
  float acceleration = 0;
  /// [A]
  float current = 0;
  std::uint8_t state = 0;

  friend bool operator==(const Actuator&, const Actuator&) = default;
};

struct Data {
  std::vector<Actuator> actuators{};
  std::uint8_t motor_state = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Actuatorgeom {
  std::uint8_t type = 0;
  /// [m]
  float length = 0;
  /// [frame R_WR, rad, rad, rad]
  Orientation3d orientation{};
  /// [frame p_WP]
  Point3d axis{};
  /// [m|rad]
  float min = 0;
  /// [m|rad]
  float centre = 0;
  /// [m|rad]
  float max = 0;
  /// [m|rad]
  float home = 0;
  /// [m/s|rad/s]
  float config_speed = 0;
  std::uint8_t hasbrakes = 0;

  friend bool operator==(const Actuatorgeom&, const Actuatorgeom&) = default;
};

struct Geom {
  std::vector<Actuatorgeom> actuators{};
  /// [frame p_WP]
  Point3d base_pos{};
  /// [frame R_WR]
  Orientation3d base_orientation{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct PositionCmd {
  std::int32_t joint = 0;
  /// [1]
  float position = 0;

  friend bool operator==(const PositionCmd&, const PositionCmd&) = default;
};

struct MultiPositionCmd {
  /// [1]
  std::vector<float> positions{};

  friend bool operator==(const MultiPositionCmd&, const MultiPositionCmd&) = default;
};

struct SpeedCmd {
  std::int32_t joint = 0;
  /// [1]
  float speed = 0;

  friend bool operator==(const SpeedCmd&, const SpeedCmd&) = default;
};

struct MultiSpeedCmd {
  /// [1]
  std::vector<float> speeds{};

  friend bool operator==(const MultiSpeedCmd&, const MultiSpeedCmd&) = default;
};

struct HomeCmd {
  std::int32_t joint = 0;

  friend bool operator==(const HomeCmd&, const HomeCmd&) = default;
};

struct CurrentCmd {
  std::int32_t joint = 0;
  /// [1]
  float current = 0;

  friend bool operator==(const CurrentCmd&, const CurrentCmd&) = default;
};

struct MultiCurrentCmd {
  /// [1]
  std::vector<float> currents{};

  friend bool operator==(const MultiCurrentCmd&, const MultiCurrentCmd&) = default;
};

struct PowerConfig {
  std::uint8_t value = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

struct BrakesConfig {
  std::uint8_t value = 0;

  friend bool operator==(const BrakesConfig&, const BrakesConfig&) = default;
};

struct SpeedConfig {
  std::int32_t joint = 0;
  /// [m/s|rad/s]
  float speed = 0;

  friend bool operator==(const SpeedConfig&, const SpeedConfig&) = default;
};

struct AccelConfig {
  std::int32_t joint = 0;
  /// [m/s^2|rad/s^2]
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
