/// ThermometerSense: the phase in which thermometers that are subscribed and due measure.
///
/// In: poses of models; their `heat`; ambient temperature, lapse and noise of each thermometer.
/// Out: the temperature at the middle of the thermometer's body.
/// Cost: a square root for each model with heat; a dozen random numbers for a thermometer with noise.
/// Source: each warm model is a ball of constant temperature in air that conducts heat and rests. Its excess e
///   over the air far away is harmonic outside of the ball, so at the distance d it is e r / d for a radius r,
///   and fields of several balls add up (Carslaw and Jaeger, "Conduction of Heat in Solids", 1959, 9.1). Air
///   that cools with height does so linearly, as in the troposphere (ISO 2533).

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/pose_sense.h"

namespace playhouse::senses {
namespace {

using geom::Vec3;

constexpr double kAbsoluteZero = -273.15;  // degC

class ThermometerSense final : public PoseSense {
 public:
  SensorTable table(world::World& world) const override {
    return {world.thermometers.model, world.thermometers.measured_tick};
  }
  void populate(const world::World& world, const bodies::Space&) override {
    warm_.clear();
    for (const world::ModelRow row : world.models.rows())
      if (world.desc(row).heat != 0) warm_.push_back(row);
  }

 private:
  void measure(world::World& world, world::KindRow row, std::uint64_t tick) const override;

  std::vector<world::ModelRow> warm_;
};

void ThermometerSense::measure(world::World& world, world::KindRow row, std::uint64_t tick) const {
  const auto middle = [&](world::ModelRow model) {
    const geom::Pose up{0, 0, world.desc(model).size.z / 2, 0};
    const geom::Pose X = geom::compose(body_pose(world, model), {up, geom::Tilt{}}).X;
    return Vec3{X.x, X.y, X.z};
  };
  const world::ModelRow model = world.thermometers.model[row];
  const scene::ThermometerDesc& thermometer = *world.desc(model).thermometer;
  const Vec3 p = middle(model);
  double temperature = thermometer.ambient - thermometer.lapse * p.z;
  for (const world::ModelRow each : warm_) {
    const scene::ModelDesc& ball = world.desc(each);
    const Vec3 way = middle(each) - p;
    temperature += ball.heat * ball.heat_radius / std::max(std::sqrt(dot(way, way)), ball.heat_radius);
  }
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
