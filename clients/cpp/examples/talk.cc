/// Broadcasts its position to other robots by radio every 0.5 s, and prints the messages it receives.
///     talk [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until
///     Ctrl-C)
/// Start one per robot that takes part: it only reads odometry, so another client can drive the robot.

#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "playhouse_client/opaque.h"
#include "playhouse_client/position2d.h"
#include "program.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr double kPeriod = 0.5;  // s, simulated

std::string report(unsigned index, const Pose& pose) {
  std::array<char, 128> text;
  std::snprintf(text.data(), text.size(), "robot %u is at %.2f %.2f", index, pose.x, pose.y);
  return text.data();
}

Result<void> talk(Client& client, std::uint16_t index, const example::Clock& clock, const std::vector<int>&) {
  auto robot = Position2d::open(client, index, Access::kRead);
  if (!robot) return robot.error();
  auto radio = Opaque::open(client, index);
  if (!radio) return radio.error();
  double next_time = 0;  // s
  for (;;) {
    const auto fresh = example::next_data(client, robot->device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return {};
    const std::optional<Position2d::State> state = robot->state();
    if (!state) continue;  // data of another device
    for (const std::string& message : radio->take_messages())
      std::printf("%.1f s: %s\n", state->time, message.c_str());
    std::fflush(stdout);
    if (state->time < next_time) continue;
    if (const auto sent = radio->send(report(index, state->pose)); !sent) return sent;
    next_time = state->time + kPeriod;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, talk);
}
