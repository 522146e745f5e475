#pragma once

/// Geometry of a gripper's paddles, for its body and its beams.

#include <algorithm>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// Distance of a paddle's inner face from the
/// centre line; `closed` from 0 to 1. [m, B]
inline double paddle_face(const GripperDesc& gripper, const geom::Size& size, double closed) {
  return (1 - closed) * std::max(0.0, 0.5 - gripper.paddle_width) * size.y;
}

}  // namespace playhouse::scene
