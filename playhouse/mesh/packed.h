#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// Serialisation of a mesh between two processes of this program.
std::vector<std::byte> packed(const MeshFile& file);
/// None on invalid bytes.
std::optional<MeshFile> unpacked(std::span<const std::byte> bytes);

}  // namespace playhouse::mesh
