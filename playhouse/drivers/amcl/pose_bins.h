#pragma once

/// Bins of poses: 0.5 m along x and y, 10 degrees.

#include <cstdint>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

inline constexpr double kBinSide = 0.5;  // m
inline constexpr int kBinsOfCircle = 36;

/// Number of a bin; places farther than 6,000 km from the origin share those at the edge.
std::uint64_t bin_of(const geom::Pose& pose);

/// The bin so many steps away along x, y and, around the circle, the heading.
std::uint64_t neighbour_of(std::uint64_t bin, int dx, int dy, int da);

}  // namespace playhouse::drivers
