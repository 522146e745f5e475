// Generated from interfaces/031_simulation.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A simulator: reads and moves its models, pauses and resets it.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::simulation {

inline constexpr std::uint16_t kCode = 31;

// Subtypes of messages.
/// Pauses or resumes the simulated clock.
inline constexpr std::uint8_t kCmdPause = 1;
/// Resets the world to its start.
inline constexpr std::uint8_t kCmdReset = 2;
/// Saves the current world.
inline constexpr std::uint8_t kCmdSave = 3;
/// Requests the pose of a model by name.
inline constexpr std::uint8_t kReqGetPose2d = 1;
/// Moves a model by name.
inline constexpr std::uint8_t kReqSetPose2d = 2;
/// Requests the pose of a model by name, and the time.
inline constexpr std::uint8_t kReqGetPose3d = 3;
/// Moves a model by name.
inline constexpr std::uint8_t kReqSetPose3d = 4;
/// Requests a property of a model by name; without a name, for "models", the list of all with their devices
/// (docs/drivers.md).
inline constexpr std::uint8_t kReqGetProperty = 5;
/// Sets a property of a model by name.
inline constexpr std::uint8_t kReqSetProperty = 6;

/// Not sent by any message.
struct Data {
  /// Without meaning.
  std::uint8_t data = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Not sent by any message.
struct Cmd {
  /// Without meaning.
  std::uint8_t cmd = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

/// A model and its pose.
struct Pose2dReq {
  /// Of the model, NUL-terminated.
  std::string name{};
  /// Pose of the model in its parent (the world for a top-level model); ignored in a request. [frame X_PT, m,
  /// m, rad]
  Pose2d pose{};

  friend bool operator==(const Pose2dReq&, const Pose2dReq&) = default;
};

/// A model, its pose and the time.
struct Pose3dReq {
  /// Of the model, NUL-terminated.
  std::string name{};
  /// Pose of the model in its parent (the world for a top-level model); ignored in a request. [frame X_PT, m,
  /// m, m, rad, rad, rad]
  Pose3d pose{};
  /// Simulated time of the pose, as counted by Stage; set in answers only. [us]
  double simtime = 0;

  friend bool operator==(const Pose3dReq&, const Pose3dReq&) = default;
};

/// A property of a model.
struct PropertyReq {
  /// Name of the model, NUL-terminated; empty for a property of the world.
  std::string name{};
  /// Name of the property, NUL-terminated.
  std::string prop{};
  /// Element of a list property: in a request the first one requested, in an answer the first of the next
  /// request, 0 at the end of the list.
  std::uint32_t index = 0;
  /// Bytes of the property, in a simulator-specific format; empty in a request.
  std::string value{};

  friend bool operator==(const PropertyReq&, const PropertyReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, Pose2dReq& m);
void write(Writer& out, const Pose2dReq& m);
void to_json(std::string& out, const Pose2dReq& m);
void read(Reader& in, Pose3dReq& m);
void write(Writer& out, const Pose3dReq& m);
void to_json(std::string& out, const Pose3dReq& m);
void read(Reader& in, PropertyReq& m);
void write(Writer& out, const PropertyReq& m);
void to_json(std::string& out, const PropertyReq& m);

}  // namespace playhouse::wire::simulation
