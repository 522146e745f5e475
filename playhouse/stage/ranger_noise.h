#pragma once

/// The errors of rangers, the same in every engine. Random numbers are those of the ranger's id, the tick,
/// the sensor and the beam.

#include <cstdint>

#include "playhouse/scene/sensor_rays.h"
#include "playhouse/world/world.h"

namespace playhouse::stage {

using scene::bearing_of;

/// Which of its rings an engine measures.
enum class Rings : std::uint8_t { kLevel, kAll };

/// By how much a beam of a sensor with angular noise is turned.  [rad]
double turn_of(const world::World& world, world::ModelRow model, std::uint64_t tick, std::uint32_t sensor,
               std::uint32_t beam);

/// Adds errors along the beams to what those of row `ranger` of world.rangers measured: `range`, m (beams).
/// What met nothing has none.
void add_range_noise(const world::World& world, std::uint32_t ranger, std::uint64_t tick, double* range,
                     Rings rings = Rings::kLevel);

}  // namespace playhouse::stage
