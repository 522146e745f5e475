#pragma once

/// Conversion between a local tangent plane, geodetic coordinates and UTM.
///
/// In: metres east, north and up from a point on the WGS84 ellipsoid.
///
/// Out: latitude, longitude and height; easting and northing.
///
/// Cost: a microsecond.
///
/// Source: Bowring, "Transformation from spatial to geographical coordinates", Survey Review 1976, iterated;
/// Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 2011, equations 7 to 11
/// and 35.

namespace playhouse::drivers {

/// A position in geodetic coordinates (WGS84).
struct Geodetic {
  double latitude = 0, longitude = 0;  // rad, north and east positive
  double height = 0;                   // m above the ellipsoid
};

/// A position in UTM coordinates.
struct Utm {
  int zone = 0;                      // 1 to 60; negative on the southern hemisphere
  double easting = 0, northing = 0;  // m, with the false origins of the zone
};

/// The position at this offset from `origin` in its tangent plane. [m]
Geodetic place_on_earth(const Geodetic& origin, double east, double north, double up);

/// Zones by longitude only: without the exceptions for Norway and Svalbard.
Utm utm_of(const Geodetic& place);

}  // namespace playhouse::drivers
