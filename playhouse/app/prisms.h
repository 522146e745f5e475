#pragma once

/// What a model looks like, as prisms: for pictures and meshes.

#include <vector>

#include "playhouse/geom/trapezoids.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// What is inside of an odd number of the loops, extruded in z. Solid is to the left of each loop. Frame M of
/// the model.
struct Prism {
  std::vector<std::vector<geom::Vec2>> loops;  // m
  double z_min = 0, z_max = 0;                 // m
};

/// A prism for each block of a body and for each bitmap.
std::vector<Prism> prisms_of(const scene::ModelDesc& desc);

/// The area of a prism in trapezoids.
std::vector<geom::Trapezoid> top_of(const Prism& prism);

}  // namespace playhouse::app
