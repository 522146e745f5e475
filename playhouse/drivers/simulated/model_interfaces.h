#pragma once

/// Through which interfaces a simulated model can be seen, as kinds/ defines it (scene/kinds.h).

#include <cstdint>
#include <span>

#include "playhouse/scene/kinds.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Those of a model's kind, its own first: further ones show the same in other shapes.
std::span<const scene::KindInterface> interfaces_of(const world::World& world, world::ModelRow model);

/// Whether a model has what an interface needs.
bool has(const world::World& world, world::ModelRow model, scene::Need need);

/// True when a model can be seen through an interface: its kind has it, and the model what it needs. Never
/// for interfaces that belong to the whole world.
bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf);

/// True for interfaces of anything that is simulated.
bool is_simulated(std::uint16_t interf);

}  // namespace playhouse::drivers
