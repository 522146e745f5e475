// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Properties of kinds, with the names of kinds/*.toml.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace playhouse::scene {

/// Place of an entity in a file.
enum class EntityForm : std::uint8_t {
  /// at the top level, or inside another model
  kModel,
  /// inside a model of the type `inside`, or of any type if that is "model"
  kPart,
  /// none: words of a model of any type define it
  kTrait,
  /// at the top level
  kWindow,
  /// the file itself
  kWorld,
};
constexpr std::string_view name_of(EntityForm value) {
  constexpr std::string_view kNames[] = {"model", "part", "trait", "window", "world"};
  return kNames[static_cast<std::size_t>(value)];
}

/// Numbering of the devices of an interface in the automatic map.
enum class Index : std::uint8_t {
  /// 0, the only one
  kOne,
  /// the robot's index; further ones, and those without a robot, are numbered after all robots
  kRobot,
  /// numbered over all robots
  kCount,
};
constexpr std::string_view name_of(Index value) {
  constexpr std::string_view kNames[] = {"one", "robot", "count"};
  return kNames[static_cast<std::size_t>(value)];
}

/// What a model must have for an interface.
enum class Need : std::uint8_t {
  /// nothing
  kNothing,
  /// a sensor with several samples
  kScanner,
  /// several sensors
  kSeveralSensors,
  /// a top-level model with a drive
  kRobot,
  /// a sensor with several rings
  kRings,
  /// a section of a configuration file that names it
  kNever,
};
constexpr std::string_view name_of(Need value) {
  constexpr std::string_view kNames[] = {"", "scanner", "several sensors", "robot", "rings", "never"};
  return kNames[static_cast<std::size_t>(value)];
}

}  // namespace playhouse::scene
