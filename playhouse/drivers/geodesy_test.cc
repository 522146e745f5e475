// Places on the earth: against published coordinates, and against the ellipsoid itself.

#include "playhouse/drivers/geodesy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

Geodetic at(double latitude, double longitude, double height = 0) {
  return {geom::radians(latitude), geom::radians(longitude), height};
}

TEST(Geodesy, has_the_utm_coordinates_that_are_published) {
  // As in the documentation and the tests of the Python package utm (Bieniek), some to the metre.
  const struct {
    double latitude, longitude, easting, northing;
    int zone;
    double error;
  } kPlaces[] = {
      {51.2, 7.5, 395201.3103811303, 5673135.241182375, 32, 1e-3},  //
      {50.77535, 6.08389, 294409, 5628898, 32, 1},                  // Aachen
      {40.71435, -74.00597, 583960, 4507523, 18, 1},                // New York
      {-41.28646, 174.77624, 313784, 5427057, -60, 1},              // Wellington
      {-33.92487, 18.42406, 261878, 6243186, -34, 1},               // Cape Town
      {-32.89018, -68.84405, 514586, 6360877, -19, 1},              // Mendoza
  };
  for (const auto& place : kPlaces) {
    const Utm utm = utm_of(at(place.latitude, place.longitude));
    EXPECT_EQ(utm.zone, place.zone) << place.latitude;
    EXPECT_NEAR(utm.easting, place.easting, place.error) << place.latitude;
    EXPECT_NEAR(utm.northing, place.northing, place.error) << place.latitude;
  }
}

TEST(Geodesy, on_the_equator_and_a_central_meridian_utm_is_as_its_definition_says) {
  const Utm utm = utm_of(at(0, 3));
  EXPECT_EQ(utm.zone, 31);
  EXPECT_NEAR(utm.easting, 500000, 1e-6);
  EXPECT_NEAR(utm.northing, 0, 1e-6);
  // The quarter of a meridian is 10001965.729 m long (WGS84).
  EXPECT_NEAR(utm_of(at(89.99999999, 3)).northing, 0.9996 * 10001965.729, 0.02);
  for (const double degrees : {-180.0, -179.9, 179.9, 180.0, 90.0, -90.0}) {
    const Utm edge = utm_of(at(degrees / 2, degrees));
    EXPECT_TRUE(std::isfinite(edge.easting) && std::isfinite(edge.northing)) << degrees;
    EXPECT_GE(std::abs(edge.zone), 1);
    EXPECT_LE(std::abs(edge.zone), 60);
  }
}

TEST(Geodesy, a_plane_touches_the_earth_at_its_origin) {
  for (const double latitude : {-89.0, -33.9, 0.0, 12.5, 50.8, 78.2})
    for (const double longitude : {-179.5, -70.0, 0.0, 6.1, 151.2}) {
      const Geodetic origin = at(latitude, longitude, 123);
      const Geodetic here = place_on_earth(origin, 0, 0, 0), above = place_on_earth(origin, 0, 0, 500);
      EXPECT_NEAR(here.latitude, origin.latitude, 1e-13);
      EXPECT_NEAR(here.longitude, origin.longitude, 1e-13);
      EXPECT_NEAR(here.height, 123, 1e-7);
      EXPECT_NEAR(above.latitude, origin.latitude, 1e-13);
      EXPECT_NEAR(above.height, 623, 1e-7);
    }
}

TEST(Geodesy, metres_are_metres_along_the_meridian_and_across_it) {
  constexpr double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
  const double latitude = geom::radians(50.0), s = std::sin(latitude), root = std::sqrt(1 - e2 * s * s);
  const double along = a * (1 - e2) / (root * root * root), across = a / root;
  const Geodetic origin{latitude, 0.1, 0};
  const Geodetic north = place_on_earth(origin, 0, 100, 0), east = place_on_earth(origin, 100, 0, 0);
  EXPECT_NEAR((north.latitude - latitude) * along, 100, 1e-3);
  EXPECT_NEAR((east.longitude - 0.1) * across * std::cos(latitude), 100, 1e-3);
  EXPECT_NEAR(north.height, 100 * 100 / (2 * along), 1e-6) << "the plane leaves the ellipsoid";
}

}  // namespace
}  // namespace playhouse::drivers
