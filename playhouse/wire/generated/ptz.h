// Generated from interfaces/008_ptz.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ptz {

inline constexpr std::uint16_t kCode = 8;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kDataGeom = 2;
inline constexpr std::uint8_t kCmdState = 1;
inline constexpr std::uint8_t kReqGeneric = 1;
inline constexpr std::uint8_t kReqControlMode = 2;
inline constexpr std::uint8_t kReqGeom = 4;
inline constexpr std::uint8_t kReqStatus = 5;

inline constexpr std::int32_t kVelocityControl = 0;
inline constexpr std::int32_t kPositionControl = 1;

struct Data {
  /// [rad]
  float pan = 0;
  /// [rad]
  float tilt = 0;
  /// [rad]
  float zoom = 0;
  /// [rad/s]
  float panspeed = 0;
  /// [rad/s]
  float tiltspeed = 0;
  std::uint32_t status = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  /// [rad]
  float pan = 0;
  /// [rad]
  float tilt = 0;
  /// [rad]
  float zoom = 0;
  /// [rad/s]
  float panspeed = 0;
  /// [rad/s]
  float tiltspeed = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

struct ReqStatus {
  std::uint32_t status = 0;

  friend bool operator==(const ReqStatus&, const ReqStatus&) = default;
};

struct Geom {
  /// [frame X_RS]
  Pose3d pos{};
  /// [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct ReqGeneric {
  std::vector<std::uint32_t> config{};

  friend bool operator==(const ReqGeneric&, const ReqGeneric&) = default;
};

struct ReqControlMode {
  std::uint32_t mode = 0;

  friend bool operator==(const ReqControlMode&, const ReqControlMode&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, ReqStatus& m);
void write(Writer& out, const ReqStatus& m);
void to_json(std::string& out, const ReqStatus& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, ReqGeneric& m);
void write(Writer& out, const ReqGeneric& m);
void to_json(std::string& out, const ReqGeneric& m);
void read(Reader& in, ReqControlMode& m);
void write(Writer& out, const ReqControlMode& m);
void to_json(std::string& out, const ReqControlMode& m);

}  // namespace playhouse::wire::ptz
