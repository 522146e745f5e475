#pragma once

#include <string>
#include <string_view>

#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// Imports a file by Assimp: surfaces, materials, textures and
/// lights, in F, not validated. Errors do not include a file name.
Result<MeshFile> import(const std::string& path, std::string_view bytes, const ReadFile& read);

bool is_collada(std::string_view path);

}  // namespace playhouse::mesh
