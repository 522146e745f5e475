#pragma once

/// sense() of custom models, in any engine; the engine provides Surroundings.

#include <cstdint>
#include <vector>

#include "playhouse/world/surroundings.h"
#include "playhouse/world/world.h"

namespace playhouse::behaviour {

/// Measures with one custom model at `tick`; writes customs.readings of its row. `scratch` is the worker's.
void sense_custom(world::World& world, world::CustomRow custom, std::uint64_t tick,
                  const world::Surroundings& around, std::vector<double>& scratch);

}  // namespace playhouse::behaviour
