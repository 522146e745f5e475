#pragma once

/// Interfaces of simulated models, as defined in kinds/ (scene/kinds.h).

#include <cstdint>
#include <span>

#include "playhouse/scene/kinds.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Those of a model's kind, the primary one first: further ones expose the same data in other formats.
std::span<const scene::KindInterface> interfaces_of(const world::World& world, world::ModelRow model);

/// Those available for every kind.
std::span<const scene::KindInterface> interfaces_of_every_kind();

/// Calls visit(interface) for those of a model's kind, of every kind, and of its traits.
template <typename Visit>
void each_interface(const world::World& world, world::ModelRow model, const Visit& visit) {
  for (const scene::KindInterface& each : interfaces_of(world, model)) visit(each);
  if (world.models.kind[model] != scene::ModelKind::kPlain)
    for (const scene::KindInterface& each : interfaces_of_every_kind()) visit(each);
  for (const scene::Kind& kind : scene::kinds()) {
    if (kind.has == nullptr || !kind.has(world.desc(model))) continue;
    for (const scene::KindInterface& each : kind.interfaces) visit(each);
  }
}

/// Calls visit(part) for a model and its parts, parents before children, in the file's order.
template <typename Visit>
void each_part(const world::World& world, world::ModelRow model, const Visit& visit) {
  visit(model);
  for (const world::ModelRow child : world.children(model)) each_part(world, child, visit);
}

/// True for what has digital outputs: a lamp that is switched.
inline bool is_lamp(scene::ModelKind kind) {
  return kind == scene::ModelKind::kBlinkenlight || kind == scene::ModelKind::kLightindicator;
}

/// True for a root position model.
bool is_robot(const world::World& world, world::ModelRow model);

/// Whether a model satisfies an interface's requirement.
bool has(const world::World& world, world::ModelRow model, scene::Need need);

/// True if a model can be exposed through an interface: its kind or a trait has
/// it, and its requirement is met. Never for interfaces of the whole world.
bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf);

/// The same for the automatic map: what a model has there is what it is meant for.
bool is_listed(const world::World& world, world::ModelRow model, std::uint16_t interf);

/// True if several devices of a configuration file may share one model.
bool is_shared(std::uint16_t interf);

/// True for interfaces of any simulated kind or trait.
bool is_simulated(std::uint16_t interf);

}  // namespace playhouse::drivers
