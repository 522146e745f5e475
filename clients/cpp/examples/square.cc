/// Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
///     square [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "playhouse_client/position2d.h"
#include "program.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr double kSide = 1.5;      // m
constexpr double kReached = 0.03;  // m
constexpr double kAligned = 0.02;  // rad
constexpr double kSpeed = 0.4;     // m/s
constexpr double kTurn = 1.0;      // rad/s

double normalized(double angle) {
  return std::atan2(std::sin(angle), std::cos(angle));
}

double turn_for(double aside) {
  return std::clamp(2.0 * aside, -kTurn, kTurn);
}

/// Transforms a pose into the frame of `origin`.
Pose seen_from(const Pose& origin, const Pose& pose) {
  const double dx = pose.x - origin.x, dy = pose.y - origin.y;
  const double c = std::cos(origin.a), s = std::sin(origin.a);
  return {c * dx + s * dy, c * dy - s * dx, normalized(pose.a - origin.a)};
}

/// The odometry pose after the next data; none when the time is up.
Result<std::optional<Pose>> next_pose(Client& client, Position2d& robot, const example::Clock& clock) {
  for (;;) {
    const auto fresh = example::next_data(client, robot.device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return std::optional<Pose>();
    if (const auto state = robot.state()) return std::optional(state->pose);
  }
}

/// One control step towards a corner; false once it is reached.
Result<bool> approach(Position2d& robot, const Pose& here, const Point& corner) {
  const double ahead = corner.x - here.x, left = corner.y - here.y;
  const double distance = std::hypot(ahead, left);
  if (distance < kReached) {
    if (const auto stopped = robot.stop(); !stopped) return stopped.error();
    return false;
  }
  const double aside = normalized(std::atan2(left, ahead) - here.a);
  const double speed = std::abs(aside) > 0.15 ? 0.0 : std::clamp(distance, 0.05, kSpeed);
  const auto driven = robot.drive(speed, turn_for(aside));
  return driven ? Result<bool>(true) : driven.error();
}

Result<void> align(Client& client, Position2d& robot, double heading, const example::Clock& clock) {
  for (;;) {
    const auto pose = next_pose(client, robot, clock);
    if (!pose) return pose.error();
    if (!*pose) return {};
    const double aside = normalized(heading - (*pose)->a);
    if (std::abs(aside) < kAligned) return {};
    if (const auto driven = robot.drive(0, turn_for(aside)); !driven) return driven;
  }
}

Result<void> square(Client& client, std::uint16_t index, const example::Clock& clock,
                    const std::vector<int>&) {
  auto opened = Position2d::open(client, index);
  if (!opened) return opened.error();
  Position2d& robot = *opened;
  const auto first = next_pose(client, robot, clock);
  if (!first) return first.error();
  if (!*first) return {};
  const Pose start = **first;
  const std::array<Point, 4> corners = {{{kSide, 0}, {kSide, kSide}, {0, kSide}, {0, 0}}};
  for (std::size_t i = 0; i < corners.size();) {
    const auto pose = next_pose(client, robot, clock);
    if (!pose) return pose.error();
    if (!*pose) return {};
    const Pose here = seen_from(start, **pose);
    const auto on_the_way = approach(robot, here, corners[i]);
    if (!on_the_way) return on_the_way.error();
    if (!*on_the_way) std::printf("corner %zu at (%.2f, %.2f) m\n", ++i, here.x, here.y);
  }
  return align(client, robot, start.a, clock);
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, square);
}
