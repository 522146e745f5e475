#include "playhouse/senses/ranger_noise.h"

#include "playhouse/base/rng.h"

namespace playhouse::senses {
namespace {

double noisy(double range, const scene::RangerSensorDesc& sensor, Rng& rng) {
  if (sensor.noise_proportional > 0) range += range * sensor.noise_proportional * rng.uniform(-1, 1);
  if (sensor.noise_constant > 0) range += sensor.noise_constant * rng.gaussian();
  return range;
}

}  // namespace

double turn_of(const world::World& world, world::ModelRow model, std::uint64_t tick, std::uint32_t sensor,
               std::uint32_t beam) {
  const double spread = world.desc(model).sensors[sensor].noise_angular;
  Rng rng(world.seed(), tick, {Purpose::kBeamBearing, world.serial(model), sensor, beam});
  return rng.uniform(-spread, spread);
}

void add_range_noise(const world::World& world, world::RangerRow ranger, std::uint64_t tick, double* range,
                     Rings rings) {
  const world::ModelRow model = world.rangers.model[ranger];
  for (std::uint32_t i = 0; i < world.rangers.sensor_count[ranger]; ++i) {
    const scene::RangerSensorDesc& sensor = world.desc(model).sensors[i];
    Rng rng(world.seed(), tick, {Purpose::kRangeNoise, world.serial(model), i});
    const std::uint32_t beams = sensor.samples * (rings == Rings::kAll ? sensor.rings : 1);
    for (std::uint32_t k = 0; k < beams; ++k, ++range)
      if (*range < sensor.range_max) *range = noisy(*range, sensor, rng);
  }
}

}  // namespace playhouse::senses
