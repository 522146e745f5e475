/// Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
///     navigate [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is
///     done)

#include <cstdio>

#include "playhouse_client/planner.h"
#include "program.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr Pose kPlaces[] = {{6.0, 4.0, 1.5}, {-5.8, 5.0, 3.0}};  // m, m, rad

/// Drives to a place; false when the time is up.
Result<bool> visit(Client& client, Planner& planner, const Pose& place, const example::Clock& clock) {
  if (const auto sent = planner.go_to(place); !sent) return sent.error();
  while (!planner.arrived()) {
    const auto fresh = example::next_data(client, planner.device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return false;
  }
  const Pose pose = planner.state()->pose;
  std::printf("arrived at (%.2f, %.2f) m\n", pose.x, pose.y);
  std::fflush(stdout);
  return true;
}

Result<void> navigate(Client& client, std::uint16_t index, const example::Clock& clock,
                      const std::vector<int>&) {
  auto planner = Planner::open(client, index);
  if (!planner) return planner.error();
  for (const Pose& place : kPlaces) {
    const auto visited = visit(client, *planner, place, clock);
    if (!visited) return visited.error();
    if (!*visited) break;
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, navigate);
}
