// Generated from interfaces/004_position2d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::position2d {

inline constexpr std::uint16_t kCode = 4;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kDataGeom = 2;
inline constexpr std::uint8_t kCmdVel = 1;
inline constexpr std::uint8_t kCmdPos = 2;
inline constexpr std::uint8_t kCmdCar = 3;
inline constexpr std::uint8_t kCmdVelHead = 4;
inline constexpr std::uint8_t kReqGetGeom = 1;
inline constexpr std::uint8_t kReqMotorPower = 2;
inline constexpr std::uint8_t kReqVelocityMode = 3;
inline constexpr std::uint8_t kReqPositionMode = 4;
inline constexpr std::uint8_t kReqSetOdom = 5;
inline constexpr std::uint8_t kReqResetOdom = 6;
inline constexpr std::uint8_t kReqSpeedPid = 7;
inline constexpr std::uint8_t kReqPositionPid = 8;
inline constexpr std::uint8_t kReqSpeedProf = 9;

struct Data {
  /// [frame X_RS, m, m, rad]
  Pose2d pos{};
  /// [frame X_RS, m/s, m/s, rad/s]
  Pose2d vel{};
  std::uint8_t stall = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct CmdVel {
  /// [frame X_RS, m/s, m/s, rad/s]
  Pose2d vel{};
  std::uint8_t state = 0;

  friend bool operator==(const CmdVel&, const CmdVel&) = default;
};

struct CmdPos {
  /// [frame X_RS, m, m, rad]
  Pose2d pos{};
  /// [frame X_RS, m/s, m/s, rad/s]
  Pose2d vel{};
  std::uint8_t state = 0;

  friend bool operator==(const CmdPos&, const CmdPos&) = default;
};

struct CmdCar {
  /// [m/s]
  double velocity = 0;
  /// [rad]
  double angle = 0;

  friend bool operator==(const CmdCar&, const CmdCar&) = default;
};

struct CmdVelHead {
  /// [m/s]
  double velocity = 0;
  /// [rad]
  double angle = 0;

  friend bool operator==(const CmdVelHead&, const CmdVelHead&) = default;
};

struct Geom {
  /// [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct PowerConfig {
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

struct VelocityModeConfig {
  std::uint32_t value = 0;

  friend bool operator==(const VelocityModeConfig&, const VelocityModeConfig&) = default;
};

struct PositionModeReq {
  std::uint32_t state = 0;

  friend bool operator==(const PositionModeReq&, const PositionModeReq&) = default;
};

struct SetOdomReq {
  /// [frame X_RS, m, m, rad]
  Pose2d pose{};

  friend bool operator==(const SetOdomReq&, const SetOdomReq&) = default;
};

struct SpeedPidReq {
  /// [1]
  float kp = 0;
  /// [1]
  float ki = 0;
  /// [1]
  float kd = 0;

  friend bool operator==(const SpeedPidReq&, const SpeedPidReq&) = default;
};

struct PositionPidReq {
  /// [1]
  float kp = 0;
  /// [1]
  float ki = 0;
  /// [1]
  float kd = 0;

  friend bool operator==(const PositionPidReq&, const PositionPidReq&) = default;
};

struct SpeedProfReq {
  /// [m/s]
  float speed = 0;
  /// [m/s^2]
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
