#pragma once

#include <cstddef>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/world/physics_shapes.h"

namespace playhouse::replicate {

/// Limit on corners sent to a viewer: about ten megabytes of text.
inline constexpr std::size_t kPhysicsCorners = 400'000;

/// Collision shapes as JSON text for a viewer (docs/viewer-protocol.md).
/// Fails if there are more corners than that.
Result<std::string> physics_text(const world::PhysicsShapes& shapes);

}  // namespace playhouse::replicate
