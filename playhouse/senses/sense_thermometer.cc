/// ThermometerSense: the phase in which thermometers that are subscribed and due measure.
///
/// In: poses of models; their `heat`; ambient temperature, lapse and noise of each thermometer.
/// Out: the temperature at the middle of the thermometer's body.
/// Cost: a square root for each model with heat; a dozen random numbers for a thermometer with noise.
/// Source: air.h.

#include <algorithm>

#include "playhouse/base/rng.h"
#include "playhouse/senses/air.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/pose_sense.h"

namespace playhouse::senses {
namespace {

class ThermometerSense final : public PoseSense {
 public:
  SensorTable table(world::World& world) const override {
    return {world.thermometers.model, world.thermometers.measured_tick};
  }
  void populate(const world::World& world, const bodies::Space&) override {
    air_.populate(world, world.thermometers.size());
  }

 private:
  void begin_tick(const world::World& world) override { air_.begin_tick(world); }
  void measure(world::World& world, world::KindRow row, std::uint64_t tick) const override;

  Air air_;
};

void ThermometerSense::measure(world::World& world, world::KindRow row, std::uint64_t tick) const {
  const world::ModelRow model = world.thermometers.model[row];
  const scene::ThermometerDesc& thermometer = *world.desc(model).thermometer;
  double temperature = air_.temperature(world, model, {thermometer.ambient, thermometer.lapse});
  if (thermometer.noise > 0)
    temperature +=
        thermometer.noise * Rng(world.seed(), tick, {Purpose::kReading, world.serial(model)}).gaussian();
  world.thermometers.temperature[row] = std::max(temperature, kAbsoluteZero);
}

}  // namespace

std::unique_ptr<SensePhase> make_thermometer_sense(unsigned) {
  return std::make_unique<ThermometerSense>();
}

}  // namespace playhouse::senses
