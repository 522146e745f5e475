#pragma once

/// Free space for a robot, from its scan.

#include <optional>
#include <span>

namespace playhouse::controllers {

/// Bearings of a scan's beams in the robot's frame, from right to left. [rad]
struct Fan {
  double first = 0, step = 0;
};

/// A direction that is free for a robot of this half width.
struct FreeWay {
  double bearing = 0;  // rad, in the robot's frame
  double ahead = 0;    // m, free distance straight ahead
};

/// The free direction nearest to `wanted` within a quarter turn to either side, biased towards straight
/// ahead; none if nothing is free for 0.8 m. The scan must originate at the robot's centre. [m, rad]
std::optional<FreeWay> free_way(std::span<const float> ranges, const Fan& fan, double half_width,
                                double wanted);

}  // namespace playhouse::controllers
