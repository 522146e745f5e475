// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// What the table of kinds tells of each, under the names that kinds/*.toml has.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace playhouse::scene {

/// Where an entity stands.
enum class EntityForm : std::uint8_t {
  /// at the top level, or inside another model
  kModel,
  /// inside a model of the type `inside`; of any, where that is "model"
  kPart,
  /// nowhere: words of a model of any type give it one
  kTrait,
  /// at the top level
  kWindow,
  /// it is the file
  kWorld,
};
constexpr std::string_view name_of(EntityForm value) {
  constexpr std::string_view kNames[] = {"model", "part", "trait", "window", "world"};
  return kNames[static_cast<std::size_t>(value)];
}

/// How the indices of an interface count in the automatic map.
enum class Index : std::uint8_t {
  /// 0, there is one
  kOne,
  /// that of the robot; of further ones, and where no robot carries it, from behind all robots on
  kRobot,
  /// all are counted, over all robots
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
  /// a model at the top level that drives
  kRobot,
  /// a sensor with several rings
  kRings,
};
constexpr std::string_view name_of(Need value) {
  constexpr std::string_view kNames[] = {"", "scanner", "several sensors", "robot", "rings"};
  return kNames[static_cast<std::size_t>(value)];
}

}  // namespace playhouse::scene
