#pragma once

#include <string>
#include <string_view>

#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// What Assimp reads of a file: surfaces, materials, textures and lights, in F, not checked yet. Fails with
/// a text that names no file.
Result<MeshFile> import(const std::string& path, std::string_view bytes, const ReadFile& read);

bool is_collada(std::string_view path);

}  // namespace playhouse::mesh
