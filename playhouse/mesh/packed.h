#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// A mesh as bytes, from one process of this program to another.
std::vector<std::byte> packed(const MeshFile& file);
/// Nothing for bytes that are none.
std::optional<MeshFile> unpacked(std::span<const std::byte> bytes);

}  // namespace playhouse::mesh
