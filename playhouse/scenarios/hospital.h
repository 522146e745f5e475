#pragma once

/// Procedural buildings of identical wards for any number of
/// robots: rooms on both sides of a corridor. Pure functions.

#include <cstddef>
#include <string>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::scenarios {

/// Numbers of wards side by side along a corridor, and of corridors.
struct Wards {
  std::size_t columns = 1, rows = 1;
};

inline constexpr double kWardWidth = 4, kWardDepth = 12;  // m: two rooms and the corridor

/// 12 robots per ward of 4 m x 12 m, 0.25 per square metre, in a roughly square building.
Wards wards_for(std::size_t robots);

/// Centres of the wards, around the origin.
std::vector<geom::Pose> places_of(const Wards& wards);

/// World file text of the ends of all corridors and of one ward, "room".
std::string walls_of(const Wards& wards);

/// `robots` poses in rooms and corridors, at least 0.6
/// m apart and 0.2 m from walls. Needs enough wards.
std::vector<geom::Pose> in_wards(std::size_t robots, const Wards& wards);

}  // namespace playhouse::scenarios
