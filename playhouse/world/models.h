#pragma once

/// The table that every model has a row in, whatever its kind; the kinds' own tables are generated from
/// kinds/*.toml (generated/tables.h). Frames: W world, P parent.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/row.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/change.h"
#include "playhouse/world/model_id.h"
#include "playhouse/world/shared_column.h"

namespace playhouse::world {

using ModelRow = Row<struct ModelTable>;

/// Every model (n rows).
struct Models {
  std::vector<ModelId> id;              // ascending
  std::vector<std::uint32_t> desc;      // row of SceneDesc::models that says what it is; many may share one
  std::vector<ModelId> parent_id;       // none for a top-level model
  std::vector<std::uint32_t> parent;    // the same as a row, or Row::kNone
  SharedColumn<geom::Pose> X_PM{desc};  // pose in the parent; that of a top or a robot is its own
  std::vector<geom::Pose> X_WM;         // pose in the world
  /// How it stands in the parent, and in the world: with X_PM and X_WM, six degrees of freedom. Zero where
  /// the engine keeps models upright.
  SharedColumn<geom::Tilt> tilt_PM{desc}, tilt_WM{desc};
  /// How a top moves in the world, and for how many ticks it has been still. Of engines whose bodies have
  /// mass; else zero.
  SharedColumn<geom::SpatialVelocity> V_WM{desc};
  SharedColumn<std::uint32_t> still{desc};
  std::vector<std::uint32_t> root;  // top of the tree; its own row for a top-level model
  std::vector<scene::ModelKind> kind;
  std::vector<std::uint32_t> part;            // row in the kind's own table, or Row::kNone
  std::vector<std::uint32_t> first_child;     // rows or Row::kNone; see World::children()
  std::vector<std::uint32_t> next_sibling;    // ascending
  std::vector<Mobility> mobility;             // how it comes to move
  std::vector<std::uint32_t> subscribers;     // open devices and controllers, and one for alwayson
  std::vector<std::uint32_t> controllers;     // of the subscribers
  std::vector<std::uint32_t> watchers;        // of the subscribers: people who look
  std::vector<std::int32_t> fiducial_return;  // 0: unseen
  std::vector<std::int32_t> flags;            // tokens carried (source, sink)
  SharedColumn<scene::Color> color{desc};
  SharedColumn<std::string> say{desc};  // speech bubble; starts as the scene's; own with controllers
  std::size_t size() const { return id.size(); }
};

/// What a command to a drive means: a velocity [m/s, rad/s], of a car with the steering angle as turn rate
/// [rad]; a pose to go to; an acceleration [m/s^2, rad/s^2]; a speed and a heading to keep, in the frame of
/// X_OM [m/s, rad].
enum class ControlMode : std::uint8_t { kVelocity, kPosition, kAcceleration, kHeading };

}  // namespace playhouse::world
