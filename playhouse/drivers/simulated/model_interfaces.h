#pragma once

/// Through which interfaces a simulated model can be seen, as kinds/ defines it (scene/kinds.h).

#include <cstdint>
#include <span>

#include "playhouse/scene/kinds.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Those of a model's kind, its own first: further ones show the same in other shapes.
std::span<const scene::KindInterface> interfaces_of(const world::World& world, world::ModelRow model);

/// Those of models of every kind.
std::span<const scene::KindInterface> interfaces_of_every_kind();

/// Calls visit(interface) for those of a model's kind, of every kind, and then of its traits.
template <typename Visit>
void each_interface(const world::World& world, world::ModelRow model, const Visit& visit) {
  for (const scene::KindInterface& each : interfaces_of(world, model)) visit(each);
  if (world.models.kind[model.index] != scene::ModelKind::kPlain)
    for (const scene::KindInterface& each : interfaces_of_every_kind()) visit(each);
  for (const scene::Kind& kind : scene::kinds()) {
    if (kind.has == nullptr || !kind.has(world.desc(model))) continue;
    for (const scene::KindInterface& each : kind.interfaces) visit(each);
  }
}

/// A position model at the top level.
bool is_robot(const world::World& world, world::ModelRow model);

/// Whether a model has what an interface needs.
bool has(const world::World& world, world::ModelRow model, scene::Need need);

/// True when a model can be seen through an interface: its kind or a trait has it, and the model what it
/// needs. Never for interfaces that belong to the whole world.
bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf);

/// True where several devices of a configuration file may be of one model.
bool is_shared(std::uint16_t interf);

/// True for interfaces of anything that is simulated.
bool is_simulated(std::uint16_t interf);

}  // namespace playhouse::drivers
