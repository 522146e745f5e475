#pragma once

/// Conversion between descriptions and rows of kind and trait tables: initial values of a row
/// from its description, and the inverse, for export. Columns with a `word` in kinds/*.toml need
/// no code (generated/worded.h); others start at zero and are not exported. Also hooks of rows
/// whose model was moved. Kinds with special behaviour have an overload; callers are generic.

#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Initialises the last row of a table from its model's description.
template <typename Table>
void fill_row(World&, Table&, const scene::ModelDesc&, ModelRow) {}
void fill_row(World& world, Positions& positions, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Rangers& rangers, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Packs& packs, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Blinkenlights& lamps, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Actuators& actuators, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Grippers& grippers, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Cameras& cameras, const scene::ModelDesc& model, ModelRow row);

/// True if the row's state differs from the description; then
/// `said`, a copy of that or null, is updated to match the row.
template <typename Table>
bool say_row(const Table&, typename Table::Row, const scene::ModelDesc&, scene::ModelDesc*) {
  return false;
}
bool say_row(const Packs& packs, PackRow row, const scene::ModelDesc& model, scene::ModelDesc* said);
/// Moving paddles or lifts are exported as in the file.
bool say_row(const Grippers& grippers, GripperRow row, const scene::ModelDesc& model, scene::ModelDesc* said);
bool say_row(const Cameras& cameras, CameraRow row, const scene::ModelDesc& model, scene::ModelDesc* said);

/// The same for all rows of a model.
bool say_rows(const World& world, ModelRow row, scene::ModelDesc* said = nullptr);

/// The pose that a description should have for the model of a row.
template <typename Table>
const geom::Pose& pose_said(const World& world, const Table&, ModelRow row) {
  return world.models.X_PM[row];
}
const geom::Pose& pose_said(const World& world, const Actuators& actuators, ModelRow row);
/// For any model.
const geom::Pose& pose_said(const World& world, ModelRow row);

/// The odometry of a robot where it is now, as at its start.
void begin_odometry(World& world, PositionRow robot);

/// Puts an actuator where its position is along or about the axis of this joint.
void set_joint(World& world, ActuatorRow actuator, const geom::SpatialPose& X_PJ);
/// X_PJ with its tilt.
geom::SpatialPose joint_of(const World& world, ActuatorRow actuator);

/// Hook: the model of a row got a new pose in its parent.
template <typename Table>
void moved_in_parent(World&, Table&, ModelRow) {}
/// Moves the origin of its joint position along.
void moved_in_parent(World& world, Actuators& actuators, ModelRow row);

/// Hook: the model of a row was teleported in the world.
template <typename Table>
void moved_in_world(World&, Table&, ModelRow) {}
/// Odometry of a robot with gps follows.
void moved_in_world(World& world, Positions& positions, ModelRow row);

}  // namespace playhouse::world
