#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace playhouse::mesh {

/// Candidate paths, relative to the folder of the mesh, for a file that a mesh
/// refers to: as named, and without folders. Sandboxed: no absolute paths, no "..".
std::vector<std::string> places_beside(std::string_view name);

}  // namespace playhouse::mesh
