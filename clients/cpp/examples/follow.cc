/// Follows a marker at a distance of 1 m.
///     follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]
/// Robot INDEX (0), for SECONDS (0: until Ctrl-C), follows the marker with id MARKER (default: the nearest of
/// any id) as seen by fiducial FINDER (INDEX).

#include <algorithm>
#include <cmath>
#include <optional>

#include "playhouse_client/fiducial.h"
#include "playhouse_client/position2d.h"
#include "program.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr double kDistance = 1.0;  // m
constexpr double kSpeed = 0.5;     // m/s
constexpr double kTurn = 1.0;      // rad/s

/// The nearest marker with the wanted id.
std::optional<Marker> choose(const std::vector<Marker>& markers, std::optional<int> wanted) {
  std::optional<Marker> nearest;
  for (const Marker& marker : markers) {
    if (wanted && marker.id != *wanted) continue;
    if (!nearest || marker.distance() < nearest->distance()) nearest = marker;
  }
  return nearest;
}

Result<void> step(Position2d& robot, const Marker& marker) {
  const double bearing = marker.bearing();
  const double speed = std::clamp(marker.distance() - kDistance, -kSpeed, kSpeed);
  return robot.drive(std::abs(bearing) < 1.0 ? speed : 0.0, std::clamp(2.0 * bearing, -kTurn, kTurn));
}

Result<void> follow(Client& client, std::uint16_t index, const example::Clock& clock,
                    const std::vector<int>& more) {
  std::optional<int> wanted;
  if (!more.empty()) wanted = more[0];
  auto robot = Position2d::open(client, index);
  if (!robot) return robot.error();
  auto finder = Fiducial::open(client, more.size() > 1 ? static_cast<std::uint16_t>(more[1]) : index);
  if (!finder) return finder.error();
  bool lost_to_the_left = true;
  for (;;) {
    const auto fresh = example::next_data(client, finder->device(), clock);
    if (!fresh) return fresh.error();
    if (!*fresh) return robot->close();
    const auto marker = choose(finder->markers(), wanted);
    if (marker) lost_to_the_left = marker->pose.y > 0;
    // Marker lost: search, turning first to the side where it was last seen.
    const auto driven =
        marker ? step(*robot, *marker) : robot->drive(0, lost_to_the_left ? kTurn / 2 : -kTurn / 2);
    if (!driven) return driven;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return example::run(argc, argv, follow);
}
