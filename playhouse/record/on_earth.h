#pragma once

/// Latitude, longitude and height of places near an origin, for messages of satellite receivers.
/// Source: WGS84; the fixed point of Heiskanen and Moritz, "Physical Geodesy", 1967, section 5-3.

#include "playhouse/geom/orientation.h"

namespace playhouse::record {

/// A place on the earth (WGS84).
struct GeodeticPosition {
  double latitude = 0, longitude = 0;  // rad, north and east positive
  double height = 0;                   // m above the ellipsoid
};

/// The place at p, metres to the east, to the north and up, in the tangent plane at `origin`.
GeodeticPosition on_earth(const GeodeticPosition& origin, const geom::Vec3& p);

}  // namespace playhouse::record
