#include "playhouse/controllers/lasernoise.h"

namespace playhouse::controllers {
namespace {

constexpr double kNoise = 0.05;  // standard deviation of the factor, Stage's

}  // namespace

Result<void> LaserNoise::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (world.models.kind[model.index] != scene::ModelKind::kRanger)
    return Error{{}, "needs to be on a ranger"};
  ranger_.push_back({world.models.part[model.index]});
  stream_.push_back({Purpose::kController, world.serial(post.model), post.order});
  return {};
}

void LaserNoise::resolve(const world::World& world, std::size_t i) {
  ranger_[i] = {world.models.part[world.row(id(i)).index]};
}

void LaserNoise::filter(world::World& world, std::size_t begin, std::size_t end) {
  const std::uint64_t now = world.tick() + 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (world.rangers.measured_tick[ranger_[i].index] != now) continue;
    Rng random(world.seed(), now, stream_[i]);
    const std::uint32_t first = first_beam(world, ranger_[i]), count = beam_count(world, ranger_[i]);
    for (float& range : std::span(world.sensors.ranges).subspan(first, count)) {
      const double noisy = range * (1 + kNoise * random.gaussian());
      range = static_cast<float>(noisy);
    }
  }
}

}  // namespace playhouse::controllers
