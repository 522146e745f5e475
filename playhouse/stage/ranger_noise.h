#pragma once

/// The errors of rangers, the same in every engine. Random numbers are those of the ranger's id, the tick,
/// the sensor and the beam.

#include <cstdint>

#include "playhouse/world/world.h"

namespace playhouse::stage {

/// Of a beam in its sensor; a single one looks ahead.  [rad]
double bearing_of(const scene::RangerSensorDesc& sensor, std::uint32_t beam);

/// By how much a beam of a sensor with angular noise is turned.  [rad]
double turn_of(const world::World& world, world::ModelRow model, std::uint64_t tick, std::uint32_t sensor,
               std::uint32_t beam);

/// Adds errors along the beams to what those of row `ranger` of world.rangers measured: `range`, m (beams).
/// What met nothing has none.
void add_range_noise(const world::World& world, std::uint32_t ranger, std::uint64_t tick, double* range);

}  // namespace playhouse::stage
