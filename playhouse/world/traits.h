#pragma once

/// Traits: optional properties of models of any kind, in a table with a row for each
/// model that has the trait, in the order of models (kinds/*.toml with entity = "trait").

#include <algorithm>
#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// The row of a model in the table of a trait; Row::kNone if it lacks the trait.
template <typename Table>
std::uint32_t trait_row(const Table& table, std::uint32_t model) {
  const auto found = std::ranges::lower_bound(table.model, ModelRow{model});
  const bool has = found != table.model.end() && *found == ModelRow{model};
  return has ? static_cast<std::uint32_t>(found - table.model.begin()) : ModelRow::kNone;
}

/// The battery that supplies a model: its own, or that of
/// its nearest ancestor with one; none if there is none.
inline PackRow pack_of(const World& world, ModelRow model) {
  for (std::uint32_t row = model.index; row != ModelRow::kNone; row = world.models.parent[row])
    if (const std::uint32_t pack = trait_row(world.packs, row); pack != ModelRow::kNone) return {pack};
  return {};
}

}  // namespace playhouse::world
