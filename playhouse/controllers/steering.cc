#include "playhouse/controllers/steering.h"

#include <algorithm>

namespace playhouse::controllers {
namespace {

constexpr double kCruise = 0.4;                             // m/s, unobstructed
constexpr double kCreep = 0.05;                             // m/s, while turning away
constexpr double kTurn = 0.5;                               // rad/s
constexpr float kAhead = 1.0f;                              // m, in the middle third: turn away
constexpr float kClose = 0.3f;                              // m, anywhere: stop and turn
constexpr std::uint32_t kKeepLeast = 10, kKeepSpread = 10;  // scans to keep a turn
constexpr std::uint32_t kScannerSamples = 8;                // minimum beams of a scanner, exclusive

/// Minimum of some ranges; `none` if there are none.
/// Eight independent lanes, which compilers vectorise.
float nearest(std::span<const float> ranges, float none) {
  constexpr std::size_t kLanes = 8;
  float lane[kLanes];
  std::fill_n(lane, kLanes, none);
  std::size_t k = 0;
  for (; k + kLanes <= ranges.size(); k += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) lane[j] = ranges[k + j] < lane[j] ? ranges[k + j] : lane[j];
  }
  for (; k < ranges.size(); ++k) lane[0] = std::min(lane[0], ranges[k]);
  return *std::min_element(lane, lane + kLanes);
}

struct View {
  float right, ahead, left;  // m, minima of either side and of the middle third
};

/// Beams are ordered from right to left. A single beam counts for all three.
View look(std::span<const float> ranges) {
  constexpr float kFar = 1e30f;
  const std::size_t n = ranges.size(), third = n / 3, half = n / 2;
  const float right = nearest(ranges.subspan(0, third), kFar);
  const float ahead_right = nearest(ranges.subspan(third, half - third), kFar);
  const float ahead_left = nearest(ranges.subspan(half, n - third - half), kFar);
  const float left = nearest(ranges.subspan(n - third), kFar);
  return {std::min(right, ahead_right), std::min(ahead_right, ahead_left), std::min(ahead_left, left)};
}

/// The sensor for steering; none if there is none.
world::SensorRow scanner(const world::World& world, const std::vector<world::RangerRow>& rangers) {
  world::SensorRow best;
  for (const world::RangerRow ranger : rangers) {
    for (const world::SensorRow k : sensors_of(world.rangers, ranger)) {
      const std::uint32_t beams = world.sensors.beam_count[k];
      if (beams > kScannerSamples) return k;
      if (!best || beams > world.sensors.beam_count[best]) best = k;
    }
  }
  return best;
}

Fan fan_of(const world::World& world, world::ModelRow robot, world::SensorRow sensor) {
  const world::RangerRow ranger = world.sensors.ranger[sensor];
  const std::vector<float> bearings = bearings_of(world, robot, ranger);
  const std::uint32_t first = world.sensors.first_beam[sensor] - first_beam(world, ranger);
  const bool several = world.sensors.beam_count[sensor] > 1;
  return {bearings[first], several ? geom::normalize(bearings[first + 1] - bearings[first]) : 0};
}

}  // namespace

Result<void> Steering::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (!position_of(world, model)) return Error{{}, "needs a position model"};
  const world::SensorRow sensor = scanner(world, rangers_of(world, model));
  if (!sensor) return Error{{}, "needs a ranger with at least one sensor"};
  world::subscribe_controller(world, model);
  world::subscribe_controller(world, world.rangers.model[world.sensors.ranger[sensor]]);

  stream_.push_back({Purpose::kController, world.serial(post.model), post.order});
  seen_.push_back(0);
  avoiding_.push_back(0);
  turn_.push_back(0);
  robot_.emplace_back();
  ranger_.emplace_back();
  first_beam_.emplace_back();
  beams_.emplace_back();
  fan_.emplace_back();
  resolve(world, model, robot_.size() - 1);
  return {};
}

void Steering::resolve(const world::World& world, world::ModelRow model, std::size_t i) {
  const world::SensorRow sensor = scanner(world, rangers_of(world, model));
  robot_[i] = position_of(world, model);
  ranger_[i] = world.sensors.ranger[sensor];
  first_beam_[i] = world.sensors.first_beam[sensor];
  beams_[i] = world.sensors.beam_count[sensor];
  fan_[i] = fan_of(world, model, sensor);
}

bool Steering::is_new_scan(const world::World& world, std::size_t i) {
  const std::uint64_t measured = world.rangers.measured_tick[ranger_[i]];
  return std::exchange(seen_[i], measured) != measured;
}

void Steering::steer(world::World& world, std::size_t i) {
  const View view = look(beams(world, i));
  const bool stop = std::min(view.right, view.left) < kClose;
  if (view.ahead >= kAhead && !stop && avoiding_[i] == 0) {
    drive(world, robot_[i], kCruise, 0);
    return;
  }
  if (avoiding_[i] == 0) {
    Rng random(world.seed(), world.tick(), stream_[i]);
    avoiding_[i] = kKeepLeast + static_cast<std::uint32_t>(random.bits() % kKeepSpread);
    turn_[i] = view.left < view.right ? -kTurn : kTurn;
  }
  --avoiding_[i];
  drive(world, robot_[i], stop ? 0 : kCreep, turn_[i]);
}

}  // namespace playhouse::controllers
