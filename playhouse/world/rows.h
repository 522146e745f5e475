#pragma once

/// What a row of a kind's or trait's table begins with, and how a description says it of a row as it stands:
/// each the other's inverse. Columns with a `word` in kinds/*.toml need no code (generated/worded.h); here is
/// the rest. Other columns begin with zeros, and have nothing to say. Then what rows do when their model is
/// put elsewhere. A kind that differs from the others has an overload here, and nobody asks for its name.

#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Fills the last row of a table, which is the model's and begins as its words say.
template <typename Table>
void fill_row(World&, Table&, const scene::ModelDesc&, ModelRow) {}
void fill_row(World& world, Positions& positions, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Rangers& rangers, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Packs& packs, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Blinkenlights& lamps, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Actuators& actuators, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Grippers& grippers, const scene::ModelDesc& model, ModelRow row);
void fill_row(World& world, Cameras& cameras, const scene::ModelDesc& model, ModelRow row);

/// Whether a description says other than what the row stands for; then `said`, a copy of it or null, is made
/// to say that.
template <typename Table>
bool say_row(const Table&, std::uint32_t, const scene::ModelDesc&, scene::ModelDesc*) {
  return false;
}
bool say_row(const Packs& packs, std::uint32_t row, const scene::ModelDesc& model, scene::ModelDesc* said);
/// Paddles or a lift on their way are as the file has them.
bool say_row(const Grippers& grippers, std::uint32_t row, const scene::ModelDesc& model,
             scene::ModelDesc* said);
bool say_row(const Cameras& cameras, std::uint32_t row, const scene::ModelDesc& model,
             scene::ModelDesc* said);

/// The same of all rows that a model has.
bool say_rows(const World& world, ModelRow row, scene::ModelDesc* said = nullptr);

/// The pose by which a description says where the model of a row is.
template <typename Table>
const geom::Pose& pose_said(const World& world, const Table&, ModelRow row) {
  return world.models.X_PM[row.index];
}
const geom::Pose& pose_said(const World& world, const Actuators& actuators, ModelRow row);
/// Of any model.
const geom::Pose& pose_said(const World& world, ModelRow row);

/// The model of a row was put elsewhere in its parent.
template <typename Table>
void moved_in_parent(World&, Table&, ModelRow) {}
/// What it counts its position from goes with it.
void moved_in_parent(World& world, Actuators& actuators, ModelRow row);

/// The model of a row is elsewhere in the world, and did not drive there.
template <typename Table>
void moved_in_world(World&, Table&, ModelRow) {}
/// A robot with gps believes the truth.
void moved_in_world(World& world, Positions& positions, ModelRow row);

}  // namespace playhouse::world
