#pragma once

#include <optional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// The physics of a COLLADA file, in F: shapes of all rigid bodies, at their instances,
/// merged to one body. None if there is no physics. Errors do not include a file name.
Result<std::optional<PhysicalProperties>> collada_physics(std::string_view bytes);

}  // namespace playhouse::mesh
