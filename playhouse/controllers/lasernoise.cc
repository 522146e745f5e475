#include "playhouse/controllers/lasernoise.h"

#include <algorithm>

namespace playhouse::controllers {
namespace {

constexpr double kNoise = 0.05;  // standard deviation of the factor, Stage's

/// As the noise of a sensor: beams without a hit have none, the others stay within the range.
void add_noise(const scene::RangerSensorDesc& sensor, std::span<float> ranges, Rng& random) {
  const auto least = static_cast<float>(sensor.range_min), most = static_cast<float>(sensor.range_max);
  for (float& range : ranges) {
    if (range >= most) continue;
    const double noisy = range * (1 + kNoise * random.gaussian());
    range = std::clamp(static_cast<float>(noisy), least, most);
  }
}

}  // namespace

Result<void> LaserNoise::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (world.models.kind[model] != scene::ModelKind::kRanger) return Error{{}, "needs to be on a ranger"};
  ranger_.push_back(world.models.part[model]);
  stream_.push_back({Purpose::kController, world.serial(post.model), post.order});
  return {};
}

void LaserNoise::resolve(const world::World& world, std::size_t i) {
  ranger_[i] = world.models.part[world.row(id(i))];
}

void LaserNoise::filter(world::World& world, std::size_t begin, std::size_t end) {
  const std::uint64_t now = world.tick() + 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (world.rangers.measured_tick[ranger_[i]] != now) continue;
    Rng random(world.seed(), now, stream_[i]);
    world::SensorRow row = world.rangers.first_sensor[ranger_[i]];
    for (const scene::RangerSensorDesc& sensor : world.desc(world.rangers.model[ranger_[i]]).sensors) {
      add_noise(
          sensor,
          std::span(world.sensors.ranges.from(world.sensors.first_beam[row]), world.sensors.beam_count[row]),
          random);
      ++row;
    }
  }
}

}  // namespace playhouse::controllers
