#pragma once

/// Ground detection below a wheel: a downward ray cast.
///
/// In: a vertical ray, and a body.
/// Out: the nearest footing so far.
/// Cost: a ray test of Bullet for each body.

#include "playhouse/arena/physics/bullet.h"
#include "playhouse/arena/physics/wheels.h"

namespace playhouse::arena {

inline constexpr double kWheelDrop = 0.1;  // m below a wheel that are searched for ground
inline constexpr double kOverlap = 0.01;   // m added to its step height: no gap from climbing to collision
inline constexpr double kUpright = 0.3;    // cosine of the steepest slope that carries a wheel

/// A vertical ray through a wheel that hits bodies from above.
struct WheelRay {
  btVector3 top, bottom;
  double rise = 0;  // m from the wheel up to the ray's top

  /// Tests a body; if its hit is nearer than that of `footing`, replaces it and returns true.
  bool meet(btRigidBody& body, Footing& footing) const;
};

}  // namespace playhouse::arena
