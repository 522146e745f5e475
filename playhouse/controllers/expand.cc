#include "playhouse/controllers/expand.h"

#include <algorithm>
#include <cmath>

namespace playhouse::controllers {
namespace {

/// Its first fiducial finder, or none.
world::FiducialRow finder_of(const world::World& world, world::ModelRow model) {
  const std::vector<world::FiducialRow> finders = finders_of(world, model);
  return finders.empty() ? world::FiducialRow{} : finders.front();
}

struct Look {
  geom::Vec2 free;       // sum of beam vectors [m]
  bool blocked = false;  // a beam is below its minimum
};

/// Minimum range of a beam at `bearing`; negative: ignored. [m]
float clearance_at(std::span<const Clearance> clearance, double bearing) {
  for (const Clearance& c : clearance)
    if (std::fabs(bearing) <= c.up_to) return c.longer_than;
  return -1;
}

/// Four lanes added in a fixed order: the same bits with and without SIMD.
Look look(const float* range, std::span<const float> x, std::span<const float> y,
          std::span<const float> clear) {
  constexpr std::size_t kLanes = 4;
  float sum_x[kLanes] = {}, sum_y[kLanes] = {};
  int blocked[kLanes] = {};
  const auto add = [&](std::size_t k, std::size_t lane) {
    sum_x[lane] += range[k] * x[k];
    sum_y[lane] += range[k] * y[k];
    blocked[lane] |= range[k] <= clear[k];
  };
  std::size_t k = 0;
  for (; k + kLanes <= x.size(); k += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) add(k + lane, lane);
  }
  for (; k < x.size(); ++k) add(k, 0);
  return {{sum_x[0] + sum_x[1] + (sum_x[2] + sum_x[3]), sum_y[0] + sum_y[1] + (sum_y[2] + sum_y[3])},
          (blocked[0] | blocked[1] | blocked[2] | blocked[3]) != 0};
}

}  // namespace

std::uint32_t Expand::ring_of(const std::vector<float>& bearings) {
  const auto [at, is_new] =
      ring_by_bearings_.try_emplace(bearings, static_cast<std::uint32_t>(rings_.size()));
  if (!is_new) return at->second;
  ExpandRing ring;
  for (const float bearing : bearings) {
    const auto [sin, cos] = geom::sincos(bearing);
    const bool looked_at = std::fabs(bearing) <= config_.looks;
    ring.x.push_back(looked_at ? static_cast<float>(cos) : 0);
    ring.y.push_back(looked_at ? static_cast<float>(sin) : 0);
    ring.clear.push_back(clearance_at(config_.clearance, bearing));
  }
  rings_.push_back(std::move(ring));
  return at->second;
}

Result<void> Expand::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (!position_of(world, model)) return Error{{}, "needs a position model"};
  const world::RangerRow ranger = ring_ranger(world, model);
  if (!ranger) return Error{{}, "needs a ranger with at least one sensor"};
  world::subscribe_controller(world, model);
  world::subscribe_controller(world, world.rangers.model[ranger]);
  if (const auto finder = finder_of(world, model); finder && config_.flock > 0)
    world::subscribe_controller(world, world.fiducials.model[finder]);

  const std::vector<float> bearings = bearings_of(world, model, ranger);
  PLAYHOUSE_ASSERT(bearings.size() == beam_count(world, ranger));
  ring_.push_back(ring_of(bearings));
  stream_.push_back({Purpose::kController, world.serial(post.model), post.order});
  seen_.push_back(0);
  robot_.emplace_back();
  ranger_.emplace_back();
  finder_.emplace_back();
  first_beam_.emplace_back();
  find_rows(world, model, robot_.size() - 1);
  return {};
}

void Expand::resolve(const world::World& world, std::size_t i) {
  find_rows(world, world.row(id(i)), i);
}

void Expand::find_rows(const world::World& world, world::ModelRow model, std::size_t i) {
  robot_[i] = position_of(world, model);
  ranger_[i] = ring_ranger(world, model);
  finder_[i] = config_.flock > 0 ? finder_of(world, model) : world::FiducialRow{};
  first_beam_[i] = first_beam(world, ranger_[i]);
}

double Expand::off_neighbour(const world::World& world, std::size_t i) const {
  if (!finder_[i]) return 0;
  const std::vector<world::FiducialHit>& hits = world.fiducials.hits[finder_[i]];
  const auto nearest = std::ranges::min_element(hits, {}, &world::FiducialHit::range);
  return nearest == hits.end() ? 0 : nearest->heading;
}

void Expand::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint64_t measured = world.rangers.measured_tick[ranger_[i]];
    if (measured == seen_[i]) continue;
    seen_[i] = measured;

    const ExpandRing& ring = rings_[ring_[i]];
    const Look seen = look(world.sensors.ranges.from(first_beam_[i]), ring.x, ring.y, ring.clear);
    const double bearing = geom::atan2(seen.free.y, seen.free.x);
    const bool go = !seen.blocked && std::fabs(bearing) < config_.free_angle;
    double turn = config_.gain * bearing;
    if (go) {
      turn += config_.flock * off_neighbour(world, i);
    } else if (std::fabs(turn) < config_.restless) {
      turn = Rng(world.seed(), world.tick(), stream_[i]).uniform();
    }
    drive(world, robot_[i], go ? config_.cruise : 0, turn);
  }
}

}  // namespace playhouse::controllers
