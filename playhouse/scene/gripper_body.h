#pragma once

/// Where the paddles of a gripper are, for its body and for its beams.

#include <algorithm>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// How far from the middle, to each side, the inner face of a paddle is that is closed so far, from 0 to 1.
/// [m, B]
inline double paddle_face(const GripperDesc& gripper, const geom::Size& size, double closed) {
  return (1 - closed) * std::max(0.0, 0.5 - gripper.paddle_width) * size.y;
}

}  // namespace playhouse::scene
