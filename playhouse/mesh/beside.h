#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace playhouse::mesh {

/// Where a file may be that a mesh names, as paths from the folder of the mesh: as it is named, and without
/// its folders. Never outside of that folder, whatever a mesh says: no absolute path, no "..".
std::vector<std::string> places_beside(std::string_view name);

}  // namespace playhouse::mesh
