#pragma once

/// What a row of a kind's or trait's table begins with, and how a description says it of a row as it stands:
/// each the other's inverse. Columns with a `word` in kinds/*.toml need no code (generated/worded.h); here is
/// the rest. Other columns begin with zeros, and have nothing to say.

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

/// The same of all rows that a model has.
bool say_rows(const World& world, ModelRow row, scene::ModelDesc* said = nullptr);

}  // namespace playhouse::world
