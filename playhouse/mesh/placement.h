#pragma once

#include "playhouse/geom/orientation.h"

namespace playhouse::mesh {

/// Place of a mesh file F in the body B of a model: p_B = R scale p_F + p.
struct Placement {
  geom::Vec3 p = {};          // m, of F's origin
  geom::Vec3 turn = {};       // rad, about the fixed axes x, y and z, in this order
  geom::Vec3 scale{1, 1, 1};  // along the axes of F; negative: mirrored
  bool is_fitted = true;      // the size of the model then decides about size and place
  friend bool operator==(const Placement&, const Placement&) = default;
};

}  // namespace playhouse::mesh
