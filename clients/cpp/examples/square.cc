/// Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
///     square [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

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

/// The same place in the frame of `origin`.
wire::Pose2d seen_from(const wire::Pose2d& origin, const wire::Pose2d& pose) {
  const double dx = pose.px - origin.px, dy = pose.py - origin.py;
  const double c = std::cos(origin.pa), s = std::sin(origin.pa);
  return {c * dx + s * dy, c * dy - s * dx, normalized(pose.pa - origin.pa)};
}

/// One step towards a corner, or false when it is reached.
Result<bool> approach(Position2d& robot, const wire::Pose2d& here, const wire::Point2d& corner) {
  const double ahead = corner.px - here.px, left = corner.py - here.py;
  const double distance = std::hypot(ahead, left);
  if (distance < kReached) {
    if (const auto stopped = robot.stop(); !stopped) return stopped.error();
    return false;
  }
  const double aside = normalized(std::atan2(left, ahead) - here.pa);
  const double speed = std::abs(aside) > 0.15 ? 0.0 : std::clamp(distance, 0.05, kSpeed);
  const auto driven = robot.drive(speed, turn_for(aside));
  return driven ? Result<bool>(true) : driven.error();
}

Result<void> align(Client& client, Position2d& robot, double heading, const example::Clock& clock) {
  for (;;) {
    const auto fresh = example::next_data(client, robot.device(), clock);
    if (!fresh) return fresh.error();
    const double aside = normalized(heading - robot.state().pose.pa);
    if (!*fresh || std::abs(aside) < kAligned) return {};
    if (const auto driven = robot.drive(0, turn_for(aside)); !driven) return driven;
  }
}

Result<void> square(Client& client, std::uint16_t index, const example::Clock& clock,
                    const std::vector<int>&) {
  auto opened = Position2d::open(client, index);
  if (!opened) return opened.error();
  Position2d& robot = *opened;
  if (const auto fresh = example::next_data(client, robot.device(), clock); !fresh) return fresh.error();
  const wire::Pose2d start = robot.state().pose;
  const std::array<wire::Point2d, 4> corners = {{{kSide, 0}, {kSide, kSide}, {0, kSide}, {0, 0}}};
  for (std::size_t i = 0; i < corners.size();) {
    const auto fresh = example::next_data(client, robot.device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return {};
    const wire::Pose2d here = seen_from(start, robot.state().pose);
    const auto on_the_way = approach(robot, here, corners[i]);
    if (!on_the_way) return on_the_way.error();
    if (!*on_the_way) std::printf("corner %zu at (%.2f, %.2f) m\n", ++i, here.px, here.py);
  }
  return align(client, robot, start.pa, clock);
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, square);
}
