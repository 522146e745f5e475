#include "playhouse/controllers/patrol.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "playhouse/base/in_quotes.h"

namespace playhouse::controllers {
namespace {

constexpr double kSpeed = 1;                  // m/s, a walk
constexpr double kReached = 0.1;              // m, at least
constexpr double kGain = 3;                   // rad/s per rad of bearing to the waypoint
constexpr double kMostTurn = 1.5;             // rad/s
constexpr double kAhead = geom::radians(60);  // drives only while the waypoint is within this bearing
constexpr const char* kUsage = "needs [SPEED] X Y [X Y ...], in m/s and metres of the world";

/// A finite number of the whole word.
std::optional<double> number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

Result<void> Patrol::join(world::World& world, const Post& post) {
  const world::ModelRow model = world.row(post.model);
  if (!position_of(world, model)) return Error{{}, "needs a position model"};
  if (world.desc(model).position->drive == scene::Drive::kCar)
    return Error{{}, "needs drive \"diff\", \"omni\" or \"walk\": a car cannot turn in place"};
  std::vector<double> numbers;
  for (const std::string& word : post.arguments) {
    const std::optional<double> value = number(word);
    if (!value) return Error{{}, std::string(kUsage) + ", not " + in_quotes(word)};
    numbers.push_back(*value);
  }
  const bool has_speed = numbers.size() % 2 == 1;
  if (numbers.size() < 2) return Error{{}, kUsage};
  if (has_speed && numbers[0] <= 0) return Error{{}, std::string(kUsage) + ": a speed is more than 0"};
  std::vector<geom::Vec2> waypoints;
  for (std::size_t k = has_speed ? 1 : 0; k < numbers.size(); k += 2) {
    if (!world::is_place({numbers[k], numbers[k + 1], 0, 0}))
      return Error{{}, "a waypoint is out of the largest world"};
    waypoints.push_back({numbers[k], numbers[k + 1]});
  }
  world::subscribe_controller(world, model);
  robot_.push_back(position_of(world, model));
  speed_.push_back(has_speed ? numbers[0] : kSpeed);
  waypoints_.push_back(std::move(waypoints));
  next_.push_back(0);
  return {};
}

void Patrol::resolve(const world::World& world, std::size_t i) {
  robot_[i] = position_of(world, world.row(id(i)));
}

void Patrol::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const geom::Pose& X_WR = world.models.X_WM[world.positions.model[robot_[i]]];
    const std::vector<geom::Vec2>& waypoints = waypoints_[i];
    const double reach = std::max(kReached, speed_[i] * world.scene().interval);
    const auto offset = [&] {
      const geom::Vec2& to = waypoints[next_[i] % waypoints.size()];
      return geom::Vec2{to.x - X_WR.x, to.y - X_WR.y};
    };
    geom::Vec2 way = offset();
    const bool is_there = way.x * way.x + way.y * way.y <= reach * reach;
    if (is_there && waypoints.size() == 1) {
      drive(world, robot_[i], 0, 0);
      continue;
    }
    if (is_there) {
      next_[i] = static_cast<std::uint32_t>((next_[i] + 1) % waypoints.size());
      way = offset();
    }
    const double bearing = geom::normalize(geom::atan2(way.y, way.x) - X_WR.a);
    const double turn = std::clamp(kGain * bearing, -kMostTurn, kMostTurn);
    drive(world, robot_[i], std::fabs(bearing) < kAhead ? speed_[i] * geom::sincos(bearing).cos : 0, turn);
  }
}

}  // namespace playhouse::controllers
