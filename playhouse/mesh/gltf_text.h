#pragma once

/// What Assimp's reader of glTF files passes over: the extensions without which a file means something else.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::mesh {

/// The texts of a list at the top of a glTF file, text (.gltf) or binary (.glb); none where there is no such
/// list, and as many as can be read of one that is broken.
std::vector<std::string> gltf_list(std::string_view bytes, std::string_view key);

/// Fails on a file that requires an extension that is not read.
Result<void> check_gltf_extensions(std::string_view bytes);

}  // namespace playhouse::mesh
