#pragma once

/// Conversion of durations to whole ticks.

#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Number of ticks of `interval` in `seconds`, rounded up with a tolerance for rounding errors; at least 1.
std::uint64_t ticks_of(double seconds, double interval);

/// Ticks between two updates of a model.
std::uint64_t update_ticks(const World& world, ModelRow model);

}  // namespace playhouse::world
