// Generated from interfaces/031_simulation.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A simulator: reads and moves its models, pauses and resets it.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::simulation {

inline constexpr std::uint16_t kCode = 31;

// Subtypes of messages.
/// Stops the simulated clock, or lets it go on.
inline constexpr std::uint8_t kCmdPause = 1;
/// Puts everything back to the start.
inline constexpr std::uint8_t kCmdReset = 2;
/// Saves the world as it stands.
inline constexpr std::uint8_t kCmdSave = 3;
/// Asks for the pose of a model by name.
inline constexpr std::uint8_t kReqGetPose2d = 1;
/// Moves a model by name.
inline constexpr std::uint8_t kReqSetPose2d = 2;
/// Asks for the pose of a model by name, and the time.
inline constexpr std::uint8_t kReqGetPose3d = 3;
/// Moves a model by name.
inline constexpr std::uint8_t kReqSetPose3d = 4;
/// Asks for a property of a model by name; without a name, for "models", the list of all with their devices
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
  /// Of the model, with its final NUL.
  std::string name{};
  /// Of the model in its parent, which is the world for a model that nothing carries; ignored in a question.
  /// [frame X_PT, m, m, rad]
  Pose2d pose{};

  friend bool operator==(const Pose2dReq&, const Pose2dReq&) = default;
};

/// A model, its pose and the time.
struct Pose3dReq {
  /// Of the model, with its final NUL.
  std::string name{};
  /// Of the model in its parent, which is the world for a model that nothing carries; ignored in a question.
  /// [frame X_PT, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Simulated time at which the pose held, as Stage counts it; only answers fill it in. [us]
  double simtime = 0;

  friend bool operator==(const Pose3dReq&, const Pose3dReq&) = default;
};

/// A property of a model.
struct PropertyReq {
  /// Of the model, with its final NUL; empty for a property of the whole world.
  std::string name{};
  /// Name of the property, with its final NUL.
  std::string prop{};
  /// Which element, if the property is a list: the first that is wanted; in an answer the one to ask from
  /// next, 0 when there are no more.
  std::uint32_t index = 0;
  /// The property's bytes, in a form given by the simulator; empty in a question.
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
