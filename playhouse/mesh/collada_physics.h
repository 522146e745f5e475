#pragma once

#include <optional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// What a COLLADA file says for physics, in F: the shapes of all rigid bodies, where their instances are, as
/// one body. Nothing where it says nothing. Fails with a text that names no file.
Result<std::optional<Physics>> collada_physics(std::string_view bytes);

}  // namespace playhouse::mesh
