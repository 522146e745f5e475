#pragma once

/// Checks that Assimp's glTF reader omits: required extensions, and nodes of several parents.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::mesh {

/// The strings of a top-level array of a glTF file, text (.gltf) or binary
/// (.glb); empty if there is none; of malformed JSON as many as can be read.
std::vector<std::string> gltf_list(std::string_view bytes, std::string_view key);

/// Fails on a file that requires an unsupported extension.
Result<void> check_gltf_extensions(std::string_view bytes);

/// Fails on a scene of too many nodes, each counted once for every path to it: Assimp makes as many.
Result<void> check_gltf_nodes(std::string_view bytes);

}  // namespace playhouse::mesh
