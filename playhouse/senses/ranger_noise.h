#pragma once

/// The noise of rangers, the same in every engine. Random numbers are
/// a function of the ranger's id, the tick, the sensor and the beam.

#include <cstdint>

#include "playhouse/scene/forms/sensor_rays.h"
#include "playhouse/world/world.h"

namespace playhouse::senses {

using scene::bearing_of;

/// Rings of a 3D ranger that an engine measures: the level one or all.
enum class Rings : std::uint8_t { kLevel, kAll };

/// Angular noise of a beam.  [rad]
double turn_of(const world::World& world, world::ModelRow model, std::uint64_t tick, std::uint32_t sensor,
               std::uint32_t beam);

/// Adds range noise to the measurements of row `ranger` of
/// world.rangers: `range`, m (beams). Beams without a hit get none.
void add_range_noise(const world::World& world, world::RangerRow ranger, std::uint64_t tick, double* range,
                     Rings rings = Rings::kLevel);

}  // namespace playhouse::senses
