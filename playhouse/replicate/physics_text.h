#pragma once

#include <cstddef>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/world/physics_shapes.h"

namespace playhouse::replicate {

/// Corners that a viewer is told of at most: a text of about ten megabytes.
inline constexpr std::size_t kPhysicsCorners = 400'000;

/// What physics takes bodies for, as JSON text for a viewer (docs/viewer-protocol.md). Fails where there are
/// more corners than that.
Result<std::string> physics_text(const world::PhysicsShapes& shapes);

}  // namespace playhouse::replicate
