#pragma once

/// Traits: optional properties of models of any kind, in a table with a row for each
/// model that has the trait, in the order of models (kinds/*.toml with entity = "trait").

#include <algorithm>
#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// The row of a model in the table of a trait; none if it lacks the trait.
template <typename Table>
auto trait_row(const Table& table, ModelRow model) {
  using TraitRow = decltype(table.model.next());
  const auto found = std::ranges::lower_bound(table.model, model);
  const bool has = found != table.model.end() && *found == model;
  return has ? TraitRow{static_cast<std::uint32_t>(found - table.model.begin())} : TraitRow{};
}

/// The battery that supplies a model: its own, or that of
/// its nearest ancestor with one; none if there is none.
inline PackRow pack_of(const World& world, ModelRow model) {
  for (ModelRow row = model; row; row = world.models.parent[row])
    if (const PackRow pack = trait_row(world.packs, row)) return pack;
  return {};
}

}  // namespace playhouse::world
