#pragma once

/// Pre-scan of OBJ files for what Assimp's reader does not report: which
/// materials define a color, and which material files are missing.

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::mesh {

struct ObjText {
  std::set<std::string> colored;     // materials with a Kd
  std::vector<std::string> missing;  // material files, as named in the file
};

/// Bytes of a file beside the mesh; null if it does not exist.
using FindFile = std::function<const std::string*(std::string_view name)>;

/// Scans an OBJ file with this name. Like Assimp, falls
/// back to a material file named after the OBJ file.
ObjText look_at_obj(std::string_view name, std::string_view bytes, const FindFile& find);

}  // namespace playhouse::mesh
