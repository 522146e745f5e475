#pragma once

/// Spawning of client robots: a type, a pose, and sensors to attach. A
/// type is a define listed in the world file's robot_types, or the name
/// of a model, which is copied. Thread: the tick thread, between steps.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/text/values.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Wire format: docs/robot-client.md.
struct RobotRequest {
  struct SensorRequest {
    std::string type;
    std::optional<geom::Pose> X_RS;  // in the robot; z counts from its top. None: from the type.
  };
  std::string type;
  geom::Pose X_WR;    // z is from the type
  std::string name;   // "": that of the type, or one derived from it
  std::string color;  // X11 name; "": that of the type
  std::vector<SensorRequest> sensors;
};

/// Parses a client's request. Fails with a message for the client.
Result<RobotRequest> parse_join_request(std::string_view type, std::string_view value);

/// A spawned robot and its attached sensors.
struct Joined {
  world::ModelId robot;
  std::string name;
  std::vector<world::ModelId> sensors;
};

/// The descriptions of the robot and of its sensors, before they are spawned. Fails as join().
Result<std::vector<std::uint32_t>> types_of(const world::World& world, const RobotRequest& request);

/// Atomic. Fails with a message for the client: unknown
/// type, name in use, place occupied, world full.
Result<Joined> join(world::Journal& journal, const RobotRequest& request);

/// Removes robots and their sensors as far as they still exist, at the cost of one.
void leave(world::Journal& journal, std::span<const Joined> joined);

/// True if a tree of the prototype whose root is at this
/// row of SceneDesc::models would hit no obstacle at X_WM.
bool is_free(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM);

/// Fails if nothing in the world is within 1 km of the place, with a message for who asks for it.
Result<void> check_near(const world::World& world, const geom::Pose& X_WM);

/// X_WM if it is free, else the nearest free place, to 5 cm, within 2 m. Fails with a message for who
/// joins: nothing is free there, or check_near() does.
Result<geom::Pose> free_place(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM);

}  // namespace playhouse::drivers
