// Generated from interfaces/008_ptz.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A camera mount that pans, tilts and zooms.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ptz {

inline constexpr std::uint16_t kCode = 8;

// Subtypes of messages.
/// Direction of the mount.
inline constexpr std::uint8_t kDataState = 1;
/// Size and pose, sent on change.
inline constexpr std::uint8_t kDataGeom = 2;
/// Commanded direction of the mount.
inline constexpr std::uint8_t kCmdState = 1;
/// Exchanges driver-specific words with the mount.
inline constexpr std::uint8_t kReqGeneric = 1;
/// Selects between velocity and position control.
inline constexpr std::uint8_t kReqControlMode = 2;
/// Requests size and pose.
inline constexpr std::uint8_t kReqGeom = 4;
/// Requests the mount's status.
inline constexpr std::uint8_t kReqStatus = 5;

/// Values of ReqControlMode.mode.
inline constexpr std::int32_t kVelocityControl = 0;
inline constexpr std::int32_t kPositionControl = 1;

/// Direction of the mount.
struct Data {
  /// Positive to the left. [rad]
  float pan = 0;
  /// Positive upwards. [rad]
  float tilt = 0;
  /// Field of view. [rad]
  float zoom = 0;
  /// Positive to the left. [rad/s]
  float panspeed = 0;
  /// Positive upwards. [rad/s]
  float tiltspeed = 0;
  /// Driver-specific.
  std::uint32_t status = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded direction or velocity of the mount.
struct Cmd {
  /// Positive to the left. [rad]
  float pan = 0;
  /// Positive upwards. [rad]
  float tilt = 0;
  /// Field of view. [rad]
  float zoom = 0;
  /// Used by velocity control. [rad/s]
  float panspeed = 0;
  /// Used by velocity control. [rad/s]
  float tiltspeed = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

/// The mount's status.
struct ReqStatus {
  /// Driver-specific.
  std::uint32_t status = 0;

  friend bool operator==(const ReqStatus&, const ReqStatus&) = default;
};

/// The mount's size and pose.
struct Geom {
  /// Pose of the mount on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pos{};
  /// Bounding box of the mount. [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// Driver-specific words.
struct ReqGeneric {
  /// Driver-specific.
  std::vector<std::uint32_t> config{};

  friend bool operator==(const ReqGeneric&, const ReqGeneric&) = default;
};

/// A control mode.
struct ReqControlMode {
  /// Velocity or position.
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
