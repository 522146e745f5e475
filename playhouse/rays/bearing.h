#pragma once

/// Bearings for culling, faster than exact ones.
///
/// In: a vector.
/// Out: its bearing. [rad]
/// Cost: a division and some products.

#include <cmath>
#include <initializer_list>

#include "playhouse/geom/pose.h"

namespace playhouse::rays {

/// Error bound of rough_bearing(); the test in scan_test.cc checks a tighter one.  [rad]
inline constexpr double kBearingError = 1e-4;

/// The bearing of v, in [-pi, pi], to within kBearingError and at a fraction of the cost of geom::atan2.
/// Source: a polynomial in odd powers fitted to atan on [0, 1], error 2e-6 there.
inline double rough_bearing(geom::Vec2 v) {
  const double ax = std::fabs(v.x), ay = std::fabs(v.y);
  const double large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  const double t = large > 0 ? small / large : 0, s = t * t;
  double angle = -0.01172120;
  for (const double c : {0.05265332, -0.11643287, 0.19354346, -0.33262347, 0.99997726}) angle = angle * s + c;
  angle *= t;
  angle = ay > ax ? 0.5 * geom::kPi - angle : angle;
  angle = v.x < 0 ? geom::kPi - angle : angle;
  return v.y < 0 ? -angle : angle;
}

}  // namespace playhouse::rays
