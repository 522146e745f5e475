#include "playhouse/controllers/diffusion.h"

#include <cmath>

namespace playhouse::controllers {
namespace {

constexpr double kSpeed = 0.05;                // m/s, of a turning wheel
constexpr double kAxle = 0.14;                 // m, between the wheels of a foot-bot
constexpr double kNear = 0.1;                  // mean activation above which a robot turns away
constexpr double kAhead = geom::radians(7.5);  // rad, tolerance for straight ahead

}  // namespace

Diffusion::DiffusionRing Diffusion::ring_of(const world::World& world, world::ModelRow robot,
                                            world::RangerRow ranger) {
  const std::vector<float> bearings = bearings_of(world, robot, ranger);
  DiffusionRing ring;
  for (const scene::RangerSensorDesc& sensor : world.desc(world.rangers.model[ranger]).sensors) {
    for (std::uint32_t k = 0; k < sensor.samples; ++k) {
      const auto [sin, cos] = geom::sincos(bearings[ring.size()]);
      ring.push_back({cos, sin, static_cast<float>(sensor.range_min), static_cast<float>(sensor.range_max)});
    }
  }
  PLAYHOUSE_ASSERT(ring.size() == bearings.size());
  return ring;
}

Result<void> Diffusion::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (!position_of(world, model)) return Error{{}, "needs a position model"};
  const world::RangerRow ranger = ring_ranger(world, model);
  if (!ranger) return Error{{}, "needs a ranger with at least one sensor"};
  world::subscribe_controller(world, model);
  world::subscribe_controller(world, world.rangers.model[ranger]);

  DiffusionRing ring = ring_of(world, model, ranger);
  const auto [place, is_new] = place_of_ring_.try_emplace(ring, static_cast<std::uint32_t>(rings_.size()));
  if (is_new) rings_.push_back(std::move(ring));
  ring_.push_back(place->second);
  seen_.push_back(0);
  robot_.emplace_back();
  ranger_.emplace_back();
  first_beam_.emplace_back();
  find_rows(world, model, robot_.size() - 1);
  return {};
}

void Diffusion::resolve(const world::World& world, std::size_t i) {
  find_rows(world, world.row(id(i)), i);
}

void Diffusion::find_rows(const world::World& world, world::ModelRow model, std::size_t i) {
  robot_[i] = position_of(world, model);
  ranger_[i] = ring_ranger(world, model);
  first_beam_[i] = first_beam(world, ranger_[i]);
}

void Diffusion::decide(world::World& world, std::size_t begin, std::size_t end) {
  const double cos_ahead = geom::sincos(kAhead).cos;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint64_t measured = world.rangers.measured_tick[ranger_[i]];
    if (measured == seen_[i]) continue;
    seen_[i] = measured;

    // Sum of proximity vectors, of length 1 at contact.
    const DiffusionRing& ring = rings_[ring_[i]];
    const float* const range = world.sensors.ranges.from(first_beam_[i]);
    geom::Vec2 sum;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const RingBeam& beam = ring[k];
      if (range[k] >= beam.unnoticed) continue;
      const double near = (beam.unnoticed - range[k]) / (beam.unnoticed - beam.touches);
      sum = sum + geom::Vec2{near * beam.x, near * beam.y};
    }
    const double length = std::sqrt(geom::dot(sum, sum));
    if (length < kNear * static_cast<double>(ring.size()) && sum.x >= cos_ahead * length) {
      drive(world, robot_[i], kSpeed, 0);
    } else {  // one wheel stopped
      drive(world, robot_[i], kSpeed / 2, sum.y > 0 ? -kSpeed / kAxle : kSpeed / kAxle);
    }
  }
}

}  // namespace playhouse::controllers
