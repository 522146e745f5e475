#pragma once

/// Triangles: surfaces of bodies, for ray casts.
///
/// In: outlines, and the heights between which they are extruded.
/// Out: triangles of sides, top and bottom.
/// Cost: that of geom::trapezoids() for top and bottom, two triangles for each edge.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/geom/trapezoids.h"

namespace playhouse::arena {

struct Triangles {
  std::vector<geom::Vec3> p;                         // corners  [m, in the frame of the owner]
  std::vector<std::array<std::uint32_t, 3>> corner;  // rows of p; counter-clockwise seen from outside
  bool empty() const { return corner.empty(); }
};

/// Appends the surface of a prism from z_low to z_high whose base is the even-odd inside of the outlines
/// (solid on their left): sides, and top and bottom unless its height is 0. Cost: that of geom::trapezoids().
void add_extrusion(Triangles& triangles, std::span<const geom::Outline> outlines, double z_low,
                   double z_high);

}  // namespace playhouse::arena
