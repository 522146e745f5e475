/// Wanders by laser scanner, avoiding obstacles.
///     wander [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)

#include <algorithm>
#include <optional>

#include "playhouse_client/laser.h"
#include "playhouse_client/position2d.h"
#include "program.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr double kSpeed = 0.4;  // m/s
constexpr double kTurn = 0.8;   // rad/s
constexpr double kFront = 0.5;  // rad to either side that the robot needs to pass
constexpr double kNear = 0.6;   // m

/// One control step for one scan; `turning` (rad/s) latches the turn until the way ahead is clear.
Result<void> step(Position2d& robot, const Scan& scan, double& turning) {
  const double ahead = scan.nearest(-kFront, kFront);
  const double left = scan.nearest(kFront, 1.5), right = scan.nearest(-1.5, -kFront);
  if (ahead < kNear) {
    if (turning == 0) turning = left > right ? kTurn : -kTurn;
    return robot.drive(0, turning);
  }
  turning = 0;
  const double sway = std::min(left, right) < kNear ? 0.5 * (left - right) : 0.0;
  return robot.drive(std::min(kSpeed, ahead - kNear + 0.1), std::clamp(sway, -kTurn, kTurn));
}

Result<void> wander(Client& client, std::uint16_t index, const example::Clock& clock,
                    const std::vector<int>&) {
  auto robot = Position2d::open(client, index);
  if (!robot) return robot.error();
  auto laser = Laser::open(client, index);
  if (!laser) return laser.error();
  double turning = 0;
  for (;;) {
    const auto fresh = example::next_data(client, laser->device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return robot->close();
    const std::optional<Scan> scan = laser->scan();
    if (!scan) continue;  // data of another device
    if (const auto driven = step(*robot, *scan, turning); !driven) return driven;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, wander);
}
