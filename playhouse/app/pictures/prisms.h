#pragma once

/// Shape of a model as prisms, for pictures and meshes.

#include <vector>

#include "playhouse/geom/trapezoids.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// The even-odd inside of loops, extruded in z. The solid
/// side is on the left of each loop. Frame M of the model.
struct Extrusion {
  std::vector<std::vector<geom::Vec2>> loops;  // m
  double z_min = 0, z_max = 0;                 // m
};

/// A prism for each block of a body and for each bitmap.
std::vector<Extrusion> prisms_of(const scene::ModelDesc& desc);

/// The base area of a prism as trapezoids.
std::vector<geom::Trapezoid> top_of(const Extrusion& prism);

}  // namespace playhouse::app
