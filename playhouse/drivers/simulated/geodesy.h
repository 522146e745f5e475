#pragma once

/// Between a plane that touches the earth, latitudes and longitudes, and the grid of UTM.
///
/// In: metres to the east, to the north and upwards of a point on the ellipsoid WGS84.
///
/// Out: latitude, longitude and height; easting and northing.
///
/// Cost: a microsecond.
///
/// Source: Bowring, "Transformation from spatial to geographical coordinates", Survey Review 1976, iterated;
/// Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 2011, equations 7 to 11
/// and 35.

namespace playhouse::drivers {

/// A place on the earth, by WGS84.
struct Geodetic {
  double latitude = 0, longitude = 0;  // rad, positive to the north and to the east
  double height = 0;                   // m above the ellipsoid
};

/// A place on the grid of UTM.
struct Utm {
  int zone = 0;                      // 1 to 60; below 0 on the southern half of the earth
  double easting = 0, northing = 0;  // m, with the false origins of the zone
};

/// The place that is so far to the east, to the north and upwards of `origin`, along the plane there. [m]
Geodetic place_on_earth(const Geodetic& origin, double east, double north, double up);

/// Zones are those of longitudes alone, also in Norway and Svalbard.
Utm utm_of(const Geodetic& place);

}  // namespace playhouse::drivers
