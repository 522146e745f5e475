// Places on the earth: against the definition of the ellipsoid, in the other direction.

#include "playhouse/record/on_earth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace playhouse::record {
namespace {

/// Earth-centred: x to longitude 0, z to the north pole. [m]
geom::Vec3 spatial(const GeodeticPosition& at) {
  constexpr double kRadius = 6378137.0, kFlattening = 1 / 298.257223563;
  constexpr double kSquared = kFlattening * (2 - kFlattening);
  const double s = std::sin(at.latitude), n = kRadius / std::sqrt(1 - kSquared * s * s);
  const double level = (n + at.height) * std::cos(at.latitude);
  return {level * std::cos(at.longitude), level * std::sin(at.longitude),
          (n * (1 - kSquared) + at.height) * s};
}

TEST(OnEarth, is_where_the_tangent_plane_of_its_origin_is) {
  for (const double latitude : {-89.0, -33.9, 0.0, 47.5, 89.9})
    for (const double longitude : {-179.9999, 0.0, 8.5, 180.0})
      for (const geom::Vec3& p : {geom::Vec3{0, 0, 0}, {30, -20, 4}, {-2000, 5000, 900}, {10, 60, -400}}) {
        const GeodeticPosition origin{geom::radians(latitude), geom::radians(longitude), 408};
        const double sp = std::sin(origin.latitude), cp = std::cos(origin.latitude);
        const double sl = std::sin(origin.longitude), cl = std::cos(origin.longitude);
        const geom::Vec3 east{-sl, cl, 0}, north{-sp * cl, -sp * sl, cp}, up{cp * cl, cp * sl, sp};
        const geom::Vec3 wanted = spatial(origin) + p.x * east + p.y * north + p.z * up;
        const geom::Vec3 error = spatial(on_earth(origin, p)) - wanted;
        EXPECT_LT(std::sqrt(dot(error, error)), 1e-6) << latitude << " " << longitude << " " << p.y;
      }
}

}  // namespace
}  // namespace playhouse::record
