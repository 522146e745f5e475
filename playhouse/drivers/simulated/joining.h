#pragma once

/// What a robot that joins a running world is made of: a type, a place, and sensors that it carries. A type
/// is the word of a define that the world file lists in robot_types, or the name of a model, which is copied.
/// Thread: the tick thread, between steps.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/values.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Of the wire, docs/robot-client.md.
struct JoinRequest {
  struct Sensor {
    std::string type;
    std::optional<geom::Pose> X_RS;  // in the robot; z counts from its top. None: as the type says.
  };
  std::string type;
  geom::Pose X_WR;    // z is the type's
  std::string name;   // "": the type's, or one like it
  std::string color;  // of X11; "": the type's
  std::vector<Sensor> sensors;
};

/// Reads what a client says. Fails with a text for it.
Result<JoinRequest> parse_join_request(std::string_view type, std::string_view value);

/// A robot in the world, and what was attached to it.
struct Joined {
  world::ModelId robot;
  std::string name;
  std::vector<world::ModelId> sensors;
};

/// All of it comes, or nothing. Fails with a text for the person who asked: an unknown type, a name that is
/// taken, a place where something stands, a full world.
Result<Joined> join(world::World& world, const JoinRequest& request);

/// What of it is still there goes.
void leave(world::World& world, const Joined& joined);

/// Whether a tree of the prototype whose top is at this row of SceneDesc::models, at X_WM, meets nothing
/// solid.
bool is_free(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM);

}  // namespace playhouse::drivers
