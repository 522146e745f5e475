#pragma once

/// Times in whole ticks.

#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Ticks of `interval` that take at least `seconds`, as well as rounding lets one tell; at least 1.
std::uint64_t ticks_of(double seconds, double interval);

/// Ticks between two updates of a model.
std::uint64_t update_ticks(const World& world, ModelRow model);

}  // namespace playhouse::world
