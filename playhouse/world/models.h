#pragma once

/// The table of all models, whatever their kind; the tables of kinds are
/// generated from kinds/*.toml (generated/tables.h). Frames: W world, P parent.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/row.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/event.h"
#include "playhouse/world/model_id.h"
#include "playhouse/world/shared_column.h"

namespace playhouse::world {

using ModelRow = Row<struct ModelTable>;

/// Every model (n rows).
struct Models {
  std::vector<ModelId> id;              // ascending
  std::vector<std::uint32_t> desc;      // row of SceneDesc::models, its prototype; shared by many
  std::vector<ModelId> parent_id;       // none for a root
  std::vector<std::uint32_t> parent;    // the same as a row, or Row::kNone
  SharedColumn<geom::Pose> X_PM{desc};  // pose in the parent; roots and robots have their own value
  std::vector<geom::Pose> X_WM;         // pose in the world
  /// Tilt in the parent and in the world; together with X_PM and X_WM
  /// six degrees of freedom. Zero in engines that keep models upright.
  SharedColumn<geom::Tilt> tilt_PM{desc}, tilt_WM{desc};
  /// Velocity of a root in the world, and for how many ticks it has been
  /// at rest (sleeping). Only in engines with dynamics; otherwise zero.
  SharedColumn<geom::SpatialVelocity> V_WM{desc};
  SharedColumn<std::uint32_t> still{desc};
  std::vector<std::uint32_t> root;  // root of the tree; its own row for a root
  std::vector<scene::ModelKind> kind;
  std::vector<std::uint32_t> part;            // row in the kind's own table, or Row::kNone
  std::vector<std::uint32_t> first_child;     // rows or Row::kNone; see World::children()
  std::vector<std::uint32_t> next_sibling;    // ascending
  std::vector<Mobility> mobility;             // how it moves
  std::vector<std::uint32_t> subscribers;     // open devices, controllers, one for alwayson
  std::vector<std::uint32_t> controllers;     // of the subscribers
  std::vector<std::uint32_t> watchers;        // of the subscribers: passive viewers
  std::vector<std::int32_t> fiducial_return;  // 0: invisible to finders
  std::vector<std::int32_t> flags;            // tokens carried (source, sink)
  SharedColumn<scene::Color> color{desc};
  SharedColumn<std::string> say{desc};  // speech bubble; starts as the scene's; own with controllers
  std::size_t size() const { return id.size(); }
};

/// Meaning of a drive's command: a velocity [m/s, rad/s], for a car with the
/// steering angle as turn rate [rad]; a goal pose; an acceleration [m/s^2,
/// rad/s^2]; a speed and a heading to keep, in the frame of X_OM [m/s, rad].
enum class ControlMode : std::uint8_t { kVelocity, kPosition, kAcceleration, kHeading };

}  // namespace playhouse::world
