#pragma once

/// Where a robot can drive, by what its scanner sees.

#include <optional>
#include <span>

namespace playhouse::controllers {

/// Bearings of the beams of a scan in the frame of the robot, from right to left. [rad]
struct Fan {
  double first = 0, step = 0;
};

/// The way that a scan leaves: one that is free for a robot half as wide as `half_width`.
struct FreeWay {
  double bearing = 0;  // rad, in the robot's frame
  double ahead = 0;    // m, that are free straight ahead
};

/// Among bearings up to a quarter of a turn to either side that nearest to `wanted`, with some preference for
/// straight ahead; none where nothing is free for 0.8 m. A scan is taken from the robot's middle. [m, rad]
std::optional<FreeWay> free_way(std::span<const float> ranges, const Fan& fan, double half_width,
                                double wanted);

}  // namespace playhouse::controllers
