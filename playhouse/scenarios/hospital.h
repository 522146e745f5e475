#pragma once

/// A building of wards for any number of robots, each ward as the others: rooms on both sides of a corridor.
/// Pure functions.

#include <string>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::scenarios {

/// Wards of a building, side by side along a corridor, and the corridors.
struct Wards {
  std::size_t columns = 1, rows = 1;
};

inline constexpr double kWardWidth = 4, kWardDepth = 12;  // m: two rooms with the corridor between them

/// 12 robots for each ward of 4 m x 12 m, 0.25 per square metre, in a building that is about square.
Wards wards_for(std::size_t robots);

/// Their middles, about the origin.
std::vector<geom::Pose> places_of(const Wards& wards);

/// The ends of all corridors and one ward, "room", as text of a world file.
std::string walls_of(const Wards& wards);

/// `robots` poses in rooms and corridors, at least 0.6 m from each other and 0.2 m from walls. Needs wards
/// that are enough for them.
std::vector<geom::Pose> in_wards(std::size_t robots, const Wards& wards);

}  // namespace playhouse::scenarios
