#pragma once

/// STL files, which come in two forms that no mark tells apart, as the plain binary
/// one: 80 zeros, a count, and triangles without colours. So nothing that reads it
/// has to guess, and no number of a file is believed.

#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::mesh {

bool is_stl(std::string_view path);

/// The triangles of a binary or ASCII STL file, with zero normals: most files have those
/// or wrong ones. Fails on truncated files. Errors do not include a file name.
Result<std::string> plain_stl(std::string_view bytes);

}  // namespace playhouse::mesh
