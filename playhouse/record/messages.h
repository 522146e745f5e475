#pragma once

/// The messages of a recording: which schemas they have and how they are made. Those that ROS knows are
/// ROS's, so that its tools and Foxglove draw them; the others have names that begin with playhouse/msg/ and
/// are made from the lists of columns (world/columns.h), so that a new column or kind is recorded without
/// being named here. docs/recording.md lists them.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "playhouse/record/cdr.h"
#include "playhouse/record/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

inline constexpr const char* kSchemaEncoding = "ros2msg";
inline constexpr const char* kMessageEncoding = "cdr";

/// Names of schemas.
inline constexpr const char* kTransforms = "tf2_msgs/msg/TFMessage";
inline constexpr const char* kLaserScan = "sensor_msgs/msg/LaserScan";
inline constexpr const char* kImage = "sensor_msgs/msg/Image";
inline constexpr const char* kRanges = "playhouse/msg/Ranges";
inline constexpr const char* kWorldChange = "playhouse/msg/Change";
inline constexpr const char* kState = "playhouse/msg/State";
inline constexpr const char* kEdit = "playhouse/msg/Edit";
inline constexpr const char* kCheck = "playhouse/msg/Check";

/// The text of a schema of these names.
std::string schema_text(const std::string& name);

/// A frame in another: TransformStamped.
struct Transform {
  std::string parent, child;
  geom::SpatialPose X;
  friend bool operator==(const Transform&, const Transform&) = default;
};
Bytes transforms_message(std::uint64_t ns, std::span<const Transform> transforms);

/// What one sensor of a ranger measured last; `model` is its ranger.
Bytes scan_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                   world::ModelRow model, world::SensorRow sensor);
/// What all sensors of a ranger measured last.
Bytes ranges_message(std::uint64_t ns, const world::World& world, world::ModelRow model);

/// The newest image of a camera.
Bytes image_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                    world::ModelRow model);

/// What a table tells of a model's row.
struct TableMessages {
  std::string schema;  // name
  std::string topic;   // its last part
  std::string text;    // of the schema
  bool measures;       // and does nothing else: there is a new one with each measurement
  /// The model has a row in the table.
  bool (*has)(const world::World& world, world::ModelRow model);
  /// It measured in this very tick; of tables that measure.
  bool (*is_fresh)(const world::World& world, world::ModelRow model);
  Bytes (*message)(std::uint64_t ns, const world::World& world, world::ModelRow model);
};
/// Of all kinds but rangers, and of all traits.
const std::vector<TableMessages>& table_messages();

}  // namespace playhouse::record
