#pragma once

/// What Assimp's reader of OBJ files does not tell: which materials have a color of their own, and which
/// files of materials are missing.

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::mesh {

struct ObjText {
  std::set<std::string> colored;     // names of materials with a Kd
  std::vector<std::string> missing;  // files of materials, as the file names them
};

/// The bytes of a file beside the mesh; null: it is not there.
using FindFile = std::function<const std::string*(std::string_view name)>;

/// Of the bytes of an OBJ file with this name. A file of materials that is missing is looked for by the name
/// of the OBJ file, as Assimp does.
ObjText look_at_obj(std::string_view name, std::string_view bytes, const FindFile& find);

}  // namespace playhouse::mesh
