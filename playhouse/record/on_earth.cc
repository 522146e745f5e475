#include "playhouse/record/on_earth.h"

#include <cmath>

namespace playhouse::record {
namespace {

// WGS84: equatorial radius [m], and eccentricity squared.
constexpr double kRadius = 6378137.0, kFlattening = 1 / 298.257223563;
constexpr double kSquared = kFlattening * (2 - kFlattening);

/// Radius of curvature in the prime vertical. [m]
double across(double latitude) {
  const double s = std::sin(latitude);
  return kRadius / std::sqrt(1 - kSquared * s * s);
}

}  // namespace

GeodeticPosition on_earth(const GeodeticPosition& origin, const geom::Vec3& p) {
  const double s = std::sin(origin.latitude), c = std::cos(origin.latitude), n = across(origin.latitude);
  // Earth-centred: along the origin's meridian, to its east, and to the north pole.
  const double ahead = (n + origin.height) * c - s * p.y + c * p.z;
  const double north = (n * (1 - kSquared) + origin.height) * s + c * p.y + s * p.z;
  const double level = std::hypot(ahead, p.x);
  constexpr int kRounds = 8;  // each adds two digits near the surface
  double latitude = origin.latitude;
  for (int round = 0; round < kRounds; ++round)
    latitude = std::atan2(north + kSquared * across(latitude) * std::sin(latitude), level);
  const double sine = std::sin(latitude);
  const double height =
      level * std::cos(latitude) + north * sine - kRadius * std::sqrt(1 - kSquared * sine * sine);
  return {latitude, geom::normalize(origin.longitude + std::atan2(p.x, ahead)), height};
}

}  // namespace playhouse::record
