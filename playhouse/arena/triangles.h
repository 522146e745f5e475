#pragma once

/// Triangles: surfaces of bodies, for rays.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/geom/trapezoids.h"

namespace playhouse::arena {

struct Triangles {
  std::vector<geom::Vec3> p;                         // corners  [m, in the frame of whatever has them]
  std::vector<std::array<std::uint32_t, 3>> corner;  // rows of p; counter-clockwise seen from outside
  bool empty() const { return corner.empty(); }
};

/// Adds the surface of what is inside an odd number of the outlines, which is to the left of them, from z_low
/// to z_high: its sides, and its top and bottom unless it has no height. Cost: that of geom::trapezoids().
void add_extrusion(Triangles& triangles, std::span<const geom::Outline> outlines, double z_low,
                   double z_high);

}  // namespace playhouse::arena
