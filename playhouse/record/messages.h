#pragma once

/// Messages of a recording: schemas and serialisation. Standard ROS messages where
/// they exist, so that ROS tools and Foxglove display them; others are named
/// playhouse/msg/* and generated from the column lists (world/columns.h), so that new
/// columns and kinds are recorded without changes here. docs/recording.md lists them.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "playhouse/record/cdr.h"
#include "playhouse/record/mcap/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

inline constexpr const char* kSchemaEncoding = "ros2msg";
inline constexpr const char* kMessageEncoding = "cdr";

/// Names of schemas.
inline constexpr const char* kTransforms = "tf2_msgs/msg/TFMessage";
inline constexpr const char* kLaserScan = "sensor_msgs/msg/LaserScan";
inline constexpr const char* kImage = "sensor_msgs/msg/Image";
inline constexpr const char* kCameraInfo = "sensor_msgs/msg/CameraInfo";
inline constexpr const char* kPointCloud = "sensor_msgs/msg/PointCloud2";
inline constexpr const char* kImu = "sensor_msgs/msg/Imu";
inline constexpr const char* kFix = "sensor_msgs/msg/NavSatFix";
inline constexpr const char* kOdometry = "nav_msgs/msg/Odometry";
inline constexpr const char* kRanges = "playhouse/msg/Ranges";
inline constexpr const char* kEvent = "playhouse/msg/Event";
inline constexpr const char* kSpeech = "playhouse/msg/Speech";
inline constexpr const char* kState = "playhouse/msg/State";
inline constexpr const char* kChange = "playhouse/msg/JournalEntry";
inline constexpr const char* kCheck = "playhouse/msg/Check";

/// The definition of one of these schemas.
std::string schema_text(const std::string& name);

/// A TransformStamped: pose of a child frame in its parent.
/// A std_msgs/Header.
void put_header(CdrWriter& out, std::uint64_t ns, const std::string& frame);

struct Transform {
  std::string parent, child;
  geom::SpatialPose X;
  friend bool operator==(const Transform&, const Transform&) = default;
};
Bytes transforms_message(std::uint64_t ns, std::span<const Transform> transforms);

/// True of a scanner whose last beam points where its first one does, which consumers of ROS do not expect.
bool repeats_first_beam(const scene::RangerSensorDesc& sensor);
/// The latest measurement of one sensor, as REP 117 has it: +infinity where nothing returned,
/// -infinity where what did is too near. Of a full circle without the last beam. `model` is its ranger.
Bytes scan_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                   world::ModelRow model, world::SensorRow sensor);
/// The latest measurements of all sensors of a ranger, with infinities as in scans.
Bytes ranges_message(std::uint64_t ns, const world::World& world, world::ModelRow model);

/// The latest image of a camera. Depths are in millimetres, 0: no depth (REP 118).
Bytes image_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                    world::ModelRow model);

/// Messages of one table: one per model with a row in it.
struct TableMessages {
  std::string schema;  // name
  std::string topic;   // last part of the topic
  std::string text;    // the schema
  bool measures;       // a sensor table: a message per measurement
  /// True if the model has a row in the table.
  bool (*has)(const world::World& world, world::ModelRow model);
  /// True if it measured in this very tick; sensor tables only.
  bool (*is_fresh)(const world::World& world, world::ModelRow model);
  Bytes (*message)(std::uint64_t ns, const world::World& world, world::ModelRow model);
};
/// For all kinds except rangers, and all traits.
const std::vector<TableMessages>& table_messages();

}  // namespace playhouse::record
