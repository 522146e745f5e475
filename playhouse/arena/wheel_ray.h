#pragma once

/// What is below a wheel: a ray downwards.

#include "playhouse/arena/bullet.h"
#include "playhouse/arena/wheels.h"

namespace playhouse::arena {

inline constexpr double kWheelDrop = 0.1;  // m below a wheel to where the ground is looked for
inline constexpr double kOverlap = 0.01;   // m that it climbs beyond its body: no step is in between
inline constexpr double kUpright = 0.3;    // cosine of the steepest slope that bears a wheel

/// Where a ray from a wheel downwards meets a body from above.
struct WheelRay {
  btVector3 top, bottom;
  double rise = 0;  // m of it above the wheel

  /// Whether it is nearer than what `footing` has; then it has that.
  bool meet(btRigidBody& body, Footing& footing) const;
};

}  // namespace playhouse::arena
